# Install rules and the package that find_package(armlet) finds. Components: core, runtime, interpreter, stdlib, command.
include(CMakePackageConfigHelpers)
set(ARMLET_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/armlet)

install(TARGETS armlet_core armlet_runtime armlet_interpreter armlet_stdlib
  EXPORT armlet-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(part runtime interpreter stdlib)
  install(DIRECTORY ${part}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h" PATTERN "*.def")
endforeach()
install(EXPORT armlet-targets NAMESPACE armlet:: DESTINATION ${ARMLET_PACKAGE_DIR})

configure_package_config_file(cmake/armlet-config.cmake.in ${PROJECT_BINARY_DIR}/armlet-config.cmake
  INSTALL_DESTINATION ${ARMLET_PACKAGE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/armlet-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/armlet-config.cmake ${PROJECT_BINARY_DIR}/armlet-config-version.cmake
  DESTINATION ${ARMLET_PACKAGE_DIR})

install(TARGETS armlet armlet-lab EXPORT armlet-targets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# What `armlet lab --export` needs, if `./dev wasm` has made it: as it is when it is installed.
install(FILES ${PROJECT_SOURCE_DIR}/build/wasm/laboratory.html DESTINATION ${CMAKE_INSTALL_DATADIR}/armlet COMPONENT laboratory OPTIONAL)
install(FILES docs/armlet.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
