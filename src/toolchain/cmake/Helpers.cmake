# SPDX-License-Identifier: GPL-3.0-or-later
# g++ collects its garbage only beyond half a gigabyte: by default it does so ten times for each of our files, which takes
# one second in thirteen.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=524288)
endif()

# The repository, also where another project includes it.
cmake_path(SET HALFSPACE_ROOT NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../..")
string(REGEX REPLACE "/$" "" HALFSPACE_ROOT "${HALFSPACE_ROOT}")

# add_precompiled_headers(): what nearly every file includes, read once instead of 200 times; a third of the time to
# compile. Files include what they use all the same, and CMAKE_DISABLE_PRECOMPILE_HEADERS (preset tidy) proves it. What
# computes has Eigen among them; what handles text is not optimised (compile_without_optimising), and so has its own.
function(add_precompiled_headers)
  set(everywhere
    <fmt/core.h>
    <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <numbers> <optional> <set>
    <stdexcept> <string> <utility> <vector>)
  foreach(target IN ITEMS precompiled precompiled_text)
    add_library(${target} STATIC "${PROJECT_SOURCE_DIR}/src/toolchain/cmake/precompiled.cpp")
    target_link_libraries(${target} PUBLIC Eigen3::Eigen fmt::fmt PRIVATE project_warnings)
    add_sanitizers(${target})
  endforeach()
  target_precompile_headers(precompiled PRIVATE <Eigen/Core> ${everywhere})
  target_precompile_headers(precompiled_text PRIVATE ${everywhere})
  target_compile_options(precompiled_text PRIVATE $<$<CONFIG:Release>:-O0>)
endfunction()

# compile_without_optimising(target): for programs and libraries that handle text or put computations together.
# Optimising them would take the compiler longer than it would ever save: unoptimised, they compile in two thirds of the
# time, and the report is computed a tenth more slowly.
function(compile_without_optimising target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
  if(HALFSPACE_EVERYTHING)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:precompiled_text> $<BUILD_INTERFACE:project_warnings>)
    target_precompile_headers(${target} REUSE_FROM precompiled_text)
  endif()
endfunction()

# export_headers(target folder [header …]): whoever links the target can include "folder/name.hpp", with the headers
# named here, or all that lie in this folder and below, and the headers of no other folder: the compiler guards the
# architecture. The exported folder is made of links, so that each header stays beside its source.
function(export_headers target folder)
  set(exported "${PROJECT_BINARY_DIR}/include/${target}")
  if(ARGN)
    file(MAKE_DIRECTORY "${exported}/${folder}")
    foreach(header IN LISTS ARGN)
      file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}/${header}" "${exported}/${folder}/${header}" SYMBOLIC)
    endforeach()
  else()
    file(MAKE_DIRECTORY "${exported}")
    file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${exported}/${folder}" SYMBOLIC)
  endif()
  get_target_property(type ${target} TYPE)
  set(scope PUBLIC)
  if(type STREQUAL INTERFACE_LIBRARY)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} "$<BUILD_INTERFACE:${exported}>")
endfunction()

# add_folder_library(name [FOLDER folder] [HEADERS …] [ROOMS …] [NO_HEAVY_COMPUTING] SOURCES … LINK …
# PRIVATE_LINK …): the library of one folder of src. LINK and PRIVATE_LINK are the architecture: the
# headers of other folders are found through them only. HEADERS: those that are exported, if not all of the folder.
# ROOMS: the folders within, in their order; each uses only those before it (tests/toolchain/architecture_test.cpp).
# NO_HEAVY_COMPUTING: see compile_without_optimising. The presets release, bench and sanitize compile up to eight files of
# a folder as one (CMAKE_UNITY_BUILD), twelve where they compute, which takes half of the time; dev and tidy compile each
# file by itself and so prove that each includes what it uses.
#
# HALFSPACE_PREFIX, where it is set, stands before the target's name: inside another project, which has names of its own.
function(add_folder_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_HEAVY_COMPUTING" "FOLDER" "HEADERS;ROOMS;SOURCES;LINK;PRIVATE_LINK")
  if(NOT arg_FOLDER)
    cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME arg_FOLDER)
  endif()
  list(JOIN arg_ROOMS " " rooms)
  list(JOIN arg_LINK " " links)
  list(JOIN arg_PRIVATE_LINK " " private_links)
  set_property(GLOBAL APPEND PROPERTY HALFSPACE_ARCHITECTURE "${name}|${arg_FOLDER}|${links} ${private_links}|${rooms}")
  set(target "${HALFSPACE_PREFIX}${name}")
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
    # Most of the compiler's time goes into the same templates of Eigen, once for each piece.
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 12)
  endif()
endfunction()

# write_architecture(file): a line a library, «name|folder|what it links|rooms», for the test of the architecture.
function(write_architecture file)
  get_property(lines GLOBAL PROPERTY HALFSPACE_ARCHITECTURE)
  list(JOIN lines "\n" text)
  file(CONFIGURE OUTPUT "${file}" CONTENT "${text}\n" @ONLY)
endfunction()

# add_sanitizers(target): when asked for by the preset, a broken rule stops the program at once.
# -Wno-maybe-uninitialized: instrumented code makes g++ 12 see uninitialised members inside std::regex.
function(add_sanitizers target)
  if(HALFSPACE_SANITIZE)
    target_compile_definitions(${target} PUBLIC _GLIBCXX_ASSERTIONS)
    target_compile_options(${target} PUBLIC
      -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
      -Wno-maybe-uninitialized)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# add_test_options(target COMPUTES|""): does not optimise, because most tests compute little and optimising would double
