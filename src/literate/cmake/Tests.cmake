# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of the engine alone; -DBUILD_TESTING=OFF leaves them and Boost.Test out.
enable_testing()
find_package(Boost 1.74 REQUIRED CONFIG COMPONENTS unit_test_framework)
set(CMAKE_UNITY_BUILD OFF) # a test program is one file
set(tests "${HALFSPACE_ROOT}/tests")
add_library(unit_test_main STATIC "${tests}/main.cpp")
target_compile_definitions(unit_test_main PUBLIC BOOST_TEST_DYN_LINK)
target_include_directories(unit_test_main PUBLIC "${tests}")
target_link_libraries(unit_test_main PUBLIC Boost::unit_test_framework fmt::fmt)
add_custom_target(everyday_tests)
add_custom_target(unit_tests)
foreach(folder IN ITEMS system config literate)
  add_subdirectory("${tests}/${folder}" "tests/${folder}")
endforeach()
