# The target docs: the documentation site, doc/site/README.md.
if(DYNAMY_DOCS)
  set(DYNAMY_DOCS_PROGRAM "" CACHE FILEPATH "Program that runs the models of the site's gallery; empty: build it")
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(dynamyDocsProgram ${DYNAMY_DOCS_PROGRAM})
  if(NOT dynamyDocsProgram)
    set(dynamyDocsProgram $<TARGET_FILE:dynamy>)
  endif()
  add_custom_target(docs
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/doc/site/build.py --out ${PROJECT_BINARY_DIR}/site
            --program ${dynamyDocsProgram} --version ${PROJECT_VERSION}
    USES_TERMINAL VERBATIM)
  if(NOT DYNAMY_DOCS_PROGRAM)
    add_dependencies(docs dynamy plugins)
  endif()
endif()
