# Makes a wheel of what is built, installs it into a fresh environment of Python, and runs a model there
# with nothing but the wheel's own libraries.
#   cmake -DBINARY_DIR=... -DSOURCE_DIR=... -DPYTHON=... -P wheel.cmake
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
execute_process(COMMAND ${PYTHON} -c "import numpy, pip, venv"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message("SKIPPED: no numpy, pip or venv")
  return()
endif()
set(folder "${BINARY_DIR}/wheel-test")
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
unset(ENV{PYTHONPATH})
unset(ENV{DYNAMY_PLUGIN_PATH})
file(REMOVE_RECURSE ${folder})
run_commands(
  "${PYTHON}|-m|pip|wheel|--quiet|--no-index|--no-deps|--no-build-isolation|--config-settings|build-dir=${BINARY_DIR}|-w|${folder}|${SOURCE_DIR}/app/python"
  "${PYTHON}|-m|venv|--system-site-packages|--without-pip|${folder}/fresh environment")
file(GLOB wheel ${folder}/dynamy-*.whl)
set(python "${folder}/fresh environment/bin/python3")
run_commands("${python}|-m|pip|install|--quiet|--no-index|--no-deps|${wheel}")
file(COPY ${SOURCE_DIR}/models/woodpecker.xml ${SOURCE_DIR}/models/bouncing_ball.xml DESTINATION ${folder})
set(ENV{HOME} ${folder})
execute_process(COMMAND ${python} ${CMAKE_CURRENT_LIST_DIR}/wheel_runs.py ${BINARY_DIR}
  WORKING_DIRECTORY ${folder} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the wheel runs no model: exit status ${result}\n${output}")
endif()
# The program of the wheel.
execute_process(COMMAND "${folder}/fresh environment/bin/dynamy" run bouncing_ball.xml --quiet --out ball
  WORKING_DIRECTORY ${folder} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0 OR NOT EXISTS ${folder}/ball/replay.html)
  message(FATAL_ERROR "dynamy run of the wheel: exit status ${result}\n${output}")
endif()
