// SPDX-License-Identifier: GPL-3.0-or-later
// The list of wrong solutions fits the instructor's one. What they score is proved at release.
#include "course/wrong_solutions.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "assignment/programs.hpp"
#include "course/handout.hpp"

namespace {

const course::Assignment description = programs::assignment();

course::Files solution() {
  const course::Project project = course::read_project(description, HALFSPACE_SOURCE_DIR);
  return course::submission(description, course::texts(project, course::Edition::solution));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_mistake_fits_into_the_solution_and_costs_points) {
  const auto list = course::read_wrong_solutions(description, solution());

  BOOST_TEST(list.size() >= 12U);
  for (const course::WrongSolution& wrong : list) {
    BOOST_TEST(wrong.score < description.points, wrong.id);
  }
}

BOOST_AUTO_TEST_CASE(every_exercise_is_made_wrong_at_least_twice) {
  std::multiset<std::string> files;
  for (const auto& wrong : course::read_wrong_solutions(description, solution())) {
    files.insert(wrong.file);
  }

  for (const course::Exercise& exercise : description.exercises) {
    BOOST_TEST(files.count(exercise.file) >= 2U, exercise.file);
  }
}
