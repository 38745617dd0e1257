# Install rules in two components, and the packages that CPack makes of them:
#   runtime   program, libraries, plug-ins, models, manual page, completion
#   dev       headers, what find_package(dynamy) reads, the plug-in template
# Rejected: libraries below lib/<architecture>; a program finds ../lib/dynamy relative to itself, in the
# build tree as in any prefix.
include(CMakePackageConfigHelpers)
set(package_dir lib/cmake/dynamy)

install(TARGETS dynamy_framework EXPORT dynamyTargets
  LIBRARY DESTINATION lib COMPONENT runtime NAMELINK_COMPONENT dev
  RUNTIME DESTINATION bin COMPONENT runtime)
install(TARGETS dynamy_optimiser LIBRARY DESTINATION lib COMPONENT runtime)
install(TARGETS dynamy_elements EXPORT dynamyTargets
  LIBRARY DESTINATION lib/dynamy COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/framework/dynamy DESTINATION include COMPONENT dev
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/elements/dynamy_elements DESTINATION include COMPONENT dev
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION share/dynamy COMPONENT runtime
  FILES_MATCHING PATTERN "*.xml")
# Messages name documents as doc/NAME.md.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc/ DESTINATION share/doc/dynamy COMPONENT runtime
  FILES_MATCHING PATTERN "*.md" PATTERN "figures" EXCLUDE PATTERN "site" EXCLUDE PATTERN "trust" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/app/python/dynamy_run.py
  DESTINATION lib/python3/dist-packages COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/plugins/template DESTINATION share/dynamy COMPONENT dev
  PATTERN "*_test.cpp" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/dynamy RENAME copyright
  COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/dynamy-dev RENAME copyright
  COMPONENT dev)
install(EXPORT dynamyTargets NAMESPACE dynamy:: DESTINATION ${package_dir} COMPONENT dev)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/dynamyConfig.cmake.in
  ${PROJECT_BINARY_DIR}/dynamyConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dynamyConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dynamyConfig.cmake ${PROJECT_BINARY_DIR}/dynamyConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/DynamyAddPlugin.cmake DESTINATION ${package_dir} COMPONENT dev)

# cpack --config build/release/CPackConfig.cmake (in the build folder: cpack) makes the two packages.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME dynamy)
set(CPACK_PACKAGE_VENDOR dynamY)
set(CPACK_PACKAGE_CONTACT "The dynamY authors <dynamy@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL runtime dev)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME dynamy)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "python3-numpy, xdg-utils")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "Simulation of multibody systems with impacts and friction: program, elements, models, replay.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME dynamy-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "dynamy (= ${PROJECT_VERSION}), cmake (>= 3.22), g++, ninja-build, libeigen3-dev (>= 3.4), libfmt-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers and CMake package for plug-ins of dynamY, with a template.")
include(CPack)
