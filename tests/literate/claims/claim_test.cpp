// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(claim_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(verdicts_have_names_and_follow_from_what_holds) {
  BOOST_TEST(name_of(Verdict::confirmed) == "confirmed");
  BOOST_TEST(name_of(Verdict::partly) == "partly confirmed");
  BOOST_TEST(name_of(Verdict::refuted) == "refuted");
  BOOST_TEST(name_of(Verdict::undecided) == "undecided");

  BOOST_CHECK(confirmed_if(true) == Verdict::confirmed);
  BOOST_CHECK(confirmed_if(false) == Verdict::refuted);
  BOOST_CHECK(confirmed_in(11, 11) == Verdict::confirmed);
  BOOST_CHECK(confirmed_in(10, 11) == Verdict::partly);
  BOOST_CHECK(confirmed_in(0, 11) == Verdict::refuted);
}

namespace {

Criterion share_at_most(double share, double limit, double abs_error = 0) {
  return Criterion::at_most("share", Value({share, abs_error}, percent(1)),
                            {LimitKind::derived, limit, "a formula"});
}

const Criterion held = share_at_most(0.1, 0.2);
const Criterion failed = share_at_most(0.3, 0.2);
const Criterion still_open = share_at_most(0.2, 0.2, 0.01);

Claim claim_of(const std::vector<Criterion>& criteria) {
  return {.sentence = "It is small.", .place = "here", .route = "a ruler", .criteria = criteria};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_verdict_is_what_all_criteria_say_and_open_if_one_of_them_is) {
  BOOST_CHECK(verdict_of({held, held}) == Verdict::confirmed);
  BOOST_CHECK(verdict_of({failed, failed}) == Verdict::refuted);
  BOOST_CHECK(verdict_of({held, failed}) == Verdict::partly);
  BOOST_CHECK(verdict_of({held, still_open}) == Verdict::undecided);
  BOOST_CHECK(verdict_of({failed, still_open}) == Verdict::undecided);
  BOOST_CHECK(verdict_of({}) == Verdict::undecided);
}

BOOST_AUTO_TEST_CASE(a_claim_prints_what_its_criteria_tested) {
  const Claim claim = decided(claim_of({held, still_open}));

  BOOST_TEST(claim.computed.printed() ==
             "share: 10.0 %; share: 20 % [share: its error of 1 % reaches across the limit]");
  BOOST_TEST(claim.tolerance ==
             "at most 20 % (derived: a formula); at most 20 % (derived: a formula)");
  BOOST_CHECK(claim.found == Verdict::undecided);
}

BOOST_AUTO_TEST_CASE(nothing_is_said_beside_criteria) {
  Claim with_tolerance = claim_of({held});
  with_tolerance.tolerance = "1 %";
  BOOST_CHECK_THROW(decided(with_tolerance), std::invalid_argument);
  Claim with_value = claim_of({held});
  with_value.computed = Value(3, integer());
  BOOST_CHECK_THROW(decided(with_value), std::invalid_argument);

  Claim without_criteria = claim_of({});
  without_criteria.tolerance = "1 %";
  without_criteria.found = Verdict::refuted;
  BOOST_TEST(decided(without_criteria).tolerance == "1 %");
  BOOST_CHECK(decided(without_criteria).found == Verdict::refuted);
}

BOOST_AUTO_TEST_SUITE_END()
