# What an installation needs from the build folder is made by the target `dynamy`, which scripts/run builds:
# `cmake --install` works after it. Plug-ins are optional.
#   cmake -DBINARY_DIR=... -DNINJA=... -P rules.cmake
file(GLOB_RECURSE rules ${BINARY_DIR}/cmake_install.cmake)
# Other tests build projects of their own in there.
list(FILTER rules EXCLUDE REGEX "^${BINARY_DIR}/(install|package)-test/")
execute_process(COMMAND ${NINJA} -C ${BINARY_DIR} -t commands dynamy
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
      message(SEND_ERROR "${file} is installed, but not made by the target dynamy")
    endif()
  endforeach()
endforeach()
if(count LESS 6)  # program, elements, manual page, three completions
  message(FATAL_ERROR "only ${count} files of the build folder were found in ${rules}")
endif()
