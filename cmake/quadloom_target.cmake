# What every target of the project has in common.

function(quadloom_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(
    ${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  get_target_property(type ${target} TYPE)
  if(type MATCHES "LIBRARY")
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  endif()
  # A fused multiply-add rounds once where the proofs of the predicates count two roundings.
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion $<$<BOOL:${QUADLOOM_WERROR}>:-Werror>)
  if(QUADLOOM_SANITIZE)
    # A shape that divides by zero is an infinity that ranks last: defined by IEEE 754.
    target_compile_options(
      ${target} PRIVATE -fsanitize=${QUADLOOM_SANITIZE} -fno-sanitize=float-divide-by-zero
                        -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${QUADLOOM_SANITIZE})
  endif()
endfunction()
