# cmake -DMODE=installed|embedded -DSOURCE=... -DBUILD=... -DWORK=... -DCOMPILER=... -P check.cmake
# Builds and runs the consumer project against an installation of BUILD in a temporary prefix, or
# with the source tree embedded.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(options -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O0)
file(REMOVE_RECURSE ${WORK})
if(MODE STREQUAL "installed")
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
  list(APPEND options -DCMAKE_PREFIX_PATH=${WORK}/prefix)
else()
  list(APPEND options -DCONSUMER_EMBEDS=${SOURCE})
  # What the core library can do without.
  list(APPEND options -DQUADLOOM_THREADS=OFF)
  foreach(package TBB fmt nlohmann_json pugixml ZLIB PkgConfig CLI11 GTest)
    list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  endforeach()
endif()

run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${WORK}/build -G Ninja ${options})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
if(MODE STREQUAL "installed")
  run(${WORK}/build/consumer_io)
endif()
