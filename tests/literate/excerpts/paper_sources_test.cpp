// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/paper_sources.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(paper_sources_test)

using Lines = std::vector<std::string>;

BOOST_AUTO_TEST_CASE(all_files_below_are_found_in_order) {
  const TemporaryFolder folder;
  folder.write("b/c.cpp", "");
  folder.write("a.hpp", "");
  folder.write("CMakeLists.txt", "add_library(a a.cpp)\n");

  BOOST_TEST(
      literate::paper_sources(folder.path()) == (Lines{"CMakeLists.txt", "a.hpp", "b/c.cpp"}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_paper_below_keeps_its_sources_to_itself) {
  const TemporaryFolder folder;
  folder.write("a.cpp", "");
  folder.write("template/CMakeLists.txt", "project(mine)\nliterate_add_paper(NAME mine)\n");
  folder.write("template/src/a.cpp", "");
  folder.write("templates.cpp", "");

  BOOST_TEST(literate::paper_sources(folder.path()) == (Lines{"a.cpp", "templates.cpp"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_there_is_named) {
  const TemporaryFolder folder;
  BOOST_CHECK_EXCEPTION(literate::paper_sources(folder / "none"), sys::OutputError,
                        [](const sys::OutputError& error) {
                          return std::string(error.what()).find("none") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_SUITE_END()