# the time to build them. Tests that COMPUTES marks are optimised a little: of a template that library and test both
# instantiate, such as Eigen's product of matrices, the linker keeps the test's.
function(add_test_options target computes)
  set(level $<IF:$<AND:$<BOOL:${computes}>,$<NOT:$<BOOL:${HALFSPACE_SANITIZE}>>>,-O1,-O0>)
  target_compile_options(${target} PRIVATE $<$<OR:$<CONFIG:Release>,$<BOOL:${HALFSPACE_SANITIZE}>>:${level}>)
  add_sanitizers(${target})
endfunction()

# precompile_tests(target COMPUTES|""): what every test includes, read once.
function(precompile_tests target computes)
  add_library(${target} STATIC "${PROJECT_SOURCE_DIR}/src/toolchain/cmake/precompiled.cpp")
  target_precompile_headers(${target} PRIVATE
    <Eigen/Core> <boost/test/unit_test.hpp> <fmt/core.h>
    <algorithm> <cmath> <filesystem> <functional> <limits> <map> <numbers> <set> <string> <vector>)
  target_link_libraries(${target}
    PRIVATE Boost::unit_test_framework unit_test_main project_warnings PUBLIC Eigen3::Eigen fmt::fmt)
  add_test_options(${target} "${computes}")
endfunction()

# add_test_program(target [COMPUTES] SOURCES file … LINK library … [DEFINE macro …]): a program of Boost tests.
function(add_test_program target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COMPUTES" "" "SOURCES;LINK;DEFINE")
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE ${arg_LINK} unit_test_main)
  target_compile_definitions(${target} PRIVATE ${arg_DEFINE})
  if(NOT HALFSPACE_EVERYTHING)
    return()
  endif()
  set(precompiled precompiled_tests)
  set(computes "")
  if(arg_COMPUTES)
    set(precompiled precompiled_computing_tests)
    set(computes COMPUTES)
  endif()
  target_link_libraries(${target} PRIVATE ${precompiled} project_warnings)
  add_test_options(${target} "${computes}")
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
endfunction()

# add_unit_tests(folder [COMPUTES] LINK library … [DEFINE macro …] [SOURCES file …] [NAMES name …] [SLOW name seconds …]): the tests
# of one folder are one program, because each program of its own takes the compiler three seconds, and each file
# tests/folder/name_test.cpp is one CTest test, unit/folder/name, which runs the suite name_test. `make test` and the
# sanitizers run those of NAMES. Those of SLOW are a second program, folder_slow_tests; each takes about so many seconds,
# so that only `make test-all` runs it, as slow/folder/name, and begins it before shorter ones. SOURCES are linked to both.
function(add_unit_tests folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COMPUTES" "" "LINK;DEFINE;SOURCES;NAMES;SLOW")
  set(options LINK ${arg_LINK} DEFINE ${arg_DEFINE})
  if(arg_COMPUTES)
    list(PREPEND options COMPUTES)
  endif()
  if(arg_NAMES)
    set(sources ${arg_NAMES})
    list(TRANSFORM sources REPLACE "(.+)" "${HALFSPACE_ROOT}/tests/${folder}/\\1_test.cpp")
    add_test_program(${folder}_tests SOURCES ${sources} ${arg_SOURCES} ${options})
  endif()
  foreach(name IN LISTS arg_NAMES)
    cmake_path(GET name FILENAME suite)
    add_test(NAME unit/${folder}/${name} COMMAND ${folder}_tests --run_test=${suite}_test --color_output=no)
    label_test(unit/${folder}/${name} unit TARGET ${folder}_tests)
  endforeach()
  set(sources "")
  while(arg_SLOW)
    list(POP_FRONT arg_SLOW name seconds)
    cmake_path(GET name FILENAME suite)
    add_test(NAME slow/${folder}/${name} COMMAND ${folder}_slow_tests --run_test=${suite}_test --color_output=no)
    label_test(slow/${folder}/${name} slow COST ${seconds})
    list(APPEND sources "${HALFSPACE_ROOT}/tests/${folder}/${name}_test.cpp")
  endwhile()
  if(sources)
    add_test_program(${folder}_slow_tests SOURCES ${sources} ${arg_SOURCES} ${options})
  endif()
endfunction()

# add_script_test(test file [TARGET program] [COST seconds] [ARGS argument …]): a script in the place of a program; it gets the
# repository and then these arguments, and is skipped by its exit code 77. The test's name begins with its label.
function(add_script_test test file)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "TARGET;COST;ARGS")
  set(interpreter bash)
  if(file MATCHES "[.]py$")
    set(interpreter python3 -B)
  endif()
  add_test(NAME ${test} COMMAND ${interpreter} "${CMAKE_CURRENT_SOURCE_DIR}/${file}" "${HALFSPACE_ROOT}" ${arg_ARGS})
  set_tests_properties(${test} PROPERTIES SKIP_RETURN_CODE 77)
  string(REGEX REPLACE "/.*" "" label "${test}")
  label_test(${test} ${label} TARGET ${arg_TARGET} COST ${arg_COST})
endfunction()

# label_test(test label [TARGET program] [COST seconds]): who runs the CTest test. `unit`: `make test` and the
# sanitizers; `everyday`: `make test`; `slow`: `make test-all` alone, which runs every test. TARGET is the program that
# the test needs and that is compiled for it. Unit tests that need none have the label `script` as well: another build of the
# same sources, as with the sanitizers, has nothing to add to them.
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
