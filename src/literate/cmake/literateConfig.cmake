# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(literate): the libraries literate::literate and literate::config, the program literate::program, and
# literate_add_paper.
include(CMakeFindDependencyMacro)
find_dependency(Boost 1.74 COMPONENTS filesystem iostreams system)
find_dependency(CLI11)
find_dependency(OpenSSL COMPONENTS Crypto)
find_dependency(Threads)
find_dependency(fmt)
find_dependency(nlohmann_json)
find_dependency(jsoncpp)
find_dependency(yaml-cpp)
find_dependency(tomlplusplus)
if(NOT TARGET utf8cpp) # whose package cannot be found twice
  find_dependency(utf8cpp)
endif()
# UDUNITS has no package of CMake's; the target has the name by which the libraries link it.
if(NOT TARGET udunits2::udunits2)
  find_library(UDUNITS2_LIBRARY udunits2)
  if(NOT UDUNITS2_LIBRARY)
    set(literate_FOUND FALSE)
    set(literate_NOT_FOUND_MESSAGE "libudunits2 is missing (Debian: libudunits2-dev)")
    return()
  endif()
  add_library(udunits2::udunits2 UNKNOWN IMPORTED)
  set_target_properties(udunits2::udunits2 PROPERTIES IMPORTED_LOCATION "${UDUNITS2_LIBRARY}")
endif()
include("${CMAKE_CURRENT_LIST_DIR}/literateTargets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/AddPaper.cmake")
