# Installs the build tree, then configures, builds and runs the project beside this file and a copy of
# the plug-in template against it. The folders have blanks in their names.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
set(prefix "${BINARY_DIR}/install-test/a prefix")
set(build "${BINARY_DIR}/install-test/a build")
set(own "${BINARY_DIR}/install-test/my template")  # a user's copy
file(REMOVE_RECURSE ${BINARY_DIR}/install-test)
run_commands(
  "${CMAKE_COMMAND}|--install|${BINARY_DIR}|--prefix|${prefix}"
  "${CMAKE_COMMAND}|-S|${CONSUMER}|-B|${build}|-G|Ninja|-DCMAKE_PREFIX_PATH=${prefix}|-DCMAKE_CXX_COMPILER=${CXX}"
  "${CMAKE_COMMAND}|--build|${build}"
  "${build}/consumer")
use_template("${prefix}" ${CONSUMER}/../../plugins/template "${own}")

# The same plug-in built for another vector width is refused before any of its C++ runs.
execute_process(COMMAND uname -m OUTPUT_VARIABLE processor OUTPUT_STRIP_TRAILING_WHITESPACE)
if(processor STREQUAL "x86_64")
  run_commands(
    "${CMAKE_COMMAND}|-S|${own}|-B|${own}/avx|-G|Ninja|-DCMAKE_PREFIX_PATH=${prefix}|-DCMAKE_CXX_COMPILER=${CXX}|-DCMAKE_CXX_FLAGS=-mavx"
    "${CMAKE_COMMAND}|--build|${own}/avx")
  set(ENV{DYNAMY_PLUGIN_PATH} "${own}/avx")
  execute_process(COMMAND "${prefix}/bin/dynamy" check pendulum_wall.xml WORKING_DIRECTORY "${own}"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  set(expected "pendulum_wall.xml:9:20: error: <plugin>: libpendulum_wall.so: built with Eigen alignment 32 bytes, dynamy uses 16 — compile both with the same -march
    9 |   <plugin library=\"pendulum_wall\"/>
      |                    ^~~~~~~~~~~~~
1 error
")
  if(NOT result EQUAL 2 OR NOT errors STREQUAL expected)
    message(FATAL_ERROR "-mavx: exit status ${result}\n${errors}expected\n${expected}")
  endif()
endif()
