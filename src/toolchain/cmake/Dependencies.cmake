# SPDX-License-Identifier: GPL-3.0-or-later
# Finds the libraries that the project needs. src/toolchain/packages.txt has their Debian packages and the oldest versions that were
# tested; 'make setup TARGET' installs what a target of make needs.
include("${CMAKE_CURRENT_LIST_DIR}/../../literate/cmake/literateDependencies.cmake")
find_package(CLI11 REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(GSL REQUIRED)

# Libraries without a CMake package
find_path(GNUPLOT_IOSTREAM_INCLUDE_DIR gnuplot-iostream.h REQUIRED)
find_library(FFTW3_LIBRARIES fftw3 REQUIRED)
find_path(MUPARSER_INCLUDE_DIR muParser.h REQUIRED)
find_library(MUPARSER_LIBRARIES muparser REQUIRED)

if(BUILD_TESTING)
  find_package(Boost REQUIRED CONFIG COMPONENTS unit_test_framework)
  find_path(MPREAL_INCLUDE_DIR mpreal.h REQUIRED)
  set(MPREAL_LIBRARIES mpfr gmp)
endif()
if(HALFSPACE_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
