// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/statistics.hpp"

#include <boost/test/unit_test.hpp>

#include "course/reporting/toy_class.hpp"

BOOST_AUTO_TEST_SUITE(statistics_test)

using namespace course;

namespace {

// The reference numbers are Python's: statistics.mean, stdev and median, and Pearson's correlation
// written out, of the class in toy_class.hpp. Sums of four numbers round to some 1e-16.
constexpr double rel_rounding = 1e-12;

ClassStatistics of(const ClassMarks& marks) {
  return statistics_of(toy_grading::assignment(), marks);
}

}  // namespace

BOOST_AUTO_TEST_CASE(marks_are_summed_up_after_deductions) {
  const ClassStatistics statistics = of(toy_class::marks());

  BOOST_TEST(statistics.n_graded == 4U);
  BOOST_TEST(statistics.mean == 10.475, boost::test_tools::tolerance(rel_rounding));
  BOOST_TEST(statistics.standard_deviation == 7.341832196393486,
             boost::test_tools::tolerance(rel_rounding));
  BOOST_TEST(statistics.least == 4.4);
  BOOST_TEST(statistics.median == 8.75);
  BOOST_TEST(statistics.most == 20);
  const std::vector<std::size_t> histogram = {0, 0, 2, 0, 0, 0, 1, 0, 0, 1};
  BOOST_TEST(statistics.histogram == histogram, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(items_have_facility_and_discrimination_before_deductions) {
  const ClassStatistics statistics = of(toy_class::marks());

  BOOST_REQUIRE(statistics.items.size() == 4U);
  const std::vector<double> facility = {0.75, 0.5625, 0.5, 0.375};
  const std::vector<double> discrimination = {0.2957887112070247, 0.6997710766866327,
                                              -0.12711407958211074, 0.9989535185064018};
  for (std::size_t i = 0; i < 4; ++i) {
    BOOST_TEST(statistics.items[i].facility == facility[i]);
    BOOST_TEST(statistics.items[i].discrimination.value() == discrimination[i],
               boost::test_tools::tolerance(rel_rounding));
  }
  BOOST_TEST(statistics.items[0].n_full == 3U);
  BOOST_TEST(statistics.items[3].n_none == 2U);
  BOOST_TEST(statistics.reliability.value() == 0.5929648241206029,
             boost::test_tools::tolerance(rel_rounding));
}

BOOST_AUTO_TEST_CASE(what_is_the_same_for_everybody_correlates_with_nothing) {
  ClassMarks marks = toy_class::marks();
  marks.students = {marks.students[0], marks.students[0]};

  const ClassStatistics statistics = of(marks);

  BOOST_TEST(!statistics.items[0].discrimination);
  BOOST_TEST(!statistics.reliability);
  BOOST_TEST(items_csv(statistics).find("square-growth,square,public,4,2,1.000,,2,0\r\n") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_class_without_a_mark_has_no_statistics) {
  ClassMarks marks;
  marks.students.push_back({.student = "erin", .state = "missing"});

  BOOST_TEST(of(marks).n_graded == 0U);
  BOOST_TEST(of(marks).items.empty());
}

BOOST_AUTO_TEST_SUITE_END()
