// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/statements.hpp"

#include <boost/test/unit_test.hpp>

#include "holds.hpp"
#include "literate/prose/references.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(statements_test)

using namespace literate;
using boost::test_tools::per_element;

namespace {

Names names_with(const std::map<std::string, NamedClaim>& claims) {
  Names names;
  names.flags = {{"printed", false}};
  names.flag_places = {{"printed", "fruit.cpp:3"}};
  names.claims = claims;
  return names;
}

const Names names = names_with({{"apples", {"fruit.cpp:12:3", "confirmed", "confirmed"}},
                                {"pears", {"fruit.cpp:20:3", "confirmed", "refuted"}},
                                {"plums", {"fruit.cpp:31:3", "refuted", "refuted"}}});

// The statements of a document with this text.
struct Text {
  explicit Text(const std::string& text) { folder.write("market/main.tex", text); }
  std::filesystem::path source() const { return folder.path() / "market"; }
  std::vector<Statement> statements() const { return statements_below(source()); }
  std::vector<std::string> errors() const { return statement_errors(statements(), names); }

  TemporaryFolder folder;
};

const std::string all_three =
    "\\statement[a book, p.~3]{apples}{Apples are dear.}\n"
    "\\statement{pears}{Pears are cheap.}\n"
    "\\statement{plums}{Plums are cheap.}\n";

}  // namespace

BOOST_AUTO_TEST_CASE(a_statement_has_its_source_its_sentence_and_its_place) {
  const Text text(
      "Fruit.\n  \\statement[a book,\n p.~3]{apples}{% of the shop\n  Apples $a_i$ are\n"
      "  \\emph{dear}.}\n% \\statement{pears}{A comment.}\n");

  const auto statements = text.statements();

  BOOST_TEST_REQUIRE(statements.size() == 1U);
  BOOST_TEST(statements[0].id == "apples");
  BOOST_TEST(statements[0].source == "a book, p.~3");
  BOOST_TEST(statements[0].sentence == "Apples $a_i$ are \\emph{dear}.");
  BOOST_TEST(statements[0].place == "market/main.tex:2:3");
}

BOOST_AUTO_TEST_CASE(an_id_that_only_one_side_knows_is_an_error_with_place_and_nearest_name) {
  BOOST_TEST(Text(all_three).errors() == std::vector<std::string>{}, per_element());

  const Text misspelt(
      "\\statement{aples}{Apples are dear.}\n \\statement{pears}{Pears are cheap.}\n"
      "\\statement{plums}{Plums are cheap.}\n");
  const std::vector<std::string> expected = {
      "market/main.tex:1:1: unknown claim 'aples', did you mean 'apples'?",
      "fruit.cpp:12:3: claim 'apples' has no \\statement in the document, did you mean 'aples'?"};
  BOOST_TEST(misspelt.errors() == expected, per_element());
  BOOST_TEST(check_references(misspelt.source(), names).errors == expected, per_element());
}

BOOST_AUTO_TEST_CASE(a_statement_without_sentence_or_made_twice_is_an_error) {
  const std::vector<std::string> expected = {
      "market/main.tex:4:1: statement 'pears' has no sentence",
      "market/main.tex:4:1: claim 'pears' is stated twice, first at market/main.tex:2:1"};

  BOOST_TEST(Text(all_three + "\\statement{pears}{ }\n").errors() == expected, per_element());
}

BOOST_AUTO_TEST_CASE(a_statement_in_a_branch_that_is_not_taken_needs_no_claim) {
  const Text text(all_three + "\\ifflag{printed}{\\statement{quinces}{None.}}{}\n");

  BOOST_TEST(text.errors() == std::vector<std::string>{}, per_element());
  BOOST_TEST(lacks(statements_tex(text.statements(), names), "quinces"));
}

BOOST_AUTO_TEST_CASE(statements_of_others_and_own_ones_are_numbered_and_counted_apart) {
  const std::string tex = statements_tex(Text(all_three).statements(), names);

  for (const char* line :
       {"\\LiterateStatement{apples}{C1}{cited}{a book, p.~3}{Apples are dear.}\n",
        "\\LiterateStatement{pears}{R1}{own}{}{Pears are cheap.}\n",
        "\\LiterateStatement{plums}{R2}{own}{}{Plums are cheap.}\n",
        "\\LiterateCount{cited}{all}{1}\n", "\\LiterateCount{cited}{confirmed}{1}\n",
        "\\LiterateCount{cited}{unexpected}{0}\n", "\\LiterateCount{own}{all}{2}\n",
        "\\LiterateCount{own}{refuted}{2}\n", "\\LiterateCount{own}{unexpected}{1}\n"}) {
    BOOST_TEST(holds(tex, line));
  }
}

BOOST_AUTO_TEST_CASE(statements_are_numbered_in_the_order_of_reading) {
  Text text(
      "\\documentclass{article}\\input{z}\\statement{plums}{Plums are cheap.}\\include{a.tex}");
  text.folder.write("market/a.tex", "\\statement{apples}{Apples are cheap.}");
  text.folder.write("market/z.tex", "\\statement{pears}{Pears are cheap.}\\input{z}");

  std::vector<std::string> numbers;
  for (const auto& [number, statement] : numbered_statements(text.statements(), names)) {
    numbers.push_back(number + " " + statement.id);
  }

  const std::vector<std::string> expected = {"R1 pears", "R2 plums", "R3 apples"};
  BOOST_TEST(numbers == expected, per_element());
}

BOOST_AUTO_TEST_CASE(what_others_state_is_quoted_or_called_a_paraphrase) {
  const Text text(
      "\\statement[a book, p.~3]{apples}{Apples are dear.}\n"
      "\\statement[paraphrase of a book]{pears}{Pears are cheap.}\n"
      "\\statement[a book]{plums}{Of plums: \\quoted{cheap}.}\n");

  const std::vector<std::string> expected = {
      "market/main.tex:1:1: statement 'apples' is neither a quotation nor says 'paraphrase' in its "
      "source"};
  BOOST_TEST(unquoted_statements(text.statements()) == expected, per_element());
}

BOOST_AUTO_TEST_SUITE_END()
