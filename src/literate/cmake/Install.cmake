# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install: the program in bin, libraries in lib/literate-VERSION, headers in include/literate-VERSION, and what
# papers are made with in share/literate-VERSION: the CMake package, scripts, the look of the page and the template.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(versioned "literate-${LITERATE_VERSION}")
set(headers "${CMAKE_INSTALL_INCLUDEDIR}/${versioned}")

set(libraries errors system estimate least_squares config command_line literate)
foreach(library IN LISTS libraries)
  target_include_directories(${library} INTERFACE "$<INSTALL_INTERFACE:${headers}>")
endforeach()
set_target_properties(literate_program PROPERTIES EXPORT_NAME program)
install(TARGETS ${libraries} literate_program EXPORT literate
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}/${versioned}"
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
foreach(folder IN ITEMS literate system config)
  install(DIRECTORY "${HALFSPACE_ROOT}/src/${folder}/" DESTINATION "${headers}/${folder}"
    FILES_MATCHING PATTERN "*.hpp" PATTERN template EXCLUDE PATTERN program EXCLUDE)
endforeach()
install(FILES "${HALFSPACE_ROOT}/src/numerics/estimate.hpp" "${HALFSPACE_ROOT}/src/numerics/estimate_algebra.hpp"
  "${HALFSPACE_ROOT}/src/numerics/least_squares.hpp" "${HALFSPACE_ROOT}/src/numerics/measured.hpp" DESTINATION "${headers}/numerics")

# The same folders as in the sources, so that scripts and CMake find each other in either.
set(share "share/${versioned}")
install(DIRECTORY scripts template DESTINATION "${share}")
install(PROGRAMS scripts/case scripts/cases DESTINATION "${share}/scripts") # which people run by their names
install(DIRECTORY page DESTINATION "${share}" FILES_MATCHING PATTERN "*.css" PATTERN "*.js" PATTERN "*.tex" PATTERN "*.lua")
install(FILES README.md DESTINATION "${share}")
install(FILES document/literate.sty DESTINATION "${share}/document")
install(FILES imports/results.schema.json DESTINATION "${share}/imports")
install(FILES cmake/AddPaper.cmake cmake/WriteRepository.cmake cmake/WriteLinked.cmake
  cmake/paper.cpp.in cmake/literateConfig.cmake
  DESTINATION "${share}/cmake")
# What the engine was installed from, for the manifests of papers and the workflows of new ones.
install(CODE "
  execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DSOURCE=${HALFSPACE_ROOT}\" \"-DOUTPUT=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${share}\"
    -P \"${CMAKE_CURRENT_SOURCE_DIR}/cmake/WriteRepository.cmake\" COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${share}/repository.tex\")")
install(EXPORT literate NAMESPACE literate:: FILE literateTargets.cmake DESTINATION "${share}/cmake")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/literateConfigVersion.cmake"
  VERSION "${LITERATE_VERSION}" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/literateConfigVersion.cmake" DESTINATION "${share}/cmake")
