// SPDX-License-Identifier: GPL-3.0-or-later
// main() of every unit test; Boost.Test writes it.
#define BOOST_TEST_MODULE halfspace
#include <boost/test/unit_test.hpp>
