// SPDX-License-Identifier: GPL-3.0-or-later
// What the report claims: enough of it, complete, with every verdict as its prose says.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "literate/document/document.hpp"
#include "literate/prose/statements.hpp"
#include "paper/paper.hpp"
#include "system/files.hpp"

BOOST_AUTO_TEST_SUITE(claims_test)

using literate::Claim;
using literate::Document;
using literate::Verdict;

namespace {

const std::string source_dir = HALFSPACE_SOURCE_DIR;

Document computed(const std::string& file) {
  Document document;
  paper::compute(document, parameters::read_case(source_dir + "/" + file));
  return document;
}

const Document& papers() {
  static const Document document = computed("report/ruggiero2001.toml");
  return document;
}

const Document& steel() {
  static const Document document = computed("tests/end_to_end/steel_mm.toml");
  return document;
}

// The statements of the report's prose by the ids of their claims.
const std::map<std::string, literate::Statement>& statements() {
  static const auto by_id = [] {
    std::map<std::string, literate::Statement> found;
    for (const auto& statement : literate::statements_below(source_dir + "/report")) {
      BOOST_TEST(found.emplace(statement.id, statement).second, statement.id);
    }
    return found;
  }();
  return by_id;
}

Verdict verdict(const Document& document, const std::string& id) {
  const auto found =
      std::ranges::find(document.claims(), id, &std::pair<std::string, Claim>::first);
  BOOST_TEST_REQUIRE((found != document.claims().end()), id << " is not claimed");
  return found->second.found();
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_verdict_is_the_expected_one) {
  for (const Document* document : {&papers(), &steel()}) {
    BOOST_TEST(document->faults() == std::vector<std::string>{}, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(every_claim_has_a_sentence_with_its_source_and_criteria_with_their_reasons) {
  const std::regex sentence(R"([A-Z\\$].{15,}\.)");
  const std::regex source(R"(((paraphrase of the )?paper, .*pp?\.~\d+.*)?)");
  for (const Document* document : {&papers(), &steel()}) {
    std::set<std::string> sentences;
    for (const auto& [id, claim] : document->claims()) {
      BOOST_TEST_CONTEXT(id) {
        const literate::Statement& statement = statements().at(id);
        BOOST_TEST(std::regex_match(statement.sentence, sentence), statement.sentence);
        BOOST_TEST(std::regex_match(statement.source, source), statement.source);
        BOOST_TEST(sentences.insert(statement.sentence).second, statement.sentence);
        BOOST_TEST(claim.route.size() > 15U, claim.route);
        BOOST_TEST(!claim.route.ends_with("."), claim.route);
        for (const literate::Criterion& criterion : claim.criteria) {
          BOOST_TEST(!criterion.reason().ends_with("."), criterion.reason());
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_the_paper_says_is_quoted_or_called_a_paraphrase) {
  const auto all = literate::statements_below(source_dir + "/report");

  BOOST_TEST(literate::unquoted_statements(all) == std::vector<std::string>{},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(claims_about_print_need_print_and_claims_of_theory_do_not) {
  for (const auto& [id, claim] : steel().claims()) verdict(papers(), id);
  for (const char* id : {"error-of-z", "same-load", "contact-m-load", "insensitive-to-c"}) {
    BOOST_CHECK(verdict(papers(), id) == Verdict::refuted);
    BOOST_TEST(std::ranges::none_of(steel().claims(),
                                    [&](const auto& entry) { return entry.first == id; }));
  }
  BOOST_CHECK(verdict(steel(), "equation-3-follows") == Verdict::confirmed);
}

BOOST_AUTO_TEST_CASE(every_claim_is_set_in_the_prose_once_or_more) {
  std::string prose;
  for (const std::string& file : sys::files_below(source_dir + "/report/sections")) {
    prose += sys::read_file(source_dir + "/report/sections/" + file);
  }
  for (const auto& [id, claim] : papers().claims()) {
    BOOST_TEST((prose.find("\\claim{" + id + "}") != std::string::npos), id << " is not set");
  }
}

BOOST_AUTO_TEST_SUITE_END()
