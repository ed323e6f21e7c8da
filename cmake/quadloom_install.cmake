# Install rules. find_package(quadloom) gives quadloom::quadloom and, where it was built,
# quadloom::io, each from its own export file, so that the core can be had without io's dependencies.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/quadloom)

install(DIRECTORY include/quadloom ${PROJECT_BINARY_DIR}/include/quadloom
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp" PATTERN "io.hpp" EXCLUDE)
install(TARGETS quadloom EXPORT quadloom_targets)
install(EXPORT quadloom_targets NAMESPACE quadloom:: DESTINATION ${package_dir})

if(QUADLOOM_BUILD_IO)
  install(FILES include/quadloom/io.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/quadloom)
  install(TARGETS quadloom_io EXPORT quadloom_io_targets)
  install(EXPORT quadloom_io_targets NAMESPACE quadloom:: DESTINATION ${package_dir})
endif()

configure_package_config_file(cmake/quadloomConfig.cmake.in quadloomConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(quadloomConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/quadloomConfig.cmake ${PROJECT_BINARY_DIR}/quadloomConfigVersion.cmake
        DESTINATION ${package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
