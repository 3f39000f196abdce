# SPDX-License-Identifier: GPL-3.0-or-later

# add_precompiled_headers(): what nearly every file includes, read once instead of 200 times; a third of the time to
# compile. Files include what they use all the same, and CMAKE_DISABLE_PRECOMPILE_HEADERS (preset tidy) proves it.
function(add_precompiled_headers)
  add_library(precompiled STATIC "${PROJECT_SOURCE_DIR}/src/toolchain/cmake/precompiled.cpp")
  target_precompile_headers(precompiled PRIVATE
    <Eigen/Core> <fmt/core.h>
    <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <numbers> <optional> <set>
    <stdexcept> <string> <utility> <vector>)
  target_link_libraries(precompiled PUBLIC Eigen3::Eigen fmt::fmt PRIVATE project_warnings)
  target_compile_options(precompiled PRIVATE $<$<CONFIG:Release>:-O1>)
  add_sanitizers(precompiled)
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
  if(type STREQUAL INTERFACE_LIBRARY)
    target_include_directories(${target} INTERFACE "${exported}")
  else()
    target_include_directories(${target} PUBLIC "${exported}")
  endif()
endfunction()

# add_folder_library(name [FOLDER folder] [HEADERS …] [ROOMS …] [NO_HEAVY_COMPUTING] [BATCHES] SOURCES … LINK …
# PRIVATE_LINK …): the library of one folder of src. LINK and PRIVATE_LINK are the architecture: the
# headers of other folders are found through them only. HEADERS: those that are exported, if not all of the folder.
# ROOMS: the folders within, in their order; each uses only those before it (tests/toolchain/architecture_test.cpp).
# NO_HEAVY_COMPUTING: what the compiler would take to optimise it fully is more than that would ever save. BATCHES:
# eight files are compiled as one, in a third of the time; for folders that one seldom changes, since a change then
# compiles eight. (The preset sanitize, which is always compiled anew, has batches everywhere.)
function(add_folder_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_HEAVY_COMPUTING;BATCHES" "FOLDER" "HEADERS;ROOMS;SOURCES;LINK;PRIVATE_LINK")
  if(NOT arg_FOLDER)
    cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME arg_FOLDER)
  endif()
  list(JOIN arg_ROOMS " " rooms)
  list(JOIN arg_LINK " " links)
  list(JOIN arg_PRIVATE_LINK " " private_links)
  set_property(GLOBAL APPEND PROPERTY HALFSPACE_ARCHITECTURE "${name}|${arg_FOLDER}|${links} ${private_links}|${rooms}")
  add_library(${name} STATIC ${arg_SOURCES})
  export_headers(${name} ${arg_FOLDER} ${arg_HEADERS})
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE_LINK} project_warnings)
  if(arg_NO_HEAVY_COMPUTING)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(arg_BATCHES)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
  add_sanitizers(${name})
  target_link_libraries(${name} PRIVATE precompiled)
  target_precompile_headers(${name} REUSE_FROM precompiled)
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

# add_test_options(target): tests compute little, and half of the time to build them would go into optimising.
function(add_test_options target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<BOOL:${HALFSPACE_SANITIZE}>:-O0>)
  add_sanitizers(${target})
endfunction()

# add_test_program(target source [HEAVY_COMPUTING] LINK …): a program of Boost tests. HEAVY_COMPUTING: one that would run
# longer under the sanitizers than optimising it takes.
function(add_test_program target source)
  cmake_parse_arguments(PARSE_ARGV 2 arg "HEAVY_COMPUTING" "" "LINK")
  add_executable(${target} "${source}")
  target_link_libraries(${target} PRIVATE ${arg_LINK} unit_test_main precompiled_tests project_warnings)
  if(arg_HEAVY_COMPUTING AND HALFSPACE_SANITIZE)
    add_sanitizers(${target})
  else()
    add_test_options(${target})
    target_precompile_headers(${target} REUSE_FROM precompiled_tests)
  endif()
endfunction()

# add_unit_test(folder/name [SLOW seconds] [HEAVY_COMPUTING] LINK …): tests/folder/name_test.cpp as one program and one CTest test, labelled
# `unit` and part of the target unit_tests, or `slow` and begun before shorter ones.
function(add_unit_test test)
  cmake_parse_arguments(PARSE_ARGV 1 arg "HEAVY_COMPUTING" "SLOW" "LINK")
  string(REPLACE "/" "_" target "${test}_test")
  set(kind "")
  if(arg_HEAVY_COMPUTING)
    set(kind HEAVY_COMPUTING)
  endif()
  add_test_program(${target} "${PROJECT_SOURCE_DIR}/tests/${test}_test.cpp" ${kind} LINK ${arg_LINK})
  if(DEFINED arg_SLOW)
    add_test(NAME "slow/${test}" COMMAND ${target} --color_output=no)
    set_tests_properties("slow/${test}" PROPERTIES LABELS slow COST ${arg_SLOW})
  else()
    add_test(NAME "unit/${test}" COMMAND ${target} --color_output=no)
    set_tests_properties("unit/${test}" PROPERTIES LABELS unit)
    add_dependencies(unit_tests ${target})
  endif()
endfunction()
