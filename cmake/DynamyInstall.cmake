# Install rules and the package that find_package(dynamy) reads.
include(CMakePackageConfigHelpers)
set(package_dir lib/cmake/dynamy)

install(TARGETS dynamy_framework dynamy_elements_headers EXPORT dynamyTargets
  LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/framework/dynamy DESTINATION include
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/elements/dynamy_elements DESTINATION include OPTIONAL
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION share/dynamy OPTIONAL
  FILES_MATCHING PATTERN "*.xml")
install(EXPORT dynamyTargets NAMESPACE dynamy:: DESTINATION ${package_dir})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/dynamyConfig.cmake.in
  ${PROJECT_BINARY_DIR}/dynamyConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dynamyConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dynamyConfig.cmake ${PROJECT_BINARY_DIR}/dynamyConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/DynamyAddPlugin.cmake DESTINATION ${package_dir})
