# Installs the build tree, then configures, builds and runs the project beside this file and a copy of
# the plug-in template against it.
set(prefix ${BINARY_DIR}/install-test/prefix)
set(build ${BINARY_DIR}/install-test/build)
set(own ${BINARY_DIR}/install-test/template)  # a user's copy
file(REMOVE_RECURSE ${BINARY_DIR}/install-test)
file(COPY ${CONSUMER}/../../plugins/template DESTINATION ${BINARY_DIR}/install-test)
foreach(command
    "${CMAKE_COMMAND};--install;${BINARY_DIR};--prefix;${prefix}"
    "${CMAKE_COMMAND};-S;${CONSUMER};-B;${build};-G;Ninja;-DCMAKE_PREFIX_PATH=${prefix};-DCMAKE_CXX_COMPILER=${CXX}"
    "${CMAKE_COMMAND};--build;${build}"
    "${build}/consumer"
    "${CMAKE_COMMAND};-S;${own};-B;${own}/build;-G;Ninja;-DCMAKE_PREFIX_PATH=${prefix};-DCMAKE_CXX_COMPILER=${CXX}"
    "${CMAKE_COMMAND};--build;${own}/build")
  execute_process(COMMAND ${command} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN command " " text)
    message(FATAL_ERROR "${text}\n${output}")
  endif()
endforeach()

# The installed program finds its own elements and the plug-in that was built outside of the tree.
if(EXISTS ${prefix}/bin/dynamy)
  set(ENV{DYNAMY_PLUGIN_PATH} ${own}/build)
  execute_process(COMMAND ${prefix}/bin/dynamy list --plugin pendulum_wall
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0 OR NOT output MATCHES "PendulumWall" OR NOT output MATCHES "RigidBody")
    message(FATAL_ERROR "dynamy list --plugin pendulum_wall: exit status ${result}\n${output}")
  endif()
  execute_process(COMMAND ${prefix}/bin/dynamy run ${own}/pendulum_wall.xml --quiet --out ${own}/run
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "dynamy run pendulum_wall.xml: exit status ${result}\n${output}")
  endif()
endif()

# The same plug-in built for another vector width is refused before any of its C++ runs.
execute_process(COMMAND uname -m OUTPUT_VARIABLE processor OUTPUT_STRIP_TRAILING_WHITESPACE)
if(EXISTS ${prefix}/bin/dynamy AND processor STREQUAL "x86_64")
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${own} -B ${own}/avx -G Ninja
      -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=-mavx
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${own}/avx
      RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  endif()
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the template does not build with -mavx\n${output}")
  endif()
  set(ENV{DYNAMY_PLUGIN_PATH} ${own}/avx)
  execute_process(COMMAND ${prefix}/bin/dynamy check pendulum_wall.xml WORKING_DIRECTORY ${own}
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
