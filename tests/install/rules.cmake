# What an installation takes from the build folder is made by the targets `dynamy` and `plugins`, which
# scripts/run and the tutorial build: `cmake --install` works after them.
#   cmake -DBINARY_DIR=... -DNINJA=... -P rules.cmake
file(GLOB_RECURSE rules ${BINARY_DIR}/cmake_install.cmake)
# Other tests build projects of their own in there.
list(FILTER rules EXCLUDE REGEX "^${BINARY_DIR}/(install|package)-test/")
execute_process(COMMAND ${NINJA} -C ${BINARY_DIR} -t commands dynamy plugins
  OUTPUT_VARIABLE commands RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "ninja -t commands: exit status ${result}")
endif()
set(count 0)
foreach(rule IN LISTS rules)
  file(STRINGS ${rule} lines REGEX "file\\(INSTALL.*FILES \"${BINARY_DIR}/")
  foreach(line IN LISTS lines)
    if(line MATCHES " OPTIONAL ")
      continue()
    endif()
    string(REGEX REPLACE ".*FILES \"${BINARY_DIR}/([^\"]*)\".*" "\\1" file "${line}")
    if(file MATCHES "^CMakeFiles/Export/|^dynamyConfig")  # made when the folder is configured
      continue()
    endif()
    math(EXPR count "${count} + 1")
    string(FIND "${commands}" "${file}" at)
    if(at EQUAL -1)
      message(SEND_ERROR "${file} is installed, but made by neither dynamy nor plugins")
    endif()
  endforeach()
endforeach()
if(count LESS 8)  # program, elements, six plug-ins, manual page, three completions
  message(FATAL_ERROR "only ${count} files of the build folder were found in ${rules}")
endif()
