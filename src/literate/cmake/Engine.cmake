# SPDX-License-Identifier: GPL-3.0-or-later
# What the engine needs when the rest of the repository is not built around it: a part of a paper's own build.
enable_language(CXX)
set(HALFSPACE_PREFIX literate_) # the paper may have a target called `system`
set(CMAKE_UNITY_BUILD ON)       # eight files compiled as one take half of the time
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

include("${CMAKE_CURRENT_LIST_DIR}/literateDependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/../../toolchain/cmake/Helpers.cmake")
find_path(GNUPLOT_IOSTREAM_INCLUDE_DIR gnuplot-iostream.h REQUIRED)
add_compile_options("-fmacro-prefix-map=${HALFSPACE_ROOT}/=") # the same library wherever it is built

add_subdirectory(../system system)
add_subdirectory(../numerics numerics)
add_subdirectory(../config config)
