// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt_coverage.hpp"

#include <boost/test/unit_test.hpp>

#include "literate/excerpts/find_excerpts.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(excerpt_coverage_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(only_lines_of_code_count_shown_or_not) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "src/mass/shown.cpp",
                             "#include <x>\n\n// comment\nint a;\n// begin excerpt: heart\n"
                             "// why\nint b;\n\n  int c;\n// end excerpt: heart\n");
  sys::write_file_atomically(scratch / "src/mass/rest.cpp", "int d;\nint e;\n");
  sys::write_file_atomically(scratch / "src/mass/header.hpp", "int f;\n");

  const ExcerptCoverage coverage =
      coverage_of(scratch / "", "src/mass", find_excerpts(scratch / "", {"src"}));

  BOOST_TEST(coverage.n_lines == 5);
  BOOST_TEST(coverage.n_shown == 2);
  BOOST_TEST(coverage.rest == std::vector<std::string>{"rest.cpp"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_there_is_an_error) {
  const TemporaryFolder scratch;

  BOOST_CHECK_THROW(coverage_of(scratch / "", "src/none", {}), std::exception);
}

BOOST_AUTO_TEST_SUITE_END()
