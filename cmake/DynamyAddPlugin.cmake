# dynamy_add_plugin(name sources...): a plug-in lib<name>.so that the program `dynamy` can load.
#
# In dynamY's own tree the library goes to <build>/lib/dynamy, where the program finds it by itself.
# Out of tree, after find_package(dynamy), it goes to the current binary folder: name that folder in
# DYNAMY_PLUGIN_PATH or the library with --plugin; `cmake --install` puts it to lib/dynamy.
function(dynamy_add_plugin name)
  if(NOT ARGN)
    message(FATAL_ERROR "dynamy_add_plugin(${name}): no source files given")
  endif()
  add_library(${name} MODULE ${ARGN})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_link_libraries(${name} PRIVATE dynamy::framework)
  if(NOT DYNAMY_FUZZ)
    target_link_options(${name} PRIVATE -Wl,--no-undefined)  # told by the linker, not by the loader
  endif()
  set_target_properties(${name} PROPERTIES PREFIX lib
    INSTALL_RPATH "$ORIGIN/.." BUILD_WITH_INSTALL_RPATH ON)  # the program has loaded libdynamy.so
  if(TARGET dynamy_framework)
    target_link_libraries(${name} PRIVATE dynamy_warnings)
    target_include_directories(${name} PRIVATE ${dynamy_SOURCE_DIR}/elements)
    set_target_properties(${name} PROPERTIES
      LIBRARY_OUTPUT_DIRECTORY ${dynamy_BINARY_DIR}/lib/dynamy)
    set_property(GLOBAL APPEND PROPERTY DYNAMY_PLUGINS ${name})
    dynamy_in_batches(${name})
  endif()
  # dynamY's own plug-ins need not all be built (plugins/CMakeLists.txt).
  set(optional "")
  if(TARGET dynamy_framework)
    set(optional OPTIONAL)
  endif()
  install(TARGETS ${name} LIBRARY DESTINATION lib/dynamy COMPONENT runtime ${optional})
endfunction()
