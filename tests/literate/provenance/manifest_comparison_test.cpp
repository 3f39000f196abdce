// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/manifest_comparison.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(manifest_comparison_test)

using namespace literate;
using Lines = std::vector<std::string>;
using boost::test_tools::per_element;

namespace {

Manifest some_manifest() {
  return {.project = "paper",
          .facts = {{"tools", {{"compiler", "GNU 12"}}}},
          .inputs = {{"a.tex", "11"}},
          .outputs = {{"a.pdf", "22"}, {"b.tex", "33"}},
          .numbers = {{"count", {38, std::nullopt, "38"}}, {"u", {2.385e-6, 3e-12, "2.385"}}},
          .verdicts = {{"claim it-holds", "confirmed"}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_manifest_has_no_differences) {
  const ManifestComparison found = compare(some_manifest(), some_manifest());

  BOOST_TEST(found.changed_outputs.empty());
  BOOST_TEST(found.reasons.empty());
  BOOST_TEST(found.moved.empty());
}

BOOST_AUTO_TEST_CASE(differences_are_named_with_both_sides) {
  const Manifest theirs = some_manifest();
  Manifest ours = some_manifest();
  ours.facts["tools"] = {{"compiler", "GNU 13"}, {"linker", "gold"}};
  ours.inputs = {{"a.tex", "12"}, {"new.tex", "1"}};
  ours.outputs["a.pdf"] = "23";
  ours.outputs.erase("b.tex");

  const ManifestComparison found = compare(theirs, ours);

  BOOST_TEST(found.changed_outputs == (Lines{"a.pdf", "b.tex"}), per_element());
  BOOST_TEST(found.reasons ==
                 (Lines{"compiler: GNU 12 there, GNU 13 here", "linker: none there, gold here",
                        "a.tex: another content", "new.tex: only here"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(a_number_may_move_within_the_sum_of_the_two_errors) {
  const Manifest theirs = some_manifest();
  Manifest ours = some_manifest();
  ours.numbers["u"].number += 5.9e-12;
  BOOST_TEST(compare(theirs, ours).moved.empty());

  ours.numbers["u"].number += 0.2e-12;

  BOOST_TEST(compare(theirs, ours).moved.size() == 1U);
  BOOST_TEST(compare(theirs, ours).moved.front().starts_with("u: 2.385e-06 (2.385) there, "));
}

BOOST_AUTO_TEST_CASE(a_number_without_an_error_is_compared_as_printed) {
  const Manifest theirs = some_manifest();
  Manifest ours = some_manifest();
  ours.numbers["count"].number += 1e-13;
  BOOST_TEST(compare(theirs, ours).moved.empty());

  ours.numbers["count"] = {39, std::nullopt, "39"};
  ours.numbers.erase("u");

  BOOST_TEST(compare(theirs, ours).moved == (Lines{"count: 38 (38) there, 39 (39) here",
                                                   "u: 2.385e-06 (2.385) there, none here"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(another_verdict_is_named) {
  Manifest ours = some_manifest();
  ours.verdicts["claim it-holds"] = "refuted";

  BOOST_TEST(compare(some_manifest(), ours).moved ==
                 (Lines{"claim it-holds: confirmed there, refuted here"}),
             per_element());
}

BOOST_AUTO_TEST_SUITE_END()
