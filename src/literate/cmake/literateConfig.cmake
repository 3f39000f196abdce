# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(literate) provides literate_add_paper, the library literate::literate and the program literate-results: from an
# installed engine, which has literateTargets.cmake, or from a checkout, which the build of the paper compiles.
include("${CMAKE_CURRENT_LIST_DIR}/LiteratePaper.cmake")
if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/literateTargets.cmake")
  cmake_path(SET literate_PREFIX NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../..")
  set(literate_RESULTS "${literate_PREFIX}/bin/literate-results" CACHE INTERNAL "")
  get_property(literate_LANGUAGES GLOBAL PROPERTY ENABLED_LANGUAGES)
  if("CXX" IN_LIST literate_LANGUAGES) # a script needs neither compiler nor libraries
    include("${CMAKE_CURRENT_LIST_DIR}/literateDependencies.cmake")
    include("${CMAKE_CURRENT_LIST_DIR}/literateTargets.cmake")
    literate_relative_places(literate::literate)
  endif()
else()
  enable_language(CXX)
  cmake_path(SET literate_REPOSITORY NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../..")
  add_subdirectory("${literate_REPOSITORY}" "${CMAKE_BINARY_DIR}/literate" EXCLUDE_FROM_ALL)
endif()
