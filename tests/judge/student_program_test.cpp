// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that answer, written in the shell.
#include "judge/student_program.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "holds.hpp"

BOOST_AUTO_TEST_SUITE(student_program_test)

using judge::Numbers;
using judge::StudentProgram;

namespace {

constexpr double no_limit = 1e9;

// The answer, or what is said of it.
std::string said(StudentProgram& program, const std::string& task, const Numbers& inputs = {}) {
  try {
    std::string text;
    for (const double number : program.answer(task, inputs)) text += std::to_string(number) + ' ';
    return text;
  } catch (const judge::NoAnswer& e) {
    return e.what();
  }
}

std::string said_by(const std::string& script, double allowance = no_limit) {
  StudentProgram program({"sh", "-c", script}, allowance);
  return said(program, "task");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_program_answers_line_by_line_with_all_digits) {
  StudentProgram program({"sh", "-c", "while read -r task x y; do echo $y $x; done"}, no_limit);

  BOOST_TEST(program.answer("swap", {0.1, 2.5e-300}) == (Numbers{2.5e-300, 0.1}));
  BOOST_TEST(program.answer("swap", {1, -2}) == (Numbers{-2, 1}));
  BOOST_TEST(program.n_answers() == 2);
}

BOOST_AUTO_TEST_CASE(the_same_question_is_asked_once) {
  StudentProgram program({"sh", "-c", "i=0; while read -r line; do i=$((i+1)); echo $i; done"},
                         no_limit);

  BOOST_TEST(said(program, "count", {1}) == "1.000000 ");
  BOOST_TEST(said(program, "count", {1}) == "1.000000 ");
  BOOST_TEST(said(program, "count", {2}) == "2.000000 ");
}

BOOST_AUTO_TEST_CASE(numbers_are_decimal_and_may_be_nan_or_infinite) {
  const Numbers found = judge::numbers_of_line(" 1 -2.5e-3  inf nan -nan ");

  BOOST_TEST(found.size() == 5U);
  BOOST_TEST(found[1] == -2.5e-3);
  BOOST_TEST(std::isinf(found[2]));
  BOOST_TEST(std::isnan(found[4]));
  for (const char* line : {"", "  ", "1,5", "0x1p3", "1;2", "one", "1 passed", "1\r", "2.2\r5",
                           "1\t2", "<b>1</b>", "1e", "+1"}) {
    BOOST_CHECK_THROW(judge::numbers_of_line(line), judge::NoAnswer);
  }
}

BOOST_AUTO_TEST_CASE(it_is_said_why_there_is_no_answer) {
  BOOST_TEST(holds(said_by("read -r line; echo PASSED"), "not a decimal number"));
  BOOST_TEST(said_by("read -r line; exit 0") == "the program ended before it answered");
  BOOST_TEST(said_by("read -r line; kill -SEGV $$") == "the program crashed (SIGSEGV)");
  BOOST_TEST(said_by("read -r line; exit 134") == "the program crashed (SIGABRT)");
  BOOST_TEST(said_by("read -r line; kill -XCPU $$") == "the program used up its processor time");
  BOOST_TEST(said_by("read -r line; yes 1 | tr -d '\\n'") == "the program's answer is too long");
  BOOST_TEST(said_by("read -r line; printf '1\\n2\\n'; read -r line") ==
             "the program answers what it was not asked");
}

BOOST_AUTO_TEST_CASE(an_answer_before_the_question_does_not_count) {
  StudentProgram program({"sh", "-c", "while read -r task; do echo 1; sleep 0.1; echo 2; done"},
                         no_limit);
  program.answer("first", {});
  ::usleep(500'000);  // the second line is there

  BOOST_TEST(said(program, "second") == "the program answers what it was not asked");
  BOOST_TEST(said(program, "third") == "1.000000 ");
}

BOOST_AUTO_TEST_CASE(a_crash_costs_its_question_and_the_program_is_started_again_twice) {
  StudentProgram program(
      {"sh", "-c", "while read -r task x; do [ $x != 7 ] || exit; echo $x; done"}, no_limit);

  BOOST_TEST(said(program, "a", {1}) == "1.000000 ");
  BOOST_TEST(said(program, "a", {7}) == "the program ended before it answered");
  BOOST_TEST(said(program, "a", {2}) == "2.000000 ");
  BOOST_TEST(said(program, "b", {7}) == "the program ended before it answered");
  BOOST_TEST(said(program, "a", {3}) == "3.000000 ");
  BOOST_TEST(said(program, "c", {7}) == "the program ended before it answered");
  BOOST_TEST(said(program, "a", {4}) == "the program had failed before and was not started again");
}

BOOST_AUTO_TEST_CASE(an_empty_answer_costs_its_question_alone) {
  StudentProgram program({"sh", "-c", "while read -r task x; do echo $x; done"}, no_limit);

  for (int i = 0; i < 5; ++i) {
    BOOST_TEST(said(program, "task" + std::to_string(i)) == "the program has no answer");
  }
  BOOST_TEST(said(program, "task", {1}) == "1.000000 ");
}

BOOST_AUTO_TEST_CASE(a_program_that_hangs_is_ended_and_without_an_allowance_not_started_again) {
  StudentProgram program({"sh", "-c", "while read -r task; do sleep 100; done"}, 0);

  BOOST_TEST(said(program, "one") == "the program did not answer in time");
  BOOST_TEST(said(program, "two") == "the program had failed before and was not started again");
  BOOST_TEST(program.lost_seconds() > 2.9);
}

BOOST_AUTO_TEST_SUITE_END()
