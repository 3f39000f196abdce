// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/deposit/citation.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(citation_test)

using namespace literate;

namespace {

Citation citation(const std::string& text) {
  const TemporaryFolder folder;
  sys::write_file_atomically(folder / "CITATION.cff", text);
  return read_citation(folder / "CITATION.cff");
}

std::string error_of(const std::string& text) {
  const std::string message = message_of<sys::InputError>([&] { citation(text); });
  const auto name = message.find("CITATION.cff:");
  return name == std::string::npos ? message : message.substr(name);
}

}  // namespace

BOOST_AUTO_TEST_CASE(persons_and_groups_are_authors) {
  const Citation read = citation(
      "title: A work\n"
      "authors:\n"
      "  - {given-names: Ludwig, name-particle: van, family-names: B, orcid: https://orcid.org/1}\n"
      "  - name: The developers\n");

  BOOST_REQUIRE(read.authors.size() == 2U);
  BOOST_TEST(read.authors[0].name == "Ludwig van B");
  BOOST_TEST(read.authors[0].is_person);
  BOOST_TEST(read.authors[0].orcid == "https://orcid.org/1");
  BOOST_TEST(read.authors[1].name == "The developers");
  BOOST_TEST(!read.authors[1].is_person);
}

BOOST_AUTO_TEST_CASE(what_a_citation_leaves_out_is_empty_and_texts_stay_as_they_are_written) {
  const Citation read = citation("title: A work\nauthors: [{name: x}]\ndoi: 10.10\n");

  BOOST_TEST(read.doi == "10.10");
  BOOST_TEST(read.license.empty());
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_told_with_its_place) {
  BOOST_TEST(error_of("authors: [{name: x}]\n") == "CITATION.cff:1:1: there is no title");
  BOOST_TEST(error_of("title: A work\n") == "CITATION.cff:1:1: there are no authors");
  BOOST_TEST(error_of("title: A work\nauthors:\n  - {alias: x}\n") ==
             "CITATION.cff:3:5: an author has no name");
  BOOST_TEST(error_of("title: A work\nauthors:\n  - x\n") ==
             "CITATION.cff:3:5: an author has a name, or given and family names");
  BOOST_TEST(error_of("just text\n") == "CITATION.cff:1:1: is not a CITATION.cff");
  BOOST_TEST(error_of("title: [A work\n").starts_with("CITATION.cff:2:1: "));
  BOOST_CHECK_THROW(read_citation("/nowhere/CITATION.cff"), sys::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
