# Makes the Debian packages, unpacks them into a clean folder, and builds and runs there the template
# that the package dynamy-dev brings.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
find_program(DPKG_DEB dpkg-deb)
if(NOT DPKG_DEB)
  message("SKIPPED: no dpkg-deb")
  return()
endif()
set(folder ${BINARY_DIR}/package-test)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
run_commands("${CPACK}|--config|${BINARY_DIR}/CPackConfig.cmake|-B|${folder}")
file(GLOB packages ${folder}/dynamy*.deb)
list(LENGTH packages count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "expected dynamy and dynamy-dev, got: ${packages}")
endif()
foreach(package IN LISTS packages)
  run_commands("${DPKG_DEB}|-x|${package}|${folder}/root")
endforeach()
set(usr ${folder}/root/usr)

foreach(file bin/dynamy lib/dynamy/libdynamy_elements.so share/dynamy/models/woodpecker.xml
    share/man/man1/dynamy.1 share/bash-completion/completions/dynamy share/doc/dynamy/copyright
    include/dynamy/dynamy.hpp lib/libdynamy.so lib/cmake/dynamy/dynamyConfig.cmake)
  if(NOT EXISTS ${usr}/${file})
    message(FATAL_ERROR "no package holds /usr/${file}")
  endif()
endforeach()

# What the program needs of the system is found, what it brings itself is not asked for.
file(GLOB runtime ${folder}/dynamy_*.deb)
execute_process(COMMAND ${DPKG_DEB} --field ${runtime} Depends OUTPUT_VARIABLE depends)
if(NOT depends MATCHES "libtinyxml2" OR NOT depends MATCHES "libhdf5" OR depends MATCHES "libdynamy")
  message(FATAL_ERROR "dependencies of ${runtime}: ${depends}")
endif()
run_commands("${usr}/bin/dynamy|run|${usr}/share/dynamy/models/bouncing_ball.xml|--quiet|--out|${folder}/ball")
use_template(${usr} ${usr}/share/dynamy/template ${folder}/template)
