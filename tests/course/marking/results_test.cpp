// SPDX-License-Identifier: GPL-3.0-or-later
// The files that students get back: results.json and feedback.html.
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "course/marking/feedback.hpp"
#include "course/marking/grade.hpp"
#include "course/toy_grading.hpp"
#include "course/walls.hpp"
#include "holds.hpp"
#include "system/error.hpp"
#include "system/process.hpp"

BOOST_AUTO_TEST_SUITE(results_test, *boost::unit_test::fixture(&need_walls))

using namespace course;

namespace {

Graded graded() {
  Graded one;
  one.student = "alice";
  one.late = {.days = 1, .percent = 10};
  one.compile_errors = {{"sum", "src/sum.cpp:1: error: <script>alert('&')</script>\n"}};
  one.results = {{"square-growth", 4, ""},
                 {"square-values", 1.5, "hidden message"},
                 {"sum-order", 0, "of <b>sums</b>"},
                 {"sum-values", 0, "hidden message"}};
  return one;
}

}  // namespace

BOOST_AUTO_TEST_CASE(gradescope_gets_a_test_a_check_and_the_mark) {
  const auto json = nlohmann::json::parse(gradescope_json(toy_grading::assignment(), graded()));

  BOOST_TEST(json["score"].get<double>() == 4.95);
  BOOST_TEST(json["tests"].size() == 4U);
  BOOST_TEST(json["tests"][0]["status"] == "passed");
  BOOST_TEST(json["tests"][1]["status"] == "failed");
  BOOST_TEST(json["tests"][1]["score"].get<double>() == 1.5);
  BOOST_TEST(json["tests"][1]["max_score"].get<double>() == 6);
  BOOST_TEST(json["tests"][2]["output"] == "of <b>sums</b>");
  BOOST_TEST(json["output"].get<std::string>().starts_with(
      "Handed in 1 day late: 10 % of the points are deducted.\nExercise sum is not compiled:\n"));
}

BOOST_AUTO_TEST_CASE(gradescope_keeps_what_is_held_back_until_it_is_published) {
  Assignment assignment = toy_grading::assignment();
  BOOST_TEST(nlohmann::json::parse(gradescope_json(assignment, graded()))["visibility"] ==
             "visible");
  assignment.holds_feedback_back = true;

  const auto json = nlohmann::json::parse(gradescope_json(assignment, graded()));

  BOOST_TEST(json["visibility"] == "after_published");
  for (const auto& test : json["tests"]) BOOST_TEST(test["visibility"] == "after_published");
}

BOOST_AUTO_TEST_CASE(hidden_checks_tell_their_points_and_nothing_more) {
  for (const std::string& text : {gradescope_json(toy_grading::assignment(), graded()),
                                  feedback_html(toy_grading::assignment(), graded(), {})}) {
    BOOST_TEST(!holds(text, "hidden message"), text);
    BOOST_TEST(holds(text, "squares at points of your own"));
  }
  BOOST_TEST(holds(log_text(toy_grading::assignment(), graded()), "hidden message"));
}

BOOST_AUTO_TEST_CASE(what_students_write_is_no_markup) {
  const std::string text = feedback_html(toy_grading::assignment(), graded(), {});

  BOOST_TEST(!holds(text, "<script>"));
  BOOST_TEST(!holds(text, "<b>"));
  BOOST_TEST(holds(text, "&lt;script&gt;alert('&amp;')&lt;/script&gt;"), text);
}

namespace {

const std::filesystem::path no_style = "there is none";

}  // namespace

BOOST_AUTO_TEST_CASE(a_curve_has_the_colour_that_the_style_of_the_figures_has) {
  const TemporaryFolder folder;
  const auto style = folder.write("style.gp", "set style line 1 lc rgb '#123456'\n");
  const Curve curve{"Your own", "x in m", "p in Pa", {-1, 0, 1}, {2, 3e6, 2}};

  BOOST_TEST(holds(svg_of(curve, style), "rgb( 18,  52,  86)"));
  BOOST_TEST(!holds(svg_of(curve, no_style), "rgb( 18,  52,  86)"));
}

BOOST_AUTO_TEST_CASE(a_curve_is_drawn_and_the_same_numbers_give_the_same_picture) {
  const Curve curve{"Your own", "x in m", "p in Pa", {-1, 0, 1}, {2, 3e6, 2}};

  const std::string svg = svg_of(curve, no_style);

  BOOST_TEST(holds(svg, "<svg"));
  BOOST_TEST(svg_of(curve, no_style) == svg);
  const std::string page = feedback_html(toy_grading::assignment(), graded(), {svg});
  BOOST_TEST(holds(page, "<figure><svg"));
  BOOST_TEST(holds(page, "Your own"));
}

BOOST_AUTO_TEST_CASE(numbers_that_cannot_be_drawn_are_left_out) {
  BOOST_TEST(svg_of({"none", "x", "y", {}, {}}, no_style) == "");
  BOOST_TEST(svg_of({"unequal", "x", "y", {1, 2}, {1}}, no_style) == "");
  BOOST_CHECK_NO_THROW(svg_of({"huge", "x", "y", {0, 1}, {-1.7e308, 1.7e308}}, no_style));
}

BOOST_AUTO_TEST_CASE(a_submission_becomes_a_folder_and_regrading_changes_no_byte) {
  const TemporaryFolder folder;
  GradingTask task =
      toy_grading::task_for(toy_grading::write(folder, "alice", toy_grading::solution()));
  task.submitted = toy_grading::assignment().deadline + std::chrono::hours(1);
  task.curves = [](const Program& program, const Variant&) {
    return std::vector<Curve>{{"Squares", "x", "y", {1, 2, 3}, program("square", {1, 2, 3})}};
  };

  const Graded first = grade_submission(toy_grading::assignment(), task, folder.path() / "first");
  grade_submission(toy_grading::assignment(), task, folder.path() / "second");

  BOOST_TEST(mark_of(first) == 18);
  const auto files = sys::files_below(folder.path() / "first");
  BOOST_TEST(
      files == (std::vector<std::string>{"feedback.html", "log.txt", "mark.json", "results.json"}),
      boost::test_tools::per_element());
  for (const std::string& file : files) {
    BOOST_TEST(sys::read_file(folder.path() / "first" / file) ==
               sys::read_file(folder.path() / "second" / file));
  }
}

BOOST_AUTO_TEST_SUITE_END()
