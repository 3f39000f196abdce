// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/inputs.hpp"

#include <boost/test/unit_test.hpp>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(inputs_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(a_part_that_is_not_there_is_told_with_its_place_and_the_nearest_name) {
  const TemporaryFolder scratch;
  const auto folder = scratch / "report";
  sys::write_file_atomically(folder / "main.tex",
                             "\\input{parts/theory}\\input{parts/theory.tex}\n"
                             "% \\input{none}\n \\include{parts/teory}\\input{values}\\input{\\x}\n");
  sys::write_file_atomically(folder / "parts/theory.tex", "");
  sys::write_file_atomically(scratch / "generated/values.tex", "");

  BOOST_TEST(missing_inputs(folder, scratch / "generated") ==
                 (std::vector<std::string>{"report/main.tex:3:2: there is no file 'parts/teory', "
                                           "did you mean 'parts/theory'?"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
