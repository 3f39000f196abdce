# SPDX-License-Identifier: GPL-3.0-or-later
# The repository, even if a different project includes it.
cmake_path(SET HALFSPACE_ROOT NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../..")
string(REGEX REPLACE "/$" "" HALFSPACE_ROOT "${HALFSPACE_ROOT}")

# File names inside the program (assert, std::source_location) are relative to the checkout, so that programs and messages do not
# depend on the build folder.
add_compile_options("-fmacro-prefix-map=${HALFSPACE_ROOT}/=")
# With CCACHE_BASEDIR, ccache compiles with paths relative to the build folder.
file(RELATIVE_PATH from_build "${CMAKE_BINARY_DIR}" "${HALFSPACE_ROOT}")
add_compile_options("-fmacro-prefix-map=${from_build}=")

# Let g++ collect garbage only beyond half a gigabyte. By default it does so ten times per file, which takes 8 % of the time.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=524288)
endif()

# One INTERFACE target with all warning flags and their reasons. -Wnull-dereference is left out because, at -O3, g++ 12 reports
# it inside the streambuf iterators of libstdc++.
if(HALFSPACE_EVERYTHING)
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
endif()

# add_precompiled_headers() compiles the headers that nearly every file includes once instead of 200 times, which saves a third of
# the compile time. Files still include what they use; the preset tidy verifies this by CMAKE_DISABLE_PRECOMPILE_HEADERS. There
# are two sets, because code that handles text is not optimised (compile_without_optimising). Only the other one contains Eigen.
function(add_precompiled_headers)
  set(everywhere
    <fmt/core.h>
    <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <numbers> <optional> <set>
    <stdexcept> <string> <utility> <vector>)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/precompiled.cpp" CONTENT "// Libraries of headers need a source.\n")
  foreach(target IN ITEMS precompiled precompiled_text)
    add_library(${target} STATIC "${PROJECT_BINARY_DIR}/precompiled.cpp")
    target_link_libraries(${target} PUBLIC Eigen3::Eigen fmt::fmt PRIVATE project_warnings)
    add_sanitizers(${target})
  endforeach()
  target_precompile_headers(precompiled PRIVATE <Eigen/Core> ${everywhere})
  target_precompile_headers(precompiled_text PRIVATE ${everywhere})
  target_compile_options(precompiled_text PRIVATE $<$<CONFIG:Release>:-O0>)
endfunction()

# compile_without_optimising(target) is for programs and libraries that handle text or only call computations. Without
# optimisation they compile in two thirds of the time, and the report is computed only 10 % more slowly.
function(compile_without_optimising target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
  if(HALFSPACE_EVERYTHING)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:precompiled_text> $<BUILD_INTERFACE:project_warnings>)
    target_precompile_headers(${target} REUSE_FROM precompiled_text)
  endif()
endfunction()

# export_headers(target folder [header …]) lets targets that link this one include "folder/name.hpp": the headers named here, or
# all headers in this folder of src and below. They cannot include headers of other folders, so the compiler enforces the
# architecture. The exported folder contains links, so that each header stays next to its source.
function(export_headers target folder)
  set(exported "${PROJECT_BINARY_DIR}/include/${target}")
  set(source "${HALFSPACE_ROOT}/src/${folder}")
  if(ARGN)
    file(MAKE_DIRECTORY "${exported}/${folder}")
    foreach(header IN LISTS ARGN)
      file(CREATE_LINK "${source}/${header}" "${exported}/${folder}/${header}" SYMBOLIC)
    endforeach()
  else()
    file(MAKE_DIRECTORY "${exported}")
    file(CREATE_LINK "${source}" "${exported}/${folder}" SYMBOLIC)
  endif()
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${exported}>")
endfunction()

# add_folder_library(name [FOLDER folder] [HEADERS …] [ROOMS …] [NO_HEAVY_COMPUTING] SOURCES … LINK … PRIVATE_LINK …) adds the
# library of the folder src/name, or src/folder. LINK and PRIVATE_LINK define the architecture: a folder can include only headers
# of libraries that it links. HEADERS lists the exported headers, if not all. ROOMS lists the subfolders in order; each may use
# only those before it (tests/toolchain/architecture_test.py). NO_HEAVY_COMPUTING: see compile_without_optimising. The presets
# release, bench and sanitize compile up to eight files of a folder together (CMAKE_UNITY_BUILD), twelve in libraries that compute,
# which halves the time. dev and tidy compile each file separately, which verifies its includes.
#
# HALFSPACE_PREFIX, if set, precedes the name of the target. It avoids name clashes within a different project.
function(add_folder_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_HEAVY_COMPUTING" "FOLDER" "HEADERS;ROOMS;SOURCES;LINK;PRIVATE_LINK")
  if(NOT arg_FOLDER)
    set(arg_FOLDER ${name})
  endif()
  list(JOIN arg_ROOMS " " rooms)
  list(JOIN arg_LINK " " links)
  list(JOIN arg_PRIVATE_LINK " " private_links)
  set_property(GLOBAL APPEND PROPERTY HALFSPACE_ARCHITECTURE "${name}|${arg_FOLDER}|${links} ${private_links}|${rooms}")
  set(target "${HALFSPACE_PREFIX}${name}")
  list(TRANSFORM arg_SOURCES PREPEND "${HALFSPACE_ROOT}/src/${arg_FOLDER}/")
  add_library(${target} STATIC ${arg_SOURCES})
  export_headers(${target} ${arg_FOLDER} ${arg_HEADERS})
  target_compile_features(${target} PUBLIC cxx_std_20)
  foreach(scope IN ITEMS LINK PRIVATE_LINK)
    foreach(link IN LISTS arg_${scope})
      if(TARGET "${HALFSPACE_PREFIX}${link}")
        set(link "${HALFSPACE_PREFIX}${link}")
      endif()
      if(scope STREQUAL "LINK")
        target_link_libraries(${target} PUBLIC "${link}")
      else()
        target_link_libraries(${target} PRIVATE "${link}")
      endif()
    endforeach()
  endforeach()
  add_sanitizers(${target})
  if(arg_NO_HEAVY_COMPUTING)
    compile_without_optimising(${target})
  elseif(HALFSPACE_EVERYTHING)
    target_link_libraries(${target} PRIVATE precompiled project_warnings)
    target_precompile_headers(${target} REUSE_FROM precompiled)
    # The compiler spends most of its time on the same templates of Eigen, once per batch.
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 12)
  endif()
endfunction()

# write_architecture(file) writes one line per library, «name|folder|linked libraries|rooms», for the test of the architecture.
function(write_architecture file)
  get_property(lines GLOBAL PROPERTY HALFSPACE_ARCHITECTURE)
  list(JOIN lines "\n" text)
  file(CONFIGURE OUTPUT "${file}" CONTENT "${text}\n" @ONLY)
endfunction()

# add_sanitizers(target) adds the sanitizers if the preset enables them. A violation stops the program at once.
# -Wno-maybe-uninitialized: in instrumented code, g++ 12 warns of uninitialised members inside std::regex.
function(add_sanitizers target)
  if(HALFSPACE_SANITIZE)
    target_compile_definitions(${target} PUBLIC _GLIBCXX_ASSERTIONS)
    target_compile_options(${target} PUBLIC
      -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
      -Wno-maybe-uninitialized)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# add_test_options(target COMPUTES|"") turns optimisation off, because most tests compute little and optimisation would double
# their build time. Tests marked COMPUTES are compiled with -O1: if library and test instantiate the same template, such as
# Eigen's matrix product, the linker may keep the one of the test.
function(add_test_options target computes)
  set(level $<IF:$<AND:$<BOOL:${computes}>,$<NOT:$<BOOL:${HALFSPACE_SANITIZE}>>>,-O1,-O0>)
  target_compile_options(${target} PRIVATE $<$<OR:$<CONFIG:Release>,$<BOOL:${HALFSPACE_SANITIZE}>>:${level}>)
  add_sanitizers(${target})
endfunction()

# precompile_tests(target COMPUTES|"") compiles the headers that every test includes only once.
function(precompile_tests target computes)
  add_library(${target} STATIC "${PROJECT_BINARY_DIR}/precompiled.cpp")
  target_precompile_headers(${target} PRIVATE
    <Eigen/Core> <boost/test/unit_test.hpp> <fmt/core.h>
    <algorithm> <cmath> <filesystem> <functional> <limits> <map> <numbers> <set> <string> <vector>)
  target_link_libraries(${target}
    PRIVATE Boost::unit_test_framework unit_test_main project_warnings PUBLIC Eigen3::Eigen fmt::fmt)
  add_test_options(${target} "${computes}")
endfunction()

# add_unit_tests(folder [COMPUTES] LINK library … [DEFINE macro …] NAMES name … [SLOW name seconds …]) adds the tests of one
# folder. Each file tests/folder/name_test.cpp is one CTest test, unit/folder/name, which runs the suite name_test. All files form
# one program, because each program takes three seconds to build; `make test` and the sanitizers run NAMES. Only `make test-all`
# runs the tests in SLOW, as slow/folder/name; it starts the longest first.
function(add_unit_tests folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COMPUTES" "" "LINK;DEFINE;NAMES;SLOW")
  set(sources ${arg_NAMES})
  foreach(name IN LISTS arg_NAMES)
    cmake_path(GET name FILENAME suite)
    add_test(NAME unit/${folder}/${name} COMMAND ${folder}_tests --run_test=${suite}_test --color_output=no)
    label_test(unit/${folder}/${name} unit TARGET ${folder}_tests)
  endforeach()
  while(arg_SLOW)
    list(POP_FRONT arg_SLOW name seconds)
    add_test(NAME slow/${folder}/${name} COMMAND ${folder}_tests --run_test=${name}_test --color_output=no)
    label_test(slow/${folder}/${name} slow COST ${seconds})
    list(APPEND sources ${name})
  endwhile()
  list(TRANSFORM sources REPLACE "(.+)" "${HALFSPACE_ROOT}/tests/${folder}/\\1_test.cpp")
  set(target ${folder}_tests)
  set(precompiled precompiled_tests)
  set(computes "")
  if(arg_COMPUTES)
    set(precompiled precompiled_computing_tests)
    set(computes COMPUTES)
  endif()
  add_executable(${target} ${sources})
  target_link_libraries(${target} PRIVATE ${arg_LINK} unit_test_main ${precompiled} project_warnings)
  target_compile_definitions(${target} PRIVATE ${arg_DEFINE})
  add_test_options(${target} "${computes}")
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
endfunction()

# add_script_test(test file [TARGET program] [COST seconds] [ARGS argument …]) adds a test that is a Python script. Its arguments
# are the repository and then ARGS. Exit code 77 means skipped. The name of the test begins with its label.
function(add_script_test test file)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "TARGET;COST;ARGS")
  add_test(NAME ${test} COMMAND python3 -B "${CMAKE_CURRENT_SOURCE_DIR}/${file}" "${HALFSPACE_ROOT}" ${arg_ARGS})
  set_tests_properties(${test} PROPERTIES SKIP_RETURN_CODE 77)
  string(REGEX REPLACE "/.*" "" label "${test}")
  label_test(${test} ${label} TARGET ${arg_TARGET} COST ${arg_COST})
endfunction()

# label_test(test label [TARGET program] [COST seconds]) defines when a CTest test runs. `unit`: with `make test` and the
# sanitizers; `everyday`: with `make test`; `slow`: only with `make test-all`, which runs every test. TARGET is the program that
# the test needs. Unit tests without a TARGET also get the label `script`; the sanitizers skip these, because they test no
# compiled code.
function(label_test test label)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "TARGET;COST" "")
  set_property(TEST "${test}" PROPERTY LABELS ${label})
  if(label STREQUAL "unit" AND NOT arg_TARGET)
    set_property(TEST "${test}" APPEND PROPERTY LABELS script)
  endif()
  if(DEFINED arg_COST)
    set_property(TEST "${test}" PROPERTY COST ${arg_COST})
  endif()
  if(arg_TARGET AND NOT label STREQUAL "slow")
    add_dependencies(everyday_tests ${arg_TARGET})
  endif()
  if(arg_TARGET AND label STREQUAL "unit")
    add_dependencies(unit_tests ${arg_TARGET})
  endif()
endfunction()
