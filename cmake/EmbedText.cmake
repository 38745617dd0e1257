# Text files as string literals of a C++ file.
#   cmake -DOUT=viewer_files.cpp -DFILES="a.html|b.js" -DHEADER=dynamy/io/viewer_files.hpp
#         -DNAMESPACE=dynamy -DFUNCTION=viewerFile -P EmbedText.cmake
# Raw literals keep the text as it is; they are cut into pieces because compilers limit one literal.
# Rejected: xxd (not everywhere), #embed (C++26), ld -r -b binary (one linker only).
if(CMAKE_SCRIPT_MODE_FILE)
  string(REPLACE "|" ";" files "${FILES}")
  set(entries "")
  foreach(file IN LISTS files)
    file(READ "${file}" text)
    get_filename_component(name "${file}" NAME)
    string(APPEND entries "  if (name == \"${name}\") {\n    static constexpr char text[] =\n")
    # lengths count bytes: cut behind a line's end, never inside a character
    string(APPEND text "\n")
    string(LENGTH "${text}" length)
    set(at 0)
    while(at LESS length)
      string(SUBSTRING "${text}" ${at} 8000 piece)
      string(FIND "${piece}" "\n" end REVERSE)
      math(EXPR end "${end} + 1")
      string(SUBSTRING "${piece}" 0 ${end} piece)
      string(APPEND entries "        R\"_text_(${piece})_text_\"\n")
      math(EXPR at "${at} + ${end}")
    endwhile()
    string(APPEND entries "        \"\";\n    return {text, sizeof(text) - 1};\n  }\n")
  endforeach()
  file(WRITE "${OUT}" "// Made by the build.\n#include <${HEADER}>\n\n"
    "namespace ${NAMESPACE} {\n\nstd::string_view ${FUNCTION}(std::string_view name) {\n${entries}"
    "  return {};\n}\n\n}  // namespace ${NAMESPACE}\n")
  return()
endif()

# dynamy_embed(target FUNCTION name HEADER header NAMESPACE namespace FILES file…): adds a file to
# `target` that defines FUNCTION, declared in HEADER, which returns the text of a file by its name.
function(dynamy_embed target)
  cmake_parse_arguments(arg "" "FUNCTION;HEADER;NAMESPACE" "FILES" ${ARGN})
  string(REPLACE ";" "|" joined "${arg_FILES}")
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${arg_FUNCTION}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake)
  add_custom_command(OUTPUT ${out} DEPENDS ${arg_FILES} ${script} VERBATIM
    COMMAND ${CMAKE_COMMAND} "-DOUT=${out}" "-DFILES=${joined}" "-DHEADER=${arg_HEADER}"
            "-DNAMESPACE=${arg_NAMESPACE}" "-DFUNCTION=${arg_FUNCTION}" -P ${script}
    COMMENT "Embedding the text of ${arg_FUNCTION}")
  target_sources(${target} PRIVATE ${out})
endfunction()
