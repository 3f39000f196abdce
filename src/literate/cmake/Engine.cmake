# SPDX-License-Identifier: GPL-3.0-or-later
# Sets up the engine as a part of a paper's build, without the rest of the repository.
enable_language(CXX)
set(HALFSPACE_PREFIX literate_) # since a paper may have a target `system`
set(CMAKE_UNITY_BUILD ON)       # compiling eight files as one halves the time
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

include("${CMAKE_CURRENT_LIST_DIR}/literateDependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/../../toolchain/cmake/Helpers.cmake")
find_path(GNUPLOT_IOSTREAM_INCLUDE_DIR gnuplot-iostream.h REQUIRED)

include("${CMAKE_CURRENT_LIST_DIR}/../../toolchain/cmake/Libraries.cmake")
