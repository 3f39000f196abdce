// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the tests in tests/course/own_tests, as students might write them, honest or not, on the
// programs of tests/course/toy_grading.
#include "course/marking/own_tests.hpp"
#include "message_of.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>
#include <map>

#include "course/assignment/assignment.hpp"
#include "course/marking/grade.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "course/toy_grading.hpp"
#include "course/walls.hpp"
#include "holds.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(own_tests_test, *boost::unit_test::fixture(&need_walls))

using namespace course;
namespace fs = std::filesystem;

namespace {

constexpr const char* file = "src/tests/square.cpp";

/// The toy, which asks for tests of `square` that are worth 10 points more.
Assignment assignment() {
  Assignment toy = toy_grading::assignment();
  toy.points = 30;
  toy.exercises[0].tests = file;
  toy.exercises[0].checks.push_back(
      {"square-tests", 10, Visibility::tests, "your tests catch wrong programs", ""});
  return toy;
}

const fs::path& toolkit() {
  static const TemporaryFolder made;
  static const fs::path path = [] {
    make_toolkit(assignment(), HALFSPACE_SOURCE_DIR, made.path() / "toolkit");
    fs::permissions(made.path(), fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add);
    return made.path() / "toolkit";
  }();
  return path;
}

std::string fixture(const std::string& name) {
  return sys::read_file(fs::path(HALFSPACE_SOURCE_DIR) / "tests/course/own_tests" /
                        (name + ".cpp"));
}

/// The solution with these tests.
Files with_tests(const std::string& name) {
  Files files = toy_grading::solution();
  files[file] = fixture(name);
  return files;
}

struct Tried {
  double points = 0;
  std::string message;
  std::vector<std::string> missed;
};

Tried tried(const std::string& name, Isolation isolation = Isolation::sandbox,
            const Assignment& toy = assignment(), double seconds_so_far = 0) {
  const ScratchFolder scratch;
  const Files files = with_tests(name);
  Tried tried;
  const Checks checks = with_own_tests({},
                                       {.assignment = toy,
                                        .toolkit = toolkit(),
                                        .files = files,
                                        .scratch = scratch.path() / "own tests",
                                        .seconds_so_far = [=] { return seconds_so_far; },
                                        .isolation = isolation},
                                       tried.missed);
  const Outcome outcome = checks.at("square-tests")({}, {});
  tried.points = 10 * outcome.share;
  tried.message = outcome.message;
  return tried;
}

void check_tried(const std::string& name, double points, const std::string& message) {
  const Tried found = tried(name);
  BOOST_TEST(found.points == points, name << " has " << found.points << " points");
  BOOST_TEST(found.message.starts_with(message), name << ": " << found.message);
}

/// Grades these files into the folder `output`/alice.
Graded graded(const Files& files, const TemporaryFolder& output) {
  const TemporaryFolder folder;
  const fs::path submission = toy_grading::write(folder, "alice", files);
  return grade_submission(assignment(), toy_grading::task_for(submission, toolkit()),
                          output.path() / "alice");
}

}  // namespace

