// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document_tex.hpp"
#include "literate/document/ledger.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "literate/document/names.hpp"
#include "literate/prose/statements.hpp"
#include "literate/typesetting/typeset.hpp"
#include "message_of.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(document_tex_test)

using namespace literate;
using boost::test_tools::per_element;

namespace {

const std::string here = "tests/literate/document/document_tex_test.cpp:";

Criterion price_at_most(double limit, const std::string& name = "price") {
  return Criterion::at_most(name, Value({2.612, 0.001}, fixed(2), "{kr}"),
                            {LimitKind::data, limit, "half of the last digit more"});
}

// A price that is as stated, or one that is not beside it.
Claim claim_of_apples(Verdict found) {
  Claim claim{.route = "weighing and adding up",
              .expected = Verdict::confirmed,
              .criteria = {price_at_most(found == Verdict::refuted ? 2.5 : 2.65)}};
  if (found == Verdict::partly) claim.criteria.push_back(price_at_most(2.5, "low price"));
  return claim;
}

Document document_with(Verdict found) {
  Document document;
  document.claim("apples", claim_of_apples(found));
  return document;
}

// The faults without the lines of this file, where each begins.
std::vector<std::string> without_lines(std::vector<std::string> faults) {
  for (std::string& fault : faults) {
    BOOST_TEST(fault.starts_with(here), fault);
    fault.erase(0, fault.find(": ") + 2);
  }
  return faults;
}

// The text of every page of a document with this claim; the preamble and the first page as asked,
// and as many pages as are asked for.
std::vector<std::string> pages_with(Verdict found, const std::string& preamble = "",
                                    const std::string& first = "Apples \\claim{apples}.",
                                    int n_others = 0, int n_pages = 3) {
  const TemporaryFolder scratch;
  Document document = document_with(found);
  std::string others;
  for (int i = 0; i < n_others; ++i) {
    const std::string id = "other-" + std::to_string(i);
    document.claim(id, claim_of_apples(Verdict::confirmed));
    others += "\\statement[market]{" + id + "}{Another costs 2.6.}\n\nAnother \\claim{" + id + "}.";
  }
  document.value("unused", Value(1, integer()));
  document.write(scratch / "generated");
  sys::write_file_atomically(
      scratch / "text/main.tex",
      "\\documentclass{article}\\usepackage{literate,hyperref}\n" + preamble +
          "\n\\begin{document}\\statement[market, stall~3]{apples}{An apple costs 2.6.}" + first +
          others +
          "\\newpage More.\\newpage\n"
          "\\claimledger\\end{document}\n");
  write_statements(scratch / "text", read_names(scratch / "generated/names.json"),
                   scratch / "latex/statements.tex");
  typeset({.source_dir = scratch / "text",
           .main_file = "main.tex",
           .generated_dir = scratch / "generated",
           .build_dir = scratch / "latex",
           .output_pdf = scratch / "main.pdf"});
  std::vector<std::string> pages;
  for (int i = 1; i <= n_pages; ++i) {
    const std::string page = std::to_string(i);
    const sys::ProcessResult text = sys::run(
        {.program = "pdftotext",
         .arguments = {"-layout", "-f", page, "-l", page, (scratch / "main.pdf").string(), "-"}});
    BOOST_TEST_REQUIRE(text.exit_status == 0, text.output);
    pages.push_back(text.output);
  }
  return pages;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_ledger_holds_every_part_of_a_claim) {
  Document document = document_with(Verdict::confirmed);
  Claim pears = claim_of_apples(Verdict::refuted);
  pears.expected = Verdict::refuted;
  document.claim("pears", pears);

  const std::string text = claims_tex(document.registered());

  for (const char* part :
       {"\\LiterateLedgerEntry{apples}", "{weighing and adding up}", "{confirmed}{confirmed}",
        "{faults not known}{%",
        "\\LiterateCriterion{price}{\\qty{2.61}{kr}}{$\\le$~\\qty{2.65}{kr}}"
        "{a}{1.0 times; 38 errors}{holds}{}",
        "\\LiterateLimitNote{a}{data}{half of the last digit more}", "\\LiterateLedgerEntry{pears}",
        "{refuted}{refuted}", "{fails}{}", "document\\_tex\\_test.cpp:"}) {
    BOOST_TEST(holds(text, part));
  }
  BOOST_TEST(holds(values_tex(document.registered()), "\\LiterateClaim{apples}{confirmed}\n"));
  BOOST_TEST(holds(values_tex(document.registered()), "\\LiterateClaim{pears}{refuted}"));
}

BOOST_AUTO_TEST_CASE(the_ledger_prints_every_criterion_of_a_claim) {
  const std::string text = claims_tex(document_with(Verdict::partly).registered());

  BOOST_TEST(holds(text, "{$\\le$~\\qty{2.65}{kr}}{a}{1.0 times; 38 errors}{holds}{}"));
  BOOST_TEST(holds(text, "{$\\le$~\\qty{2.5}{kr}}{a}{1.0 times; 112 errors}{fails}{}"));
}

BOOST_AUTO_TEST_CASE(specials_of_latex_are_escaped_in_every_text) {
  const std::string special = R"(5 % of a_b & #1 {x} ~ ^ \ "<|>" ν² ≤)";
  Claim claim = claim_of_apples(Verdict::confirmed);
  claim.route = special;
  const Criterion criterion =
      Criterion::at_most(special, Value(1, integer()), {LimitKind::data, 1.0, special});
  claim.criteria = {Criterion::in_each(special, special, {criterion})};
  Document document;
  document.claim("apples", claim);

  const std::string escaped =
      R"(5 \% of a\_b \& \#1 \{x\} \textasciitilde{} \textasciicircum{} \textbackslash{} )";
  for (const auto& [text, n] :
       {std::pair{claims_tex(document.registered()), 4}, {values_tex(document.registered()), 0}}) {
    int found = 0;
    for (auto at = text.find(escaped); at != std::string::npos; at = text.find(escaped, at + 1)) {
      ++found;
    }
    BOOST_TEST(found == n, text);
    BOOST_TEST(lacks(text, special));
  }
}

BOOST_AUTO_TEST_CASE(another_verdict_than_the_expected_one_is_a_fault_of_one_line_with_its_place) {
  BOOST_TEST(document_with(Verdict::confirmed).faults() == std::vector<std::string>{},
             per_element());

  Document document = document_with(Verdict::partly);
  document.check("sum", false, "the sum is right");

  const std::vector<std::string> expected = {
      "check sum failed: the sum is right",
      "claim apples is partly confirmed, not confirmed: price: 2.61 kr (asked: at most 2.65 kr); "
      "low price: 2.61 kr (asked: at most 2.5 kr)"};
  BOOST_TEST(without_lines(document.faults()) == expected, per_element());
  BOOST_TEST(holds(values_tex(document.registered()), "2 statements are not as expected"));
  const TemporaryFolder scratch;
  document.write(scratch / "out");
  BOOST_TEST(read_names(scratch / "out/names.json").faults == document.faults(), per_element());
}

BOOST_AUTO_TEST_CASE(a_doubled_claim_is_a_logic_error_naming_both_places) {
  Document document = document_with(Verdict::confirmed);

  const std::string message = message_of<std::logic_error>(
      [&] { document.claim("apples", claim_of_apples(Verdict::confirmed)); });

  BOOST_TEST(message.starts_with(here), message);
  BOOST_TEST(holds(message, ": claim 'apples' is registered twice, first at " + here));
}

BOOST_AUTO_TEST_CASE(a_claim_with_a_part_missing_is_a_logic_error_naming_its_place) {
  for (const auto& [part, drop] : std::vector<std::pair<std::string, void (*)(Claim&)>>{
           {"route", [](Claim& claim) { claim.route.clear(); }},
           {"criterion", [](Claim& claim) { claim.criteria.clear(); }}}) {
    Claim claim = claim_of_apples(Verdict::confirmed);
    drop(claim);
    Document document;

    const std::string message =
        message_of<std::logic_error>([&] { document.claim("apples", claim); });

    BOOST_TEST(message.starts_with(here), message);
    BOOST_TEST(holds(message, ": claim 'apples' has no " + part));
  }
}

BOOST_AUTO_TEST_CASE(two_criteria_of_one_name_in_a_claim_are_a_logic_error_naming_its_place) {
  Claim claim = claim_of_apples(Verdict::confirmed);
  claim.criteria.push_back(price_at_most(2.5));
  Document document;

  const std::string message =
      message_of<std::logic_error>([&] { document.claim("apples", claim); });

  BOOST_TEST(message.starts_with(here), message);
  BOOST_TEST(message.ends_with(": claim 'apples' has two criteria that are called 'price'; each "
                               "needs a name of its own"),
             message);
}

BOOST_AUTO_TEST_CASE(a_check_holds_if_all_of_its_criteria_do_and_tells_what_they_found) {
  Document document;
  document.check("cheap", {price_at_most(2.65)}, "apples are cheap");
  document.check("very-cheap", {price_at_most(2.65), price_at_most(2.5)}, "apples are very cheap");
  document.check("hardly-known",
                 {Criterion::at_most("price", Value({2.612, 0.01}, fixed(2), "{kr}"),
                                     {LimitKind::data, 2.61, "the price of a pear"})},
                 "apples cost no more than pears");

  const std::vector<std::string> expected = {
      "check very-cheap failed: apples are very cheap; price: 2.61 kr (asked: at most 2.65 kr); "
      "price: 2.61 kr (asked: at most 2.5 kr)",
      "check hardly-known failed: apples cost no more than pears; price: (2.612 ± 0.010) kr "
      "(asked: at "
      "most 2.61 kr), undecided: an error of 0.01 kr reaches across the limit"};
  BOOST_TEST(without_lines(document.faults()) == expected, per_element());
  BOOST_CHECK_THROW(document.check("nothing", std::vector<Criterion>{}, "x"), std::logic_error);
}

BOOST_AUTO_TEST_CASE(the_document_shows_the_verdict_where_it_is_claimed_and_in_the_ledger) {
  const std::vector<std::string> pages = pages_with(Verdict::confirmed);

  BOOST_TEST(holds(pages[0], "[C1 confirmed]"));
  BOOST_TEST(holds(pages[2], "Statements of others: 1, of which 1 confirmed"));
  BOOST_TEST(holds(pages[2], "C1 An apple costs 2.6."));
  BOOST_TEST(holds(pages[2], "faults not"));
  BOOST_TEST(holds(pages[2], "test.cpp:"));
  for (const char* part :
       {"price: 2.61 kr", "≤ 2.65 kr", "1.0", "times;", "[a] data: half of the last digit more"}) {
    BOOST_TEST(holds(pages[2], part), part << " is not in " << pages[2]);
  }
  for (const std::string& page : pages) BOOST_TEST(lacks(page, "Not to be trusted"));
}

BOOST_AUTO_TEST_CASE(the_head_of_the_ledger_stands_once_on_each_of_its_pages) {
  constexpr int n_others = 25;
  const std::vector<std::string> pages =
      pages_with(Verdict::confirmed, "", "Apples \\claim{apples}.", n_others, 5);

  const std::string head = "statement and test";
  for (std::size_t i = 2; i < pages.size(); ++i) {
    const auto at = pages[i].find(head);
    BOOST_TEST(at != std::string::npos, "page " << i + 1 << ": " << pages[i]);
    BOOST_TEST(pages[i].find(head, at + 1) == std::string::npos, pages[i]);
  }
}

BOOST_AUTO_TEST_CASE(a_document_that_wants_verdicts_in_its_margin_has_whole_sentences) {
  const std::vector<std::string> pages =
      pages_with(Verdict::confirmed, "\\renewcommand*\\LiterateClaimPlacement{margin}",
                 "Apples are cheap.\\claim{apples} Pears are not.");

  BOOST_TEST(holds(pages[0], "Apples are cheap. Pears are not."));
  BOOST_TEST(holds(pages[0], "C1"));
  BOOST_TEST(lacks(pages[0], "confirmed"));
}

BOOST_AUTO_TEST_CASE(the_table_of_findings_has_the_ledgers_sentence_and_the_proses_finding) {
  const std::vector<std::string> pages =
      pages_with(Verdict::confirmed, "",
                 "\\begin{findings}\\finding[stall 4]{apples}{They do.}\\end{findings}");

  for (const char* part : {"An apple costs 2.6.", "They do.", "C1", "stall 4"}) {
    BOOST_TEST(holds(pages[0], part), part << " is not in " << pages[0]);
  }
}

BOOST_AUTO_TEST_CASE(a_finding_may_have_shorter_words) {
  const std::vector<std::string> pages =
      pages_with(Verdict::confirmed, "",
                 "\\findingsays{apples}{Apples are cheap.}"
                 "\\begin{findings}\\finding{apples}{They are.}\\end{findings}");

  BOOST_TEST(holds(pages[0], "Apples are cheap."));
  BOOST_TEST(lacks(pages[0], "An apple costs 2.6."));
}

BOOST_AUTO_TEST_CASE(the_day_of_the_paper_is_told_in_words) {
  const std::string set = "\\makeatletter\\LiterateRepository{abc}{true}{2026-01-05T12:00:00Z}";

  BOOST_TEST(
      holds(pages_with(Verdict::confirmed, "", set + "Of \\paperday.")[0], "Of 5 January 2026."));
  BOOST_TEST(holds(pages_with(Verdict::confirmed, "", "Of \\paperday.")[0], "Of unknown."));
}

BOOST_AUTO_TEST_CASE(every_value_stands_in_a_csv_file_with_its_error_and_its_line) {
  Document document;
  document.value("price", Value({2.612, 0.001}, fixed(2), "{kr}"));
  document.value("name", Value::text("a \"red\", sour one"));

  const std::string csv = values_csv(document.registered());

  BOOST_TEST(csv.starts_with("key,printed,number,abs_error,below,above,standard,unit,place\n"),
             csv);
  BOOST_TEST(holds(csv, "\nprice,2.61 kr,2.612,0.001,,,,{kr}," + here));
  BOOST_TEST(holds(csv, "\nname,\"a \"\"red\"\", sour one\",,,,,,," + here));
}

BOOST_AUTO_TEST_CASE(every_criterion_stands_in_a_csv_file_with_its_margin_and_its_faults) {
  Document document = document_with(Verdict::partly);
  const std::string row =
      "\napples,partly confirmed,confirmed,price,2.61 kr,≤ 2.65 kr,data,"
      "half of the last digit more,holds,";
  BOOST_TEST(holds(claims_csv(document.registered()), row));

  document.severity(Severity{.n_faults = 41, .n_turning = {{"apples", 3}}});
  BOOST_TEST(holds(claims_csv(document.registered()), ",3,41\n"));
  BOOST_TEST(holds(claims_tex(document.registered()), "{3 of 41 faults}"));
}

BOOST_AUTO_TEST_CASE(an_author_is_told_what_no_fault_turns_and_what_hangs_on_a_choice) {
  Document document = document_with(Verdict::confirmed);
  document.severity(Severity{.n_faults = 41, .n_turning = {{"apples", 0}}});
  const auto chosen = [&](const char* id, double limit) {
    document.claim(id, {.route = "by eye",
                        .expected = Verdict::confirmed,
                        .criteria = {Criterion::at_most("price", Value(2, integer(), "{kr}"),
                                                        {LimitKind::choice, limit, "cheap"})}});
  };
  chosen("pears", 3);
  chosen("plums", 8);

  const std::vector<std::string> expected = {
      "claim apples: none of 41 planted faults turns it",
      "claim pears: price: 2 kr hangs on a choice, ≤ 3 kr: a factor of 1.5 in the limit would turn "
      "it",
      "claim pears: limits of choice for one reason differ: ≤ 3 kr, ≤ 8 kr: 'cheap'"};
  BOOST_TEST(without_lines(claim_notes(document.registered())) == expected, per_element());
}

BOOST_AUTO_TEST_CASE(every_claim_figure_and_table_has_its_line_in_a_csv_file) {
  const std::string csv = sources_csv(document_with(Verdict::confirmed).registered());

  BOOST_TEST(csv.starts_with("kind,name,place,function\n"), csv);
  BOOST_TEST(holds(csv, "\nclaim,apples," + here));
}

BOOST_AUTO_TEST_CASE(attached_data_are_in_the_pdf_and_print_nothing) {
  const TemporaryFolder scratch;
  Document document;
  document.value("unused", Value(1, integer()));
  document.write(scratch / "generated");
  sys::write_file_atomically(scratch / "text/main.tex",
                             "\\documentclass{article}\\usepackage{literate}\n"
                             "\\begin{document}Text.\\attachdata\\end{document}\n");
  typeset({.source_dir = scratch / "text",
           .main_file = "main.tex",
           .generated_dir = scratch / "generated",
           .build_dir = scratch / "latex",
           .output_pdf = scratch / "main.pdf"});
  const std::string pdf = (scratch / "main.pdf").string();
  const std::string attached =
      sys::run({.program = "pdfdetach", .arguments = {"-list", pdf}}).output;
  for (const char* name : {"values.csv", "claims.csv", "sources.csv"}) {
    BOOST_TEST(holds(attached, name));
  }
  const std::string text = sys::run({.program = "pdftotext", .arguments = {pdf, "-"}}).output;
  BOOST_TEST(text.starts_with("Text.\n"), text);
}

BOOST_AUTO_TEST_CASE(a_document_with_a_fault_says_so_on_every_page_and_in_the_ledger) {
  const std::vector<std::string> pages = pages_with(Verdict::refuted);

  for (const std::string& page : pages) {
    BOOST_TEST(holds(page, "Not to be trusted: a statement is not as expected"));
  }
  BOOST_TEST(holds(pages[2], "1 not as expected"));
  for (const char* word : {"refuted,", "not", "confirmed", "as", "expected"}) {
    BOOST_TEST(holds(pages[2], word));
  }
}

BOOST_AUTO_TEST_SUITE_END()
