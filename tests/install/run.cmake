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
