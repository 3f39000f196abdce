# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries that the engine links, for whoever builds it alone and whoever links the installed one.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(Boost REQUIRED CONFIG COMPONENTS filesystem iostreams)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
if(NOT TARGET utf8::cpp) # its package cannot be found twice, and until version 4 the target had another name
  find_package(utf8cpp REQUIRED)
  if(NOT TARGET utf8::cpp)
    add_library(utf8::cpp ALIAS utf8cpp)
  endif()
endif()
# These have no package of CMake's.
foreach(library_and_file IN ITEMS libcsv:csv udunits2:udunits2)
  string(REGEX MATCH "(.*):(.*)" matched ${library_and_file})
  if(NOT TARGET ${CMAKE_MATCH_1}::${CMAKE_MATCH_1})
    find_library(literate_${CMAKE_MATCH_2}_LIBRARY ${CMAKE_MATCH_2} REQUIRED)
    add_library(${CMAKE_MATCH_1}::${CMAKE_MATCH_1} UNKNOWN IMPORTED)
    set_target_properties(${CMAKE_MATCH_1}::${CMAKE_MATCH_1} PROPERTIES
      IMPORTED_LOCATION "${literate_${CMAKE_MATCH_2}_LIBRARY}")
  endif()
endforeach()
