# SPDX-License-Identifier: GPL-3.0-or-later
# One INTERFACE target with all warning flags and their reasons. -Wnull-dereference is left out because, at -O3, g++ 12 reports
# it inside the streambuf iterators of libstdc++.
add_library(project_warnings INTERFACE)
target_compile_options(project_warnings INTERFACE
  -Wall -Wextra -Wpedantic   # basic warnings
  -Wshadow                   # a hidden x or a in a formula is a wrong formula
  -Wconversion               # a double converted to an int loses digits
  -Wsign-conversion          # index arithmetic near zero
  $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion> # an accidental float; not for clang, which warns of the C library's NAN
  -Wfloat-conversion         # silently lost digits
  -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual)

# Warnings are errors only with the compiler of Debian 12. New warnings of a newer g++ must not prevent a reader from building
# the report.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^12\\.")
  target_compile_options(project_warnings INTERFACE -Werror)
endif()

# File names inside the program (assert, std::source_location) are relative to the checkout, so that programs and messages do not
# depend on the build folder.
add_compile_options("-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=")
# With CCACHE_BASEDIR, ccache compiles with paths relative to the build folder.
file(RELATIVE_PATH from_build "${CMAKE_BINARY_DIR}" "${PROJECT_SOURCE_DIR}")
add_compile_options("-fmacro-prefix-map=${from_build}=")
