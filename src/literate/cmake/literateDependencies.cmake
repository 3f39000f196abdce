# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries that the engine links, for builds of the engine and for papers that link an installed one.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(Boost REQUIRED CONFIG COMPONENTS filesystem iostreams)
if(NOT TARGET udunits2::udunits2) # UDUNITS-2 has no CMake package
  find_library(literate_UDUNITS2_LIBRARY udunits2 REQUIRED)
  add_library(udunits2::udunits2 UNKNOWN IMPORTED)
  set_target_properties(udunits2::udunits2 PROPERTIES IMPORTED_LOCATION "${literate_UDUNITS2_LIBRARY}")
endif()
