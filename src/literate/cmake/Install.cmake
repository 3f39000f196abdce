# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install: libraries in lib/literate, headers in include/literate, programs in bin, documentation in share/doc/literate,
# and everything else in share/literate. This folder has the layout of src/literate, so that LaTeX, CMake and the tools find
# each other in both.
include(GNUInstallDirs)
set(headers "${CMAKE_INSTALL_INCLUDEDIR}/literate")
set(share share/literate)

set(libraries errors system estimate config literate)
foreach(library IN LISTS libraries)
  target_include_directories(${library} INTERFACE "$<INSTALL_INTERFACE:${headers}>")
endforeach()
install(TARGETS ${libraries} EXPORT literate ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}/literate")
install(TARGETS literate-results RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
foreach(folder IN ITEMS system config)
  install(DIRECTORY "${HALFSPACE_ROOT}/src/${folder}/" DESTINATION "${headers}/${folder}" FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/" DESTINATION "${headers}/literate" FILES_MATCHING PATTERN "*.hpp"
  PATTERN template EXCLUDE PATTERN tools EXCLUDE PATTERN python EXCLUDE PATTERN cmake EXCLUDE PATTERN page EXCLUDE)
install(FILES "${HALFSPACE_ROOT}/src/numerics/estimate.hpp" DESTINATION "${headers}/numerics")

install(EXPORT literate NAMESPACE literate:: FILE literateTargets.cmake DESTINATION "${share}/cmake")
install(FILES document/results.schema.json DESTINATION "${share}")
install(FILES README.md TUTORIAL.md DESTINATION share/doc/literate)
install(DIRECTORY pictures DESTINATION share/doc/literate)
# Files that are not compiled: the LaTeX package, the CMake functions, the tools and the template.
install(FILES literate.sty DESTINATION "${share}")
install(FILES cmake/literateConfig.cmake cmake/LiteratePaper.cmake cmake/literateDependencies.cmake DESTINATION "${share}/cmake")
install(DIRECTORY tools python template page DESTINATION "${share}" USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(CODE "file(CREATE_LINK ../${share}/tools/literate \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/literate\" SYMBOLIC)")
