# SPDX-License-Identifier: GPL-3.0-or-later
# What the engine needs when the rest of the repository is not built around it: its packages and the libraries below it.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
  set(HALFSPACE_PREFIX literate_) # the other project may have a target of its own called `system`
endif()

set(CMAKE_UNITY_BUILD ON) # eight files compiled as one take half of the time

set(toolchain "${CMAKE_CURRENT_LIST_DIR}/../../toolchain/cmake")
include("${toolchain}/Dependencies.cmake")
include("${toolchain}/Helpers.cmake")
# The same library wherever it is built.
add_compile_options("-fmacro-prefix-map=${HALFSPACE_ROOT}/=")

add_subdirectory(../system system)
add_subdirectory(../numerics numerics)
add_subdirectory(../config config)
add_subdirectory(../command_line command_line)
