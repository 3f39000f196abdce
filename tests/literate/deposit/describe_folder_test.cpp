// SPDX-License-Identifier: GPL-3.0-or-later
// That both files follow their specifications is tests/end_to_end/describe_test.sh.
#include "literate/deposit/describe_folder.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "holds.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(describe_folder_test)

using namespace literate;

namespace {

const std::string digest_of_data = sys::sha256_of_text("data");

Manifest some_manifest() {
  return {.project = "toy",
          .facts = {{"sources", {{"date", "2026-11-21T12:00:00Z"}, {"commit", "abc"}}}},
          .inputs = {{"case.toml", sys::sha256_of_text("case")}},
          .outputs = {{"generated/tables/t.csv", digest_of_data}},
          .numbers = {},
          .verdicts = {}};
}

Citation some_citation() {
  return {.title = "A \"work\": of 1.0",
          .authors = {{.name = "Ada L", .is_person = true, .orcid = "https://orcid.org/0000-0001"}},
          .license = "MIT",
          .doi = "10.1/x"};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_file_is_known_by_its_content_whatever_it_is_called) {
  const TemporaryFolder folder;
  sys::write_file_atomically(folder / "anc/t.csv", "data");
  sys::write_file_atomically(folder / "my.toml", "case");
  sys::write_file_atomically(folder / "notes.txt", "other");

  const auto files = deposited_files(folder.path(), some_manifest());

  BOOST_REQUIRE(files.size() == 3U);
  BOOST_TEST((files[0].part == Part::output));
  BOOST_TEST((files[1].part == Part::input));
  BOOST_TEST((files[2].part == Part::other));
  BOOST_TEST(files[0].size == 4U);
  BOOST_TEST(files[0].sha256 == digest_of_data);
}

BOOST_AUTO_TEST_CASE(codecheck_quotes_texts_and_gives_the_orcid_without_its_address) {
  const std::string text = codecheck_yml(some_citation(), some_manifest(),
                                         {{"tables/t.csv", digest_of_data, 4, Part::output}});

  BOOST_TEST(text.starts_with("%YAML 1.1\n---\n"));
  BOOST_TEST(holds(text, R"(title: "A \"work\": of 1.0")"));
  BOOST_TEST(holds(text, R"(ORCID: "0000-0001")"));
  BOOST_TEST(holds(text, R"(comment: "table t")"));
  BOOST_TEST(holds(text, R"(reference: "https://doi.org/10.1/x")"));
  BOOST_TEST(holds(text, R"(source: "commit abc of toy")"));
}

BOOST_AUTO_TEST_CASE(a_crate_without_date_or_license_is_refused) {
  Manifest manifest = some_manifest();
  Citation citation = some_citation();
  manifest.facts.clear();

  BOOST_CHECK_THROW(ro_crate_json(citation, manifest, {}), sys::InputError);
  citation.date = "2026-11-20";
  BOOST_TEST(holds(ro_crate_json(citation, manifest, {}), R"("datePublished": "2026-11-20")"));
  citation.license.clear();
  BOOST_CHECK_THROW(ro_crate_json(citation, manifest, {}), sys::InputError);
}

BOOST_AUTO_TEST_CASE(names_become_uri_references) {
  const std::string text = ro_crate_json(some_citation(), some_manifest(),
                                         {{"50 % of #1?.csv", digest_of_data, 4, Part::output}});

  BOOST_TEST(holds(text, R"("@id": "50%20%25%20of%20%231%3F.csv")"));
  BOOST_TEST(holds(text, R"("@id": "#input/case.toml")"));
}

BOOST_AUTO_TEST_CASE(describing_again_changes_nothing) {
  const TemporaryFolder folder;
  sys::write_file_atomically(folder / "t.csv", "data");
  describe_folder(folder.path(), some_manifest(), some_citation());
  const std::string first = sys::read_file(folder / "ro-crate-metadata.json");

  describe_folder(folder.path(), some_manifest(), some_citation());

  BOOST_TEST(sys::read_file(folder / "ro-crate-metadata.json") == first);
}

BOOST_AUTO_TEST_SUITE_END()
