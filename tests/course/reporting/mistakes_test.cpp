// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/mistakes.hpp"

#include <boost/test/unit_test.hpp>

#include "course/reporting/toy_class.hpp"

BOOST_AUTO_TEST_SUITE(mistakes_test)

using namespace course;

namespace {

MistakePattern pattern(const std::string& exercise, double growth, double values, double order,
                       double sum) {
  return {.id = "wrong-" + exercise,
          .says = "a sign is lost",
          .exercises = {exercise},
          .points = {{"square-growth", growth},
                     {"square-values", values},
                     {"sum-order", order},
                     {"sum-values", sum}}};
}

std::vector<Met> met(const MistakePattern& pattern, const ClassMarks& marks) {
  return met_mistakes(toy_grading::assignment(), {pattern}, marks);
}

using Students = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(who_lost_the_same_checks_of_the_exercise_made_the_mistake) {
  // Bob has 1.5 of the six points; with the nominal numbers it would be 2.4.
  BOOST_TEST(
      (met(pattern("square", 4, 2.4, 5, 5), toy_class::marks())[0].students == Students{"bob"}));
  BOOST_TEST((met(pattern("sum", 4, 6, 5, 0), toy_class::marks())[0].students == Students{"dave"}));
}

BOOST_AUTO_TEST_CASE(what_is_missing_or_does_not_compile_is_no_mistake) {
  ClassMarks marks = toy_class::marks();
  marks.students[1].mark->not_compiling = {"square"};

  BOOST_TEST(met(pattern("square", 4, 2.4, 5, 5), marks)[0].students.empty());
}

BOOST_AUTO_TEST_CASE(an_exercise_without_any_point_is_not_done) {
  ClassMarks marks = toy_class::marks();
  marks.students[3].mark->checks["sum-order"] = 0;
  marks.students[3].mark->not_compiling = {"sum"};

  const std::vector<Met> all = met(pattern("square", 0, 0, 5, 5), marks);

  BOOST_REQUIRE(all.size() == 3U);
  BOOST_TEST(all[0].students.empty());
  BOOST_TEST(all[1].pattern.id == "not done");
  BOOST_TEST((all[1].pattern.exercises == Students{"square"}));
  BOOST_TEST((all[1].students == Students{"dave"}));
  BOOST_TEST((all[2].pattern.exercises == Students{"sum"}));
  BOOST_TEST((all[2].students == Students{"bob"}));  // Dave's does not compile
  BOOST_TEST(met_mistakes(toy_grading::assignment(), {}, marks).empty());
}

BOOST_AUTO_TEST_CASE(a_wrong_solution_that_loses_nothing_is_nobodys) {
  BOOST_TEST(met(pattern("square", 4, 6, 0, 0), toy_class::marks())[0].students.empty());
}

BOOST_AUTO_TEST_CASE(the_table_names_students_and_exercises) {
  BOOST_TEST(mistakes_csv(met(pattern("square", 4, 2.4, 5, 5), toy_class::marks())) ==
             "wrong solution,says,exercises,students,who\r\n"
             "wrong-square,a sign is lost,square,1,bob\r\n"
             "not done,no point in square,square,1,dave\r\n"
             "not done,no point in sum,sum,1,bob\r\n");
}

BOOST_AUTO_TEST_SUITE_END()
