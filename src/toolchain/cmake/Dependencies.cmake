# SPDX-License-Identifier: GPL-3.0-or-later
# Every library the project stands on (src/toolchain/packages.txt names their Debian packages), with the oldest version that
# has been tried. All that are missing are told at once.
set(missing_libraries "")

# want_package(library version package [argument …]): find_package, which remembers `library` if there is none, or an older one.
# The version is no argument of find_package, because many packages refuse it to whoever knows the last major version only.
macro(want_package library version package)
  find_package(${package} ${ARGN} QUIET)
  string(TOUPPER ${package} upper_case)
  set(found "${${package}_VERSION}")
  if(NOT found)
    set(found "${${upper_case}_VERSION}") # as some of CMake's own modules call it
  endif()
  if(NOT ${package}_FOUND)
    string(APPEND missing_libraries "\n  ${library} ${version} or newer")
  elseif(found AND found VERSION_LESS ${version})
    string(APPEND missing_libraries "\n  ${library} ${version} or newer: found ${found}")
  endif()
endmacro()

# want_files(library NAME header file …): the same for a library that CMake has no package of, and whose version it cannot tell.
# NAME_INCLUDE_DIR is the header's folder, and NAME_LIBRARIES are the files of the libraries of these names.
macro(want_files library NAME header)
  find_path(${NAME}_INCLUDE_DIR ${header})
  set(${NAME}_LIBRARIES "")
  set(lacks "")
  if(NOT ${NAME}_INCLUDE_DIR)
    set(lacks ": no header ${header}")
  endif()
  foreach(file IN ITEMS ${ARGN})
    find_library(${NAME}_${file}_LIBRARY ${file})
    list(APPEND ${NAME}_LIBRARIES "${${NAME}_${file}_LIBRARY}")
    if(NOT lacks AND NOT ${NAME}_${file}_LIBRARY)
      set(lacks ": no library ${file}")
    endif()
  endforeach()
  if(lacks)
    string(APPEND missing_libraries "\n  ${library}${lacks}")
  endif()
endmacro()

# First those of the engine, src/literate, which can be built without the others.
want_package(pkg-config 0.29 PkgConfig)
want_package("Boost with Filesystem and Iostreams" 1.74 Boost CONFIG COMPONENTS filesystem iostreams)
want_package(toml++ 3.3 tomlplusplus)
want_package(CLI11 2.1 CLI11)
want_package({fmt} 9 fmt)
want_package(nlohmann-json 3.11 nlohmann_json)
want_package(JsonCpp 1.9 jsoncpp)
want_package(yaml-cpp 0.7 yaml-cpp)
if(yaml-cpp_FOUND AND NOT TARGET yaml-cpp::yaml-cpp) # until version 0.8 it was called otherwise
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)
endif()
want_package(OpenSSL 3 OpenSSL COMPONENTS Crypto)
find_package(Threads REQUIRED)
if(NOT TARGET utf8::cpp) # its package cannot be found twice
  want_package(UTF8-CPP 3.2 utf8cpp)
  if(utf8cpp_FOUND AND NOT TARGET utf8::cpp) # until version 4 it was called otherwise
    add_library(utf8::cpp ALIAS utf8cpp)
  endif()
endif()
want_files("UDUNITS 2.2 or newer" UDUNITS2 udunits2.h udunits2)
want_files(gnuplot-iostream GNUPLOT_IOSTREAM gnuplot-iostream.h)
want_files("libcsv 3.0 or newer" LIBCSV csv.h csv)
want_package(Eigen 3.4 Eigen3 NO_MODULE)
want_package(GSL 2.7 GSL)
if(HALFSPACE_EVERYTHING)
  want_files("FFTW 3.3 or newer" FFTW3 fftw3.h fftw3)
endif()
if("commands" IN_LIST HALFSPACE_PARTS)
  want_files("muParser 2.3 or newer" MUPARSER muParser.h muparser)
endif()
if("tests" IN_LIST HALFSPACE_PARTS)
  want_package("Boost with Boost.Test" 1.74 Boost CONFIG COMPONENTS unit_test_framework)
  want_files("MPFR C++ 3.6 or newer, with MPFR and GMP" MPREAL mpreal.h mpfr gmp)
endif()
if("benchmarks" IN_LIST HALFSPACE_PARTS)
  want_package("Google Benchmark" 1.7 benchmark)
endif()

if(missing_libraries)
  message(FATAL_ERROR "These libraries are missing, or their headers are:${missing_libraries}\n"
    "\"make setup\" and the target that you want installs them, or says what else it wants.")
endif()
# So that whoever links the installed engine looks for them there.
foreach(library IN ITEMS libcsv udunits2)
  if(NOT TARGET ${library}::${library})
    string(TOUPPER ${library} upper_case)
    add_library(${library}::${library} UNKNOWN IMPORTED)
    set_target_properties(${library}::${library} PROPERTIES
      IMPORTED_LOCATION "${${upper_case}_LIBRARIES}" INTERFACE_INCLUDE_DIRECTORIES "${${upper_case}_INCLUDE_DIR}")
  endif()
endforeach()
