# SPDX-License-Identifier: GPL-3.0-or-later
# One INTERFACE target carries every warning flag, each with its reason.
# Not -Wnull-dereference: at -O3 g++ 12 finds it inside libstdc++'s own streambuf iterators.
add_library(project_warnings INTERFACE)
target_compile_options(project_warnings INTERFACE
  -Wall -Wextra -Wpedantic   # what every C++ project should be free of
  -Wshadow                   # a hidden x or a in a formula is a wrong formula
  -Wconversion               # an int that swallows a double loses digits
  -Wsign-conversion          # index arithmetic near zero
  $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion> # a stray float; clang takes the C library's NAN for one
  -Wfloat-conversion         # digits dropped without a word
  -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual)

# Warnings are errors only with Debian 12's compiler, whose warnings are known: a reader with a newer g++ wants the
# report, not its new warnings.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^12\\.")
  target_compile_options(project_warnings INTERFACE -Werror)
endif()

# Names of source files inside the program (assert, std::source_location) start at the checkout, so that the
# program and its messages are the same wherever it was built.
add_compile_options("-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=")
# ccache compiles with paths that start at the build folder, if it is told to (CCACHE_BASEDIR).
file(RELATIVE_PATH from_build "${CMAKE_BINARY_DIR}" "${PROJECT_SOURCE_DIR}")
string(REGEX REPLACE "/$" "" from_build "${from_build}")
if(from_build)
  add_compile_options("-fmacro-prefix-map=${from_build}/=")
endif()
