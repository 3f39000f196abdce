// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/entries.hpp"

#include <boost/test/unit_test.hpp>

#include "config/table.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(entries_test)

BOOST_AUTO_TEST_CASE(each_entry_of_a_case_is_one_text_under_its_whole_key) {
  const TemporaryFolder folder;

  const auto entries = config::entries_of(folder.write(
      "case.toml",
      "title = 'a \"b\"'\nn = 12\nx = 0.1\nis_on = true\nlength = {value = 39.4, unit = \"in\"}\n"
      "angles = [10,\n  30]\n[load]\npeak = {value = 30e6, unit = \"psi\"}\n[load.edge]\nx = 1\n"
      "[[body]]\nname = 'first'\n[[body]]\nname = 'second'\n"));

  const std::map<std::string, std::string> expected = {{"title", "a \"b\""},
                                                       {"n", "12"},
                                                       {"x", "0.1"},
                                                       {"is_on", "true"},
                                                       {"length", "39.4 in"},
                                                       {"angles", "[ 10, 30 ]"},
                                                       {"load.peak", "30000000 psi"},
                                                       {"load.edge.x", "1"},
                                                       {"body.1.name", "first"},
                                                       {"body.2.name", "second"}};
  BOOST_TEST(entries.size() == expected.size());
  for (const auto& [key, text] : expected) {
    BOOST_TEST(entries.contains(key), key);
    if (entries.contains(key)) BOOST_TEST(entries.at(key) == text);
  }
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_toml_is_refused) {
  const TemporaryFolder folder;
  BOOST_CHECK_THROW(config::entries_of(folder.write("case.toml", "a = \n")), config::Error);
  BOOST_CHECK_THROW(config::entries_of(folder / "none.toml"), config::Error);
}

BOOST_AUTO_TEST_SUITE_END()
