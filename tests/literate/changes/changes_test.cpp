// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/changes.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>
#include <vector>

#include "holds.hpp"

BOOST_AUTO_TEST_SUITE(changes_test)

using literate::Change;
using literate::ChangeKind;
using literate::changes_between;
using literate::Manifest;
using literate::ManifestNumber;
using literate::Sentence;

namespace {

Manifest state() {
  Manifest manifest;
  manifest.project = "rod";
  manifest.numbers = {
      {"peak", {.number = 10, .abs_error = 0.1, .printed = "10.0 psi", .unit = "psi"}},
      {"fit", {.number = 5, .abs_error = 0, .printed = "5.0(5)", .standard = 0.5}},
      {"count", {.number = 7, .abs_error = {}, .printed = "7"}},
      {"table a, row 1, column 2", {.number = 3, .abs_error = 0, .printed = "3", .unit = "in"}}};
  manifest.outputs = {{"generated/figures/curve/data.csv", "d1"},
                      {"generated/figures/curve/curve.pdf", "d2"},
                      {"generated/values.tex", "d3"}};
  manifest.verdicts = {{"claim one", "confirmed"}, {"check sum", "passed"}};
  manifest.limits = {{"claim one: ratio", "at most 1 %"}};
  manifest.texts = {{"flag is-wide", "yes"}, {"table a, row 1, column 1", "steel"}};
  manifest.outcomes = {{"claim one: ratio", "holds"}};
  manifest.words = {{"claim one: route", "by hand"},
                    {"claim one: ratio: reason", "data: printed"},
                    {"table a: headings", "load | material"},
                    {"table a: notes", ""}};
  return manifest;
}

std::vector<Change> changes_to(const Manifest& after) {
  return changes_between(state(), after, {}, {});
}

// One change of the state, told once, in this class.
void check_told(const Manifest& after, ChangeKind kind, const std::string& what,
                const std::string& before, const std::string& now) {
  const auto changes = changes_to(after);
  BOOST_TEST_REQUIRE(changes.size() == 1U, what);
  BOOST_TEST(name_of(changes[0].kind) == name_of(kind));
  BOOST_TEST(changes[0].what == what);
  BOOST_TEST(changes[0].before == before);
  BOOST_TEST(changes[0].after == now);
}

// The same of a number, by its print, and of a text.
void check_number(const std::string& name, const ManifestNumber& now, ChangeKind kind) {
  Manifest after = state();
  const std::string before = std::exchange(after.numbers[name], now).printed;
  check_told(after, kind, name.starts_with("table ") ? name : "value " + name, before, now.printed);
}
void check_text(Manifest::Texts Manifest::*texts, const std::string& name, const std::string& now,
                ChangeKind kind) {
  Manifest after = state();
  const std::string before = std::exchange((after.*texts)[name], now);
  check_told(after, kind, name, before, now);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_state_does_not_differ_from_itself) {
  BOOST_TEST(changes_to(state()).empty());
}

BOOST_AUTO_TEST_CASE(each_class_of_change_is_told_once_and_in_its_class) {
  Manifest after = state();
  after.numbers["new"] = {.number = 1, .abs_error = {}, .printed = "1"};
  check_told(after, ChangeKind::added, "value new", "", "1");

  after = state();
  after.numbers.erase("count");
  check_told(after, ChangeKind::gone, "value count", "7", "");

  after = state();
  after.numbers["number"] = after.numbers.at("count");
  after.numbers.erase("count");
  check_told(after, ChangeKind::renamed, "value number", "count", "number");

  const auto peak = [](double number, const char* printed, const char* unit) {
    return ManifestNumber{.number = number, .abs_error = 0.1, .printed = printed, .unit = unit};
  };
  check_number("peak", peak(10.25, "10.2 psi", "psi"), ChangeKind::beyond_error);
  check_number("peak", peak(10.15, "10.0 psi", "psi"), ChangeKind::within_error);
  check_number("peak", peak(10, "10.00 psi", "psi"), ChangeKind::other_digits);
  check_number("peak", peak(10, "10.0 bar", "bar"), ChangeKind::beyond_error);
  check_number("peak", peak(10, "10.0 s", "s"), ChangeKind::other_unit);
  check_number("peak", {.number = 68.9, .abs_error = 0.7, .printed = "68.9 kPa", .unit = "kPa"},
               ChangeKind::other_unit);
  check_number("count", {.number = 7.2, .abs_error = {}, .printed = "7"}, ChangeKind::other_digits);
  check_number("count", {.number = 8, .abs_error = {}, .printed = "8"}, ChangeKind::moved);
  check_number("fit", {.number = 5, .abs_error = 0, .printed = "5.0(9)", .standard = 0.9},
               ChangeKind::other_error);
  check_number("table a, row 1, column 2",
               {.number = 4, .abs_error = 0, .printed = "4", .unit = "in"},
               ChangeKind::beyond_error);

  // The bound to the lesser side alone is another.
  Manifest before = state();
  auto& sided = before.numbers["peak"];
  sided.sides = {0.05, 0.1};
  sided.printed = "(10.00 +0.10 −0.05) psi";
  after = before;
  after.numbers["peak"].sides = {0.07, 0.1};
  after.numbers["peak"].printed = "(10.00 +0.10 −0.07) psi";
  const auto of_sides = changes_between(before, after, {}, {});
  BOOST_TEST_REQUIRE(of_sides.size() == 1U);
  BOOST_TEST(name_of(of_sides[0].kind) == "another error");

  // An index prints the errors of values; those of cells are printed nowhere else.
  after = state();
  after.numbers["table a, row 1, column 2"].abs_error = 0.1;
  const std::vector<Change> of_cell = changes_between(state(), after, {}, {});
  BOOST_TEST_REQUIRE(of_cell.size() == 1U);
  BOOST_TEST(!of_cell[0].is_seen());
  after = state();
  after.numbers["peak"].abs_error = 0.2;
  const auto is_seen = [&](const std::string& text) {
    const auto sentences = literate::sentences_in(text, "a.tex", {{"is-wide", true}});
    const auto changes = changes_between(state(), after, sentences, sentences);
    BOOST_TEST_REQUIRE(changes.size() == 1U);
    return changes[0].is_seen();
  };
  BOOST_TEST(!is_seen("The peak is \\val{peak}."));
  BOOST_TEST(is_seen("\\valueindex"));
  after.numbers["peak"].number = 12;
  after.numbers["peak"].printed = "12.0 psi";
  BOOST_TEST(is_seen("The peak is \\val{peak}."));
  BOOST_TEST(!is_seen("It is \\ifflag{is-wide}{wide}{\\val{peak}}."));

  check_text(&Manifest::texts, "flag is-wide", "no", ChangeKind::other_text);
  check_text(&Manifest::texts, "table a, row 1, column 1", "brass", ChangeKind::other_text);
  check_text(&Manifest::verdicts, "claim one", "refuted", ChangeKind::other_verdict);
  check_text(&Manifest::verdicts, "check sum", "failed", ChangeKind::other_verdict);
  check_text(&Manifest::limits, "claim one: ratio", "at most 2 %", ChangeKind::other_limit);

  after = state();
  after.outputs["generated/figures/curve/data.csv"] = "other";
  check_told(after, ChangeKind::other_data, "figure curve", "", "");
  after.outputs["generated/figures/curve/curve.pdf"] = "other";
  check_told(after, ChangeKind::other_drawing, "figure curve", "", "");

  after = state();
  after.numbers["table a, row 1, column 2"].number = 76.2;
  after.numbers["table a, row 1, column 2"].printed = "76.2";
  after.numbers["table a, row 1, column 2"].unit = "mm";
  check_told(after, ChangeKind::other_unit, "table a, row 1, column 2", "3 in", "76.2 mm");

  after = state();
  after.verdicts["claim two"] = "confirmed";
  check_told(after, ChangeKind::added, "claim two", "", "confirmed");
}

BOOST_AUTO_TEST_CASE(a_listing_that_the_document_prints_and_that_is_another_is_told) {
  Manifest before = state(), after = state();
  before.outputs["generated/excerpts/sum.txt"] = "d5";
  after.outputs["generated/excerpts/sum.txt"] = "d6";
  const auto sentences = literate::sentences_in("\\excerpt[The sum]{sum}", "a.tex");

  BOOST_TEST(changes_between(before, after, {}, {}).empty());
  const auto changes = changes_between(before, after, sentences, sentences);

  BOOST_TEST_REQUIRE(changes.size() == 1U);
  BOOST_TEST(changes[0].what == "listing sum");
  BOOST_TEST(name_of(changes[0].kind) == "another text");
  BOOST_TEST(changes[0].is_seen());
}

BOOST_AUTO_TEST_CASE(other_words_of_the_program_are_told) {
  for (const auto& [name, words] : state().words) {
    check_text(&Manifest::words, name, "other words", ChangeKind::other_text);
  }
}

BOOST_AUTO_TEST_CASE(the_words_of_what_is_new_are_told_with_it) {
  Manifest after = state();
  after.verdicts["claim two"] = "confirmed";
  after.words["claim two: route"] = "by quadrature";
  check_told(after, ChangeKind::added, "claim two", "", "confirmed");
}

BOOST_AUTO_TEST_CASE(a_row_that_is_put_before_others_is_the_only_new_one) {
  Manifest before = state(), after = state();
  const auto set = [](Manifest& manifest, int row, const std::string& name, double number) {
    const std::string cell = "table b, row " + std::to_string(row) + ", column ";
    manifest.texts[cell + "1"] = name;
    manifest.numbers[cell + "2"] = {
        .number = number, .abs_error = {}, .printed = std::to_string(static_cast<int>(number))};
  };
  set(before, 1, "steel", 3);
  set(before, 2, "brass", 2);
  set(after, 1, "lead", 1);
  set(after, 2, "steel", 3);
  set(after, 3, "brass", 4);

  const auto changes = changes_between(before, after, {}, {});

  BOOST_TEST_REQUIRE(changes.size() == 3U);
  BOOST_TEST(changes[0].what == "table b, row «brass», column 2");
  BOOST_TEST(name_of(changes[0].kind) == "moved");
  for (const std::size_t i : {1U, 2U}) {
    BOOST_TEST(changes[i].what.starts_with("table b, row «lead», column "));
    BOOST_TEST(name_of(changes[i].kind) == "new");
  }
}

BOOST_AUTO_TEST_CASE(an_error_that_is_another_is_told_where_the_number_prints_alike) {
  Manifest after = state();
  after.numbers["peak"].abs_error = 0.2;
  check_told(after, ChangeKind::other_error, "value peak", "10.0 psi (error 0.1)",
             "10.0 psi (error 0.2)");
}

BOOST_AUTO_TEST_CASE(what_was_a_number_and_is_a_text_or_the_reverse_is_told_once) {
  Manifest after = state();
  after.numbers.erase("table a, row 1, column 2");
  after.texts["table a, row 1, column 2"] = "none";
  check_told(after, ChangeKind::other_text, "table a, row 1, column 2", "3", "none");

  after = state();
  after.numbers.erase("peak");
  after.texts["value peak"] = "high";
  check_told(after, ChangeKind::other_text, "value peak", "10.0 psi", "high");

  after = state();
  after.texts.erase("table a, row 1, column 1");
  after.numbers["table a, row 1, column 1"] = {.number = 2, .abs_error = {}, .printed = "2"};
  check_told(after, ChangeKind::other_text, "table a, row 1, column 1", "steel", "2");
}

BOOST_AUTO_TEST_CASE(whatever_number_moves_is_named) {
  for (const auto& [name, number] : state().numbers) {
    for (const double moved : {1.5 * number.number, -number.number, number.number + 1e-13}) {
      Manifest after = state();
      after.numbers[name].number = moved;
      const auto changes = changes_to(after);
      BOOST_TEST_REQUIRE(changes.size() == 1U, name);
      BOOST_TEST(changes[0].what.ends_with(name));
    }
  }
}

BOOST_AUTO_TEST_CASE(changes_are_told_in_the_order_of_their_numbers) {
  Manifest before = state(), after = state();
  for (const char* row : {"1", "2", "10"}) {
    after.numbers[std::string("table a, row ") + row + ", column 1"] = {
        .number = 1, .abs_error = {}, .printed = "1"};
    before.limits[std::string("claim one: part ") + row] = "at most 1";
  }
  std::vector<std::string> told;
  for (const Change& change : changes_between(before, after, {}, {})) told.push_back(change.what);
  const std::vector<std::string> wanted{"claim one: part 1",        "claim one: part 2",
                                        "claim one: part 10",       "table a, row 1, column 1",
                                        "table a, row 2, column 1", "table a, row 10, column 1"};
  BOOST_TEST(told == wanted, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_standard_uncertainty_counts_as_the_error_of_a_number) {
  Manifest after = state();
  after.numbers["fit"].number = 5.9;
  check_told(after, ChangeKind::within_error, "value fit", "5.0(5)", "5.0(5)");
  after.numbers["fit"].number = 6.1;
  check_told(after, ChangeKind::beyond_error, "value fit", "5.0(5)", "5.0(5)");
}

BOOST_AUTO_TEST_CASE(of_two_names_with_one_number_none_is_taken_for_the_other) {
  Manifest after = state();
  after.numbers["one"] = after.numbers["two"] = after.numbers.at("count");
  after.numbers.erase("count");
  BOOST_TEST(changes_to(after).size() == 3U);
}

BOOST_AUTO_TEST_CASE(the_first_text_of_a_paper_that_had_none_is_told) {
  Manifest before = state(), after = state();
  before.texts.clear();
  after.texts = {{"value count", "none"}};
  after.numbers.erase("count");

  const auto changes = changes_between(before, after, {}, {});

  BOOST_TEST_REQUIRE(changes.size() == 1U);
  BOOST_TEST(name_of(changes[0].kind) == "another text");
  BOOST_TEST(changes[0].before == "7");
  BOOST_TEST(changes[0].after == "none");
}

BOOST_AUTO_TEST_CASE(a_manifest_without_limits_is_of_an_earlier_version_and_tells_none) {
  Manifest before = state();
  before.limits.clear();
  before.is_of_earlier_version = true;
  BOOST_TEST(changes_between(before, state(), {}, {}).empty());
}

BOOST_AUTO_TEST_CASE(a_criterion_that_turned_is_told_though_its_claim_did_not) {
  Manifest after = state();
  after.outcomes["claim one: ratio"] = "fails";
  check_told(after, ChangeKind::other_verdict, "claim one: ratio", "holds", "fails");

  Manifest earlier = state();
  earlier.outcomes = {};
  earlier.is_of_earlier_version = true;
  BOOST_TEST(changes_between(earlier, state(), {}, {}).empty());
}

BOOST_AUTO_TEST_CASE(a_value_that_prints_as_before_is_seen_where_its_options_print_it_otherwise) {
  Manifest after = state();
  after.numbers["peak"].number = 10.06;
  literate::StoredNumber peak{.number = 10.06,
                              .uncertainty = literate::Uncertainty(1e-4),
                              .unit = "psi",
                              .notation = literate::Notation::significant,
                              .digits = 3,
                              .last_place = -1};
  const auto changes = [&](const std::string& latex) {
    const auto sentences = literate::sentences_in(latex, "a.tex");
    return changes_between(state(), after, sentences, sentences, {{"peak", peak}});
  };
  BOOST_TEST(!changes("It is \\val{peak}.").at(0).is_seen());
  const auto alike = changes("It is \\val[digits=2]{peak}.");
  BOOST_TEST(!alike.at(0).is_seen());
  BOOST_TEST(alike.at(0).printed_in.empty());
  const auto restyled =
      changes("It is \\val[digits=3]{peak}.\n\nIt is \\val{peak}.\n\n\\val[digits=2]{peak}");
  BOOST_TEST(restyled.at(0).is_seen());
  BOOST_TEST(restyled.at(0).before == "10.0 psi");
  BOOST_TEST(restyled.at(0).after == "10.1 psi");
  const auto raw = changes("It is \\rawval{peak}.");
  BOOST_TEST(raw.at(0).before == "10");
  BOOST_TEST(raw.at(0).after == "10.06");
  BOOST_TEST_REQUIRE(restyled.at(0).printed_in.size() == 1U);
  BOOST_TEST(restyled.at(0).printed_in[0].first_line == 1);
}

BOOST_AUTO_TEST_CASE(sentences_that_print_what_changed_are_told_with_it) {
  const auto before = literate::sentences_in("Seven are \\val{count}.", "old.tex");
  const auto now = literate::sentences_in(
      "The peak is \\val{peak}.\nTable \\tab{a} says so. It is \\claim{one}.", "new.tex");
  Manifest after = state();
  after.numbers.erase("count");
  after.numbers["peak"].number = 11;
  after.numbers["table a, row 1, column 2"].number = 4;
  after.limits["claim one: ratio"] = "at most 2 %";
  const auto changes = changes_between(state(), after, before, now);
  BOOST_TEST_REQUIRE(changes.size() == 4U);
  for (const Change& change : changes) {
    BOOST_TEST_REQUIRE(change.printed_in.size() == 1U, change.what);
    BOOST_TEST(change.printed_in[0].file ==
               (change.kind == ChangeKind::gone ? "old.tex" : "new.tex"));
  }
  const std::string text = literate::changes_text(changes);
  BOOST_TEST(lacks(text, "value peak"));
  BOOST_TEST(holds(text, "value count: was 7\n                            old.tex:1\n"));
  BOOST_TEST(text.ends_with(
      "2 numbers or their errors moved, which nothing printed shows: changes.csv has them\n"));
  const std::string answer =
      literate::answer_to_referees(changes, {.before = "v1", .after = "now", .reasons = {}},
                                   literate::edits_between(before, now));
  BOOST_TEST(holds(answer, "was 7; was printed in the former old.tex:1\n"));
  BOOST_TEST(holds(answer, "; printed in new.tex:2\n"));
}

BOOST_AUTO_TEST_CASE(an_error_that_the_index_prints_is_seen_although_the_number_moved_unseen) {
  Manifest after = state();
  after.numbers["peak"].number = 10.001;
  after.numbers["peak"].abs_error = 0.201;
  check_told(after, ChangeKind::within_error, "value peak", "10.0 psi (error 0.1)",
             "10.0 psi (error 0.21)");
  after.numbers["peak"].abs_error = 0.1;
  BOOST_TEST(!changes_to(after).at(0).is_seen());
}

BOOST_AUTO_TEST_CASE(that_no_fault_was_planted_since_the_code_changed_is_told_once) {
  Manifest before = state(), after = state();
  for (const char* claim : {"one", "two"}) {
    const std::string what = std::string("claim ") + claim + ": planted faults";
    before.words[what] = "2 of 3 faults";
    after.words[what] = "faults not known";
  }
  const auto changes = changes_between(before, after, {}, {});
  BOOST_TEST_REQUIRE(changes.size() == 1U);
  BOOST_TEST(changes[0].what == "planted faults of all claims");
}

BOOST_AUTO_TEST_CASE(a_sentence_that_counts_verdicts_is_told_with_each_that_turned) {
  const auto sentences = literate::sentences_in(
      "Of them \\claimcount{cited}{refuted} fell.\nIt is \\val{peak}.", "a.tex");
  Manifest after = state();
  after.verdicts["claim one"] = "refuted";
  after.verdicts["check sum"] = "failed";
  after.limits["claim one: ratio"] = "at most 2 %";
  const auto changes = changes_between(state(), after, sentences, sentences);
  BOOST_TEST_REQUIRE(changes.size() == 3U);
  for (const Change& change : changes) {
    BOOST_TEST(change.printed_in.size() == (change.what == "claim one" ? 1U : 0U), change.what);
  }
}

BOOST_AUTO_TEST_CASE(the_answer_quotes_old_and_new_words_and_lists_what_moved) {
  const std::string section = "\\section{Size}One. ";
  const auto before = literate::sentences_in(section + "About half. Three.", "a.tex");
  const auto now = literate::sentences_in(section + "Nearly all of it. Three.", "a.tex");
  Manifest after = state();
  after.numbers["peak"].number = 11;
  after.numbers["peak"].printed = "11.0 psi";
  const std::string answer = literate::answer_to_referees(
      changes_to(after), {"v1", "the sources as they are", {"case.toml: another content"}},
      literate::edits_between(before, now));
  BOOST_TEST(
      answer ==
      "# Answer to the referees\n\nBefore: v1. Now: the sources as they are.\nPlaces at which the "
      "author's words are others: 1.\nResults that a reader sees and that are others: 1; "
      "changes.csv "
      "has each.\n\n## "
      "Size, "
      "a.tex:1\n\nBefore:\n\n> About half.\n\nNow:\n\n"
      "> Nearly all of it.\n\nWhy:\n\n## Results that are others\n\n"
      "- value peak: moved beyond both errors, 11.0 psi, was 10.0 psi\n\n## Inputs and tools that "
      "are others (there: before, here: now)\n\n- case.toml: another content\n");
}

BOOST_AUTO_TEST_CASE(
    an_answer_tells_a_claim_with_its_criteria_and_a_table_of_many_cells_by_their_number) {
  Manifest before = state();
  for (int row = 1; row <= 6; ++row) {
    before.numbers["table b, row " + std::to_string(row) + ", column 2"] = {
        .number = 1, .abs_error = 0, .printed = "1"};
  }
  Manifest after = before;
  for (auto& [name, number] : after.numbers) {
    if (!name.starts_with("table ")) continue;
    number.number = 4;
    number.printed = "4";
  }
  after.verdicts["claim one"] = "refuted";
  after.outcomes["claim one: ratio"] = "fails";
  after.limits["claim one: ratio"] = "at most 2 %";
  const auto sentences = literate::sentences_in("So \\claim{one}, \\tab{a} and \\tab{b}.", "a.tex");
  const std::string answer = literate::answer_to_referees(
      changes_between(before, after, sentences, sentences), {"v1", "now", {}}, {});
  BOOST_TEST(answer.substr(answer.find("- ")) ==
             "- claim one: other verdict, refuted, was confirmed; printed in a.tex:1\n"
             "  - ratio: other verdict, fails, was holds\n"
             "  - ratio: other limit, at most 2 %, was at most 1 %\n"
             "- table a, row 1, column 2: moved beyond both errors, 4, was 3; printed in a.tex:1\n"
             "- table b: 6 cells are others; printed in a.tex:1\n");
}

BOOST_AUTO_TEST_CASE(sources_of_uncertainty_are_printed_by_an_index_alone) {
  Manifest before = state(), after = state();
  before.words["value fit: sources of uncertainty"] = "gauge 1";
  after.words["value fit: sources of uncertainty"] = "gauge 2";
  for (const std::string text : {"It fits \\val{fit}.", "\\valueindex"}) {
    const auto sentences = literate::sentences_in(text, "a.tex");
    const auto changes = changes_between(before, after, sentences, sentences);
    BOOST_TEST_REQUIRE(changes.size() == 1U);
    BOOST_TEST(changes[0].printed_in.empty());
    BOOST_TEST(changes[0].is_seen() == (text == "\\valueindex"), text);
  }
}

BOOST_AUTO_TEST_CASE(an_answer_counts_nothing_that_was_not_compared) {
  const std::string answer = literate::answer_to_referees(
      {}, {.before = "v1", .after = "now", .reasons = {}, .has_words = false, .has_results = false},
      {});
  BOOST_TEST(answer ==
             "# Answer to the referees\n\nBefore: v1. Now: now.\nThe former words are not known.\n"
             "The results could not be compared.\n");
}

BOOST_AUTO_TEST_SUITE_END()
