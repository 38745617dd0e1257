# Targets for those who work on dynamY itself: docs, coverage.
if(DYNAMY_DOCS)
  find_package(Doxygen)
  if(DOXYGEN_FOUND AND EXISTS ${PROJECT_SOURCE_DIR}/doc/Doxyfile.in)
    configure_file(${PROJECT_SOURCE_DIR}/doc/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
    add_custom_target(docs COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/Doxyfile VERBATIM)
  else()
    message(WARNING "The target docs needs doxygen and doc/Doxyfile.in; it is left out.")
  endif()
endif()

if(DYNAMY_COVERAGE)
  find_program(GCOVR_PROGRAM gcovr)
  if(GCOVR_PROGRAM)
    add_custom_target(coverage
      COMMAND ${GCOVR_PROGRAM} --root ${PROJECT_SOURCE_DIR} --filter framework/ --filter elements/
              --txt --html-details ${PROJECT_BINARY_DIR}/coverage.html ${PROJECT_BINARY_DIR}
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
  endif()
endif()
