# Steps of the tests of what is installed.

# Runs the commands, each a list in one string; the first that fails ends the test with its output.
function(run_commands)
  foreach(command ${ARGN})
    string(REPLACE "|" ";" command "${command}")
    execute_process(COMMAND ${command} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
      list(JOIN command " " text)
      message(FATAL_ERROR "${text}\nexit status ${result}\n${output}")
    endif()
  endforeach()
endfunction()

# A user's copy of the template in `folder`, built and run against what lies under `prefix`: the
# installed program finds its own elements and the plug-in that was built outside of the tree.
function(use_template prefix template folder)
  file(REMOVE_RECURSE "${folder}")
  file(MAKE_DIRECTORY "${folder}")
  file(GLOB files "${template}/*")
  file(COPY ${files} DESTINATION "${folder}")
  set(ENV{DYNAMY_PLUGIN_PATH} "${folder}/build")
  run_commands(
    "${CMAKE_COMMAND}|-S|${folder}|-B|${folder}/build|-G|Ninja|-DCMAKE_PREFIX_PATH=${prefix}|-DCMAKE_CXX_COMPILER=${CXX}"
    "${CMAKE_COMMAND}|--build|${folder}/build"
    "${prefix}/bin/dynamy|run|${folder}/pendulum_wall.xml|--quiet|--out|${folder}/run")
  execute_process(COMMAND "${prefix}/bin/dynamy" list --plugin pendulum_wall
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0 OR NOT output MATCHES "PendulumWall" OR NOT output MATCHES "RigidBody")
    message(FATAL_ERROR "dynamy list --plugin pendulum_wall: exit status ${result}\n${output}")
  endif()
endfunction()
