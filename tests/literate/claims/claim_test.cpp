// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(claim_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(verdicts_have_names) {
  BOOST_TEST(name_of(Verdict::confirmed) == "confirmed");
  BOOST_TEST(name_of(Verdict::partly) == "partly confirmed");
  BOOST_TEST(name_of(Verdict::refuted) == "refuted");
  BOOST_TEST(name_of(Verdict::undecided) == "undecided");
}

namespace {

Criterion share_at_most(double share, double limit, double abs_error = 0) {
  return Criterion::at_most("share", Value({share, abs_error}, percent(1)),
                            {LimitKind::choice, limit, "a formula"});
}

const Criterion held = share_at_most(0.1, 0.2);
const Criterion failed = share_at_most(0.3, 0.2);
const Criterion still_open = share_at_most(0.2, 0.2, 0.01);

}  // namespace

BOOST_AUTO_TEST_CASE(a_verdict_is_what_all_criteria_say_and_open_if_one_of_them_is) {
  BOOST_CHECK(verdict_of({held, held}) == Verdict::confirmed);
  BOOST_CHECK(verdict_of({failed, failed}) == Verdict::refuted);
  BOOST_CHECK(verdict_of({held, failed}) == Verdict::partly);
  BOOST_CHECK(verdict_of({held, still_open}) == Verdict::undecided);
  BOOST_CHECK(verdict_of({failed, still_open}) == Verdict::undecided);
  BOOST_CHECK(verdict_of({}) == Verdict::undecided);
}

BOOST_AUTO_TEST_CASE(a_claim_finds_what_its_criteria_say) {
  const Claim claim{
      .route = "a ruler", .expected = Verdict::confirmed, .criteria = {held, still_open}};

  BOOST_CHECK(claim.found() == Verdict::undecided);
}

BOOST_AUTO_TEST_CASE(a_message_has_every_criterion_with_what_was_computed_and_asked) {
  BOOST_TEST(text_of({held, still_open}) ==
             "share: 10.0 % (asked: at most 20 %); share: (20.0 ± 1.0) % (asked: at most 20 %), "
             "undecided: an "
             "error of 1 % reaches across the limit");
}

BOOST_AUTO_TEST_SUITE_END()
