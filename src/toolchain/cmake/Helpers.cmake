# SPDX-License-Identifier: GPL-3.0-or-later

# add_folder_library(name [NO_HEAVY_COMPUTING] SOURCES … LINK …): the library of one folder of src (or figures).
# Headers are included as "folder/name.hpp"; LINK is the architecture. NO_HEAVY_COMPUTING: what the compiler
# would take to optimise it fully is more than that would ever save.
function(add_folder_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_HEAVY_COMPUTING" "" "SOURCES;LINK;PRIVATE_LINK")
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}/src" "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE_LINK} project_warnings)
  if(arg_NO_HEAVY_COMPUTING)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  add_sanitizers(${name})
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

# add_unit_test(folder/name LINK …): tests/folder/name_test.cpp as one program and one CTest test.
function(add_unit_test test)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK")
  string(REPLACE "/" "_" target "${test}_test")
  add_executable(${target} "${PROJECT_SOURCE_DIR}/tests/${test}_test.cpp")
  target_link_libraries(${target} PRIVATE ${arg_LINK} unit_test_main project_warnings)
  add_sanitizers(${target})
  if(HALFSPACE_SANITIZE)
    target_compile_options(${target} PRIVATE -O0) # half of the preset's time would go into optimising tests
  endif()
  add_test(NAME "unit/${test}" COMMAND ${target} --color_output=no)
  set_tests_properties("unit/${test}" PROPERTIES LABELS unit)
endfunction()
