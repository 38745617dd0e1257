# Text files as string literals of a C++ file.
#   cmake -DOUT=viewer_files.cpp -DFILES="a.html|b.js" -DHEADER=a/b.hpp -DFUNCTION=a::viewerFile -P EmbedText.cmake
# makes the function std::string_view FUNCTION(std::string_view name), which HEADER declares.
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
  file(WRITE "${OUT}" "// Made by the build.\n#include ${HEADER}\n\n"
    "std::string_view ${FUNCTION}(std::string_view name) {\n${entries}  return {};\n}\n")
  return()
endif()

# dynamy_embed_text(target header function files...): adds a source with the text of all files to `target`.
function(dynamy_embed_text target header function)
  string(REPLACE ";" "|" joined "${ARGN}")
  string(REGEX REPLACE ".*::" "" name ${function})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake)
  add_custom_command(OUTPUT ${out} DEPENDS ${ARGN} ${script} VERBATIM
    COMMAND ${CMAKE_COMMAND} "-DOUT=${out}" "-DFILES=${joined}" "-DHEADER=${header}" "-DFUNCTION=${function}"
            -P ${script}
    COMMENT "Embedding the texts of ${target}")
  target_sources(${target} PRIVATE ${out})
endfunction()
