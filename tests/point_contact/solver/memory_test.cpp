// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(memory_test)

using Eigen::Index;
using point_contact::require_memory;
using sys::InvalidQuantity;

BOOST_AUTO_TEST_CASE(memory_that_is_not_there_is_told_before_it_is_asked_for) {
  BOOST_CHECK_NO_THROW(require_memory(1024, 1024));
  BOOST_CHECK_EXCEPTION(require_memory(2'000'000, 2'000'000), InvalidQuantity,
                        [](const InvalidQuantity& error) {
                          return error.quantity() == "nodes" &&
                                 error.allowed().find("GB of memory") != std::string::npos;
                        });
  BOOST_CHECK_THROW(require_memory(Index{1} << 40, Index{1} << 40), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
