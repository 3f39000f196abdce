// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/assignment.hpp"
#include "message_of.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>

#include "config/table.hpp"
#include "course/toy.hpp"
#include "holds.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(assignment_test)

using config::Error;

namespace {

const std::string toy_text = sys::read_file(toy::folder / "assignment.toml");

// Reads the toy's assignment with `before`, which must stand in it, replaced.
course::Assignment read_with(const std::string& before, const std::string& after,
                             const TemporaryFolder& folder) {
  std::string text = toy_text;
  BOOST_REQUIRE(holds(text, before));
  text.replace(text.find(before), before.size(), after);
  folder.write("assignment.toml", text);
  folder.write("template/src/root.cpp", "");
  folder.write("template/src/mean.cpp", "");
  folder.write("template/src/mean_tests.cpp", "");
  return course::read_assignment(folder.path());
}

// Checks that the error is in the line of the toy's assignment where `before` begins, or `n_below`
// lines later.
void check_error(const std::string& before, const std::string& after, const std::string& expected,
                 int n_below = 0) {
  const TemporaryFolder folder;
  const auto end = toy_text.begin() + static_cast<long>(toy_text.find(before));
  const auto line = std::count(toy_text.begin(), end, '\n') + 1 + n_below;
  const std::string place =
      (folder.path() / "assignment.toml").string() + ":" + std::to_string(line) + ":";
  const std::string what = message_of<Error>([&] { read_with(before, after, folder); });
  BOOST_TEST((what.starts_with(place) && holds(what, expected) && !holds(what, "\n")), what);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_toy_is_read_as_it_stands) {
  const course::Assignment toy = toy::assignment();

  BOOST_TEST(toy.title == "Roots and means");
  BOOST_TEST(toy.deadline.time_since_epoch().count() == 1800053940);
  BOOST_TEST(toy.points == 10);
  BOOST_TEST(toy.late.days == 5);
  BOOST_TEST(toy.late.slip_days == 0);
  BOOST_TEST(toy.limits.run_seconds == 2);
  BOOST_TEST(toy.limits.compile_seconds == course::Limits().compile_seconds);
  BOOST_REQUIRE(toy.exercises.size() == 2);
  BOOST_TEST(toy.exercises[0].points() == 6);
  BOOST_TEST((toy.exercises[1].builds_on == std::vector<std::string>{"root"}));
  BOOST_CHECK(toy.exercises[1].checks[0].visibility == course::Visibility::visible);
  BOOST_CHECK(toy.exercises[1].checks[1].visibility == course::Visibility::hidden);
  BOOST_REQUIRE(toy.quantities.size() == 2);
  BOOST_TEST(toy.quantities[0].unit == "m");
}

BOOST_AUTO_TEST_CASE(points_must_add_up) {
  check_error("points = 10", "points = 11", "11, but the checks' points add up to 10");
  check_error("points = 10", "points = -1", "-1 is not positive");
  check_error("floor = 0", "floor = 10.5", "10.5 is not from 0 to 10");
}

BOOST_AUTO_TEST_CASE(an_exercise_needs_a_check_and_a_file_of_its_own) {
  check_error("check = [\n  {id = \"mean-zeros\"", "no_check = [\n  {id = \"mean-zeros\"",
              "exercise \"mean\" has no [[exercise.check]]", -4);
  check_error("\"src/mean.cpp\"", "\"src/median.cpp\"", "there is no template/src/median.cpp");
  check_error("\"src/mean.cpp\"", "\"src/root.cpp\"", "another exercise's file");
  check_error("\"src/mean.cpp\"", "\"../mean.cpp\"", "is not a plain path");
}

BOOST_AUTO_TEST_CASE(an_exercise_with_a_file_of_tests_has_one_check_that_they_decide) {
  const std::string fault = "\" has 0 checks of visibility \"tests\", not one for a file `tests`";
  check_error("file = \"src/mean.cpp\"", "file = \"src/mean.cpp\"\ntests = \"src/mean_tests.cpp\"",
              "exercise \"mean" + fault, -2);
  check_error("visibility = \"public\", says = \"the", "visibility = \"tests\", says = \"the",
              "exercise \"mean\" has 1 checks of visibility \"tests\"", -5);
  check_error("file = \"src/mean.cpp\"", "file = \"src/mean.cpp\"\ntests = \"src/none.cpp\"",
              "there is no template/src/none.cpp", 1);
  check_error("file = \"src/mean.cpp\"", "file = \"src/mean.cpp\"\ntests = \"src/root.cpp\"",
              "src/root.cpp is another exercise's file already", 1);
}

BOOST_AUTO_TEST_CASE(ids_are_words_and_each_its_own) {
  check_error("id = \"mean\"", "id = \"root\"", "\"root\" stands here again");
  check_error("id = \"mean-zeros\"", "id = \"root-square\"", "\"root-square\" stands here again");
  check_error("id = \"mean\"", "id = \"the mean\"", "\"the mean\" is not of letters");
  check_error("id = \"mean\"", "id = \"\"", "must not be empty");
  check_error("name = \"second\"", "name = \"first\"", "\"first\" stands here again");
}

BOOST_AUTO_TEST_CASE(an_exercise_builds_on_earlier_ones_alone) {
  check_error("[\"root\"]", "[\"roof\"]", "there is no exercise \"roof\" before this one");
  check_error("[\"root\"]", "[\"mean\"]", "there is no exercise \"mean\" before this one");
  check_error("file = \"src/root.cpp\"", "file = \"src/root.cpp\"\nbuilds_on = [\"mean\"]",
              "there is no exercise \"mean\" before this one", 1);
}

BOOST_AUTO_TEST_CASE(a_quantitys_nominal_value_is_one_that_it_may_have) {
  check_error("nominal = 2.3", "nominal = 2.35", "2.35 is not 1.1 + k 0.1; the nearest that is");
  check_error("nominal = 2.3", "nominal = 10", "10 is not from 1.1 to 9.9");
  check_error("to = 9.9", "to = 1", "1 is not from 1.1 to inf");
  check_error("step = 0.1", "step = 0", "0 is not positive");
  check_error("step = 0.1", "step = 1e-12", "makes more than 1e9 values");
}

BOOST_AUTO_TEST_CASE(a_slip_of_the_pen_has_its_place) {
  check_error("title = \"Roots and means\"", "titel = \"\"",
              "title: missing, did you mean 'titel'?");
  check_error("floor = 0", "floor = 0\nflor = 2", "flor: unknown key", 1);
  check_error("run_seconds = 2", "run_second = 2", "limits.run_second: unknown key");
  check_error("run_seconds = 2", "run_seconds = 0", "0 is not from 1 to 86400");
  check_error("[limits]", "[single_numbers]\nsum = 0\n[limits]", "sum: 0 is not from 1 to 1000", 1);
  check_error("percent_per_day = 10", "percent_per_day = 110", "110 is not from 0 to 100");
  const std::string criterion = "[[criterion]]\nid = \"words\"\ntitle = \"Words\"\nsays = \"x\"\n";
  check_error("[late]\n", criterion + "points = 0\n\n[late]\n", "0 is not positive", 4);
  check_error("[late]\n", criterion + "points = 1\n" + criterion + "points = 1\n\n[late]\n",
              "\"words\" stands here again", 6);
  check_error("points = 10\n", "points = 10\nfeedback = \"never\"\n",
              "\"never\" is not \"at once\" or \"held back\"", 1);
  check_error("days = 5\n", "days = 5\ngrace_minutes = 1441\n", "1441 is not from 0 to 1440", 1);
  check_error("days = 5\n", "days = 5\nslip_days = -1\n", "-1 is not from 0 to 366", 1);
  check_error("2027-01-15T23:59:00+01:00", "2027-01-15", "deadline: must be a date and time");
  check_error("visibility = \"hidden\", says = \"the", "visibility = \"secret\", says = \"the",
              "\"secret\" is not \"public\", \"hidden\" or \"tests\"");
  check_error("[\"course/assignment/check.hpp\"", "[\"/etc/passwd\"", "is not a plain path");
  check_error("[\"course/assignment/check.hpp\"", "[\"course/assignment/variant.hpp\"",
              "stands here twice");
}

BOOST_AUTO_TEST_CASE(an_exercise_has_a_check) {
  const TemporaryFolder folder;
  folder.write("template/src/root.cpp", "");
  folder.write("assignment.toml",
               "title = \"t\"\ndeadline = 2027-01-15T23:59:00Z\npoints = 1\nfloor = 0\n"
               "[[exercise]]\nid = \"root\"\ntitle = \"t\"\nfile = \"src/root.cpp\"\ncheck = []\n");

  const std::string what = message_of<Error>([&] { course::read_assignment(folder.path()); });
  BOOST_TEST(what.ends_with("assignment.toml:6:6: exercise.id: exercise \"root\" has no "
                            "[[exercise.check]]"),
             what);
}

BOOST_AUTO_TEST_CASE(code_and_list_have_the_same_checks) {
  const course::Assignment toy = toy::assignment();
  const auto error_of = [&](const course::Checks& visible, const course::Checks& hidden) {
    return message_of<Error>([&] { course::all_checks(toy, visible, hidden); });
  };

  auto visible = toy::public_checks();
  const auto hidden = toy::hidden_checks();
  BOOST_TEST(course::all_checks(toy, visible, hidden).size() == 4U);
  BOOST_TEST(holds(error_of(hidden, visible),
                   "assignment.toml:20:9: exercise.check.id: no public check of the code has "
                   "the id \"root-square\""));
  visible["root-extra"] = visible["root-square"];
  BOOST_TEST(holds(error_of(visible, hidden), "has the id \"root-extra\""));
}

BOOST_AUTO_TEST_SUITE_END()
