// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/limit.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(limit_test)

using literate::Limit;
using literate::LimitKind;

BOOST_AUTO_TEST_CASE(a_limit_of_theory_is_evaluated_from_the_formula_that_is_printed) {
  const Limit limit = Limit::theory("μ(c/a)²", {{"μ", 0.3}, {"c", 1}, {"a", 10}}, "the order");
  BOOST_TEST(limit.number() == 0.003);
  BOOST_TEST((limit.kind() == LimitKind::theory));
  BOOST_TEST(Limit::theory("c/a", {{"c", 2}, {"a", 3}}, "the step", 5).number() == 0.66667);
  BOOST_TEST(limit.reason() == "μ(c/a)², the order");
  BOOST_CHECK_THROW(Limit(LimitKind::theory, 0.003, "μ(c/a)²"), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_limit_that_is_none_of_its_kind_is_refused) {
  BOOST_CHECK_THROW(Limit(LimitKind::data, 0.1234, "printed"), std::invalid_argument);
  BOOST_CHECK_THROW(Limit(LimitKind::method, 1e-11, "rounding"), std::invalid_argument);
  BOOST_TEST(Limit(LimitKind::data, 0.123, "printed").number() == 0.123);
  BOOST_TEST(Limit(LimitKind::data, 117, "a count").number() == 117);
  BOOST_TEST(Limit(LimitKind::method, 1.234e-11, "this run's").number() == 1.23e-11);
  BOOST_TEST(Limit(LimitKind::method, 3, "of the coarsest grid").number() == 3);
}

BOOST_AUTO_TEST_SUITE_END()
