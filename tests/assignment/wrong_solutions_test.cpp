// SPDX-License-Identifier: GPL-3.0-or-later
// The list of wrong solutions fits the instructor's solution. Their points are proved at release.
#include "course/release/wrong_solutions.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>

#include "assignment/programs.hpp"
#include "course/release/handout.hpp"
#include "holds.hpp"
#include "system/files.hpp"

BOOST_AUTO_TEST_SUITE(wrong_solutions_test)

namespace {

const course::Assignment description = programs::assignment();

course::Files solution() {
  const course::Project project = course::read_project(description, HALFSPACE_SOURCE_DIR);
  return course::submission(description, course::texts(project, course::Edition::solution));
}

double points_of(course::Visibility visibility) {
  double sum = 0;
  for (const course::Exercise& exercise : description.exercises) {
    for (const course::CheckEntry& check : exercise.checks) {
      if (check.visibility == visibility) sum += check.points;
    }
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_mistake_fits_into_the_solution_and_costs_points) {
  const auto list = course::read_wrong_solutions(description, solution());

  BOOST_TEST(list.size() >= 12U);
  for (const course::WrongSolution& wrong : list) {
    BOOST_TEST(wrong.points < description.points - points_of(course::Visibility::tests), wrong.id);
  }
}

// What is wrong in the programs on which they try their tests, students do not get.
BOOST_AUTO_TEST_CASE(the_handout_says_nothing_of_a_wrong_solution) {
  const course::Project project = course::read_project(description, HALFSPACE_SOURCE_DIR);
  for (const auto& wrong : course::read_wrong_solutions(description, solution())) {
    for (const auto& [file, text] : course::texts(project, course::Edition::handout)) {
      BOOST_TEST(!holds(text, wrong.says), file << " says: " << wrong.says);
      BOOST_TEST((wrong.id == "constants" || !holds(text, wrong.id)),
                 file << " names " << wrong.id);
    }
  }
}

// Numbers that only agree with each other have most of the public checks.
BOOST_AUTO_TEST_CASE(constants_and_answers_without_a_formula_have_five_points_at_most) {
  const auto list = course::read_wrong_solutions(description, solution());

  for (const char* id : {"constants", "no-formula"}) {
    const auto wrong = std::ranges::find(list, id, &course::WrongSolution::id);
    BOOST_TEST_REQUIRE((wrong != list.end()), id);
    BOOST_TEST(wrong->points <= 5, id);
    BOOST_TEST(wrong->changes.size() >= 4U, id);
  }
}

BOOST_AUTO_TEST_CASE(new_points_change_nothing_else_in_the_list) {
  const std::string text = sys::read_file(description.folder / "wrong_solutions.toml");
  std::vector<double> points;
  for (const auto& wrong : course::read_wrong_solutions(description, solution())) {
    points.push_back(wrong.points);
  }
  BOOST_TEST(course::with_points(text, points) == text);

  const std::string list =
      "[[wrong]]\npoints = 1\nafter = \"\"\"\npoints = 2\n\"\"\"\n[[wrong]]\npoints = 3  # ?\n";
  BOOST_TEST(
      course::with_points(list, {4, 5.25}) ==
      "[[wrong]]\npoints = 4\nafter = \"\"\"\npoints = 2\n\"\"\"\n[[wrong]]\npoints = 5.25\n");
}

BOOST_AUTO_TEST_CASE(public_checks_alone_give_40_points_at_most) {
  BOOST_TEST(points_of(course::Visibility::visible) <= 0.4 * description.points);
}

BOOST_AUTO_TEST_CASE(make_check_lists_every_exercise_with_the_title_of_the_sheet) {
  const course::Project project = course::read_project(description, HALFSPACE_SOURCE_DIR);
  const std::string program = project.at("checks/main.cpp").text.handout;
  int number = 0;
  for (const course::Exercise& exercise : description.exercises) {
    const std::string line = "{\"" + std::to_string(++number) + ". " + exercise.title + "\", ";
    BOOST_TEST(holds(program, line), line);
  }
}

BOOST_AUTO_TEST_CASE(every_exercise_is_made_wrong_at_least_twice) {
  std::multiset<std::string> files;
  for (const auto& wrong : course::read_wrong_solutions(description, solution())) {
    for (const course::Change& change : wrong.changes) files.insert(change.file);
  }

  for (const course::Exercise& exercise : description.exercises) {
    BOOST_TEST(files.count(exercise.file) >= 2U, exercise.file);
  }
}

BOOST_AUTO_TEST_SUITE_END()
