# What every target of the project has in common.

function(quadloom_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(
    ${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  # A fused multiply-add rounds once where the proofs of the predicates count two roundings.
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           $<$<BOOL:${QUADLOOM_WERROR}>:-Werror>)
  if(QUADLOOM_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${QUADLOOM_SANITIZE} -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${QUADLOOM_SANITIZE})
  endif()
endfunction()