BOOST_AUTO_TEST_CASE(tests_have_points_for_each_wrong_program_that_they_catch) {
  check_tried("honest", 10, "your tests catch 4 of 4 wrong programs");
  check_tried("partial", 2.5, "your tests catch 1 of 4 wrong programs");
  BOOST_TEST(tried("partial").missed ==
                 (std::vector<std::string>{"src/tests/square.cpp does not catch ends-below-zero",
                                           "src/tests/square.cpp does not catch never-ends-far-off",
                                           "src/tests/square.cpp does not catch sign-kept"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(tests_may_print_and_ask_what_depends_on_answers) {
  check_tried("prints", 10, "your tests catch 4 of 4");
  check_tried("asks_what_depends_on_answers", 10, "your tests catch 4 of 4");
  check_tried("waits_for_an_answer", 2.5, "your tests catch 1 of 4");
}

BOOST_AUTO_TEST_CASE(tests_may_ask_what_is_infinite) {
  check_tried("asks_what_is_infinite", 5, "your tests catch 2 of 4");
}

BOOST_AUTO_TEST_CASE(tests_that_check_nothing_or_reject_the_right_program_have_no_points) {
  check_tried("empty", 0, "your tests check nothing");
  check_tried("always_fails", 0,
              "your tests reject the right program: line 8, «check(false, \"never\");»");
  check_tried(
      "rejects_the_right", 0,
      "your tests reject the right program: line 9, «check(square(2) == 5, \"two again\");»");
}

BOOST_AUTO_TEST_CASE(tests_that_come_to_no_end_catch_nothing) {
  check_tried("exits_early", 0,
              "your tests ended before their last check when they tried the right");
  check_tried("exits_where_a_check_fails", 0, "your tests catch 0 of 4 wrong programs");
  check_tried("crashes_on_wrong_programs", 0, "your tests catch 0 of 4 wrong programs");
  check_tried("throws", 0, "your tests crashed when they tried the right program");
  check_tried("never_ends", 0, "your tests took longer than 1 s when they tried the right program");
}

BOOST_AUTO_TEST_CASE(all_runs_of_tests_together_have_one_limit) {
  Assignment toy = assignment();
  toy.limits.run_seconds = 5;
  toy.limits.submission_seconds = static_cast<int>(toy.exercises.size() + 1);  // a second for tests
  const Tried sleepers = tried("sleeps", Isolation::sandbox, toy);
  BOOST_TEST(sleepers.points == 0);
  BOOST_TEST(sleepers.message.starts_with("your tests took longer than 1 s in all"),
             sleepers.message);
}

BOOST_AUTO_TEST_CASE(tests_have_no_more_time_than_compiling_and_answers_left) {
  const Assignment toy = assignment();
  const int all = toy.limits.submission_seconds;

  BOOST_TEST(tried("sleeps", Isolation::sandbox, toy, all - 0.5)
                 .message.starts_with(fmt::format(
                     "your tests took longer than what all answers had left of {} s", all)));
  BOOST_TEST(tried("honest", Isolation::sandbox, toy, all + 0.5).message ==
             "all answers took the time that there is for the tests, too");
}

BOOST_AUTO_TEST_CASE(tests_gain_nothing_but_by_answers) {
  check_tried("says_that_it_ended", 0, "your tests catch 0 of 4 wrong programs");
  check_tried("forks", 0, "your tests catch 0 of 4 wrong programs");
  check_tried("asks_by_chance", 0,
              "your tests asked more than 300 questions one after the other, each of which depends "
              "on the answer before when they tried the");
  check_tried("asks_another_task", 0,
              "your tests asked about several tasks when they tried the right program");
  check_tried("looks_for_the_program", 0, "your tests catch 0 of 4 wrong programs");
  // A busy machine may let it reject the right program the first time.
  BOOST_TEST(tried("goes_by_the_clock").points == 0);
  // Of 210 orders one is that which it waits for.
  BOOST_TEST((tried("keeps_step_with_the_clock").points == 0 ||
              tried("keeps_step_with_the_clock").points == 0));
}

BOOST_AUTO_TEST_CASE(tests_reach_no_function_of_their_author) {
  check_tried("calls_its_own_function", 0, "src/tests/square.cpp is not compiled: ");
  BOOST_TEST(
      holds(tried("calls_its_own_function").message, "undefined reference to `square(double)"));
  check_tried("includes_its_own_function", 0, "your tests reject the right program: line ");
  check_tried("is_no_cpp", 0, "src/tests/square.cpp is not compiled: src/tests/square.cpp");
}

BOOST_AUTO_TEST_CASE(without_walls_tests_find_no_program_either) {
  BOOST_TEST(tried("honest", Isolation::none).points == 10);
  BOOST_TEST(tried("looks_beside_itself", Isolation::none).message ==
             "your tests catch 0 of 4 wrong programs");
}

BOOST_AUTO_TEST_CASE(the_student_is_told_how_many_are_caught_and_the_instructor_which_are_not) {
  const TemporaryFolder folder;

  const Graded partial = graded(with_tests("partial"), folder);

  BOOST_TEST(mark_of(partial) == 22.5);
  for (const char* name : {"feedback.html", "results.json"}) {
    const std::string text = sys::read_file(folder.path() / "alice" / name);
    BOOST_TEST(holds(text, "your tests catch 1 of 4 wrong programs"), text);
    for (const char* secret : {"sign-kept", "sign of the number", "ends-below-zero", "third-power",
                               "never-ends", "does not catch"}) {
      BOOST_TEST(!holds(text, secret), name << " tells of " << secret);
    }
  }
  const std::string log = sys::read_file(folder.path() / "alice/log.txt");
  BOOST_TEST(holds(log, "does not catch sign-kept\n"), log);
  BOOST_TEST(!holds(log, "third-power"));
}

BOOST_AUTO_TEST_CASE(nothing_that_tests_write_of_the_right_programs_answers_is_told) {
  const TemporaryFolder folder;

  const Graded teller = graded(with_tests("tells_what_the_right_one_answers"), folder);

  BOOST_TEST(mark_of(teller) == 20);
  for (const char* name : {"feedback.html", "results.json", "log.txt", "mark.json"}) {
    const std::string text = sys::read_file(folder.path() / "alice" / name);
    BOOST_TEST(!holds(text, "1522756"), text);
  }
}

BOOST_AUTO_TEST_CASE(a_submission_without_tests_loses_their_points_alone) {
  const TemporaryFolder folder;

  const Graded found = graded(toy_grading::solution(), folder);

  BOOST_TEST(mark_of(found) == 20);
  BOOST_TEST(result_of(found, "square-tests").message == "src/tests/square.cpp was not taken");
}

BOOST_AUTO_TEST_CASE(tests_count_whatever_the_students_own_function_is_like) {
  const TemporaryFolder folder;
  Files files = with_tests("honest");
  files["src/square.cpp"] = files["src/sum.cpp"] = "this is no C++\n";

  BOOST_TEST(mark_of(graded(files, folder)) == 10);
}

BOOST_AUTO_TEST_CASE(the_programs_lie_beside_the_toolkit_where_no_other_user_reads_them) {
  const fs::path programs = open_toolkit(assignment(), toolkit()).programs_of("square");

  BOOST_TEST(
      sys::files_below(programs) ==
          (std::vector<std::string>{"right", "wrong/ends-below-zero", "wrong/never-ends-far-off",
                                    "wrong/sign-kept", "wrong/third-power"}),
      boost::test_tools::per_element());
  BOOST_CHECK(fs::status(programs.parent_path()).permissions() == fs::perms::owner_all);
  fs::remove(programs / "right");
  BOOST_CHECK_THROW(open_toolkit(assignment(), toolkit()), sys::OutputError);
  make_toolkit(assignment(), HALFSPACE_SOURCE_DIR, toolkit());
  BOOST_CHECK_NO_THROW(open_toolkit(assignment(), toolkit()));
}

BOOST_AUTO_TEST_CASE(tests_that_nothing_could_fail_are_told_when_the_toolkit_is_made) {
  const TemporaryFolder folder;
  Assignment toy = assignment();
  fs::copy(toy.folder, folder.path() / "toy", fs::copy_options::recursive);
  toy.folder = folder.path() / "toy";
  folder.write("toy/wrong_solutions.toml", "");

  const std::string message = message_of<sys::SourceError>(
      [&] { make_toolkit(toy, HALFSPACE_SOURCE_DIR, folder.path() / "toolkit"); });
  BOOST_TEST(message.ends_with("wrong_solutions.toml: no wrong solution changes src/square.cpp, on "
                               "which src/tests/square.cpp could be tried"),
             message);
}

BOOST_AUTO_TEST_SUITE_END()
