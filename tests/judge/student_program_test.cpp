// SPDX-License-Identifier: GPL-3.0-or-later
// The students' programs of these tests are shell scripts.
#include "judge/student_program.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "messages.hpp"

BOOST_AUTO_TEST_SUITE(student_program_test)

using judge::Numbers;
using judge::StudentProgram;

namespace {

constexpr double no_limit = 1e9;

// Returns the answer, or the reason why there is none.
std::string answer_or_reason(StudentProgram& program, const std::string& task,
                             const Numbers& inputs = {}) {
  try {
    std::string text;
    for (const double number : program.answer(task, inputs)) text += std::to_string(number) + ' ';
    return text;
  } catch (const judge::NoAnswer& e) {
    return e.what();
  }
}

std::string reason_for(const std::string& script, double seconds = no_limit) {
  StudentProgram program({"sh", "-c", script}, seconds);
  return answer_or_reason(program, "task");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_program_answers_line_by_line_with_all_digits) {
  StudentProgram program({"sh", "-c", "while read -r task x y; do echo $y $x; done"}, no_limit);

  BOOST_TEST(program.answer("swap", {1.0 / 3, 1e-300 / 7}) == (Numbers{1e-300 / 7, 1.0 / 3}));
  BOOST_TEST(program.answer("swap", {1, -2}) == (Numbers{-2, 1}));
}

BOOST_AUTO_TEST_CASE(the_same_question_is_asked_once) {
  StudentProgram program({"sh", "-c", "i=0; while read -r line; do i=$((i+1)); echo $i; done"},
                         no_limit);

  BOOST_TEST(answer_or_reason(program, "count", {1}) == "1.000000 ");
  BOOST_TEST(answer_or_reason(program, "count", {1}) == "1.000000 ");
  BOOST_TEST(answer_or_reason(program, "count", {2}) == "2.000000 ");
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

BOOST_AUTO_TEST_CASE(a_missing_answer_has_a_reason) {
  BOOST_TEST(holds(reason_for("read -r line; echo PASSED"), "not a decimal number"));
  BOOST_TEST(reason_for("read -r line; exit 0") == "the program ended before it answered");
  BOOST_TEST(reason_for("read -r line; kill -SEGV $$") == "the program crashed (SIGSEGV)");
  BOOST_TEST(reason_for("read -r line; exit 134") == "the program crashed (SIGABRT)");
  BOOST_TEST(reason_for("read -r line; kill -XCPU $$") == "the program used up its processor time");
  BOOST_TEST(reason_for("read -r line; yes 1 | tr -d '\\n'") == "the program's answer is too long");
  BOOST_TEST(reason_for("read -r line; printf '1\\n2\\n'; read -r line") ==
             "the program wrote an answer without a question");
}

BOOST_AUTO_TEST_CASE(an_answer_before_the_question_does_not_count) {
  StudentProgram program({"sh", "-c", "while read -r task; do echo 1; sleep 0.1; echo 2; done"},
                         no_limit);
  program.answer("first", {});
  ::usleep(500'000);  // the second line has arrived

  BOOST_TEST(answer_or_reason(program, "second") ==
             "the program wrote an answer without a question");
  BOOST_TEST(answer_or_reason(program, "third") == "1.000000 ");
}

BOOST_AUTO_TEST_CASE(a_crash_costs_one_question_and_the_program_is_restarted_twice) {
  StudentProgram program(
      {"sh", "-c", "while read -r task x; do [ $x != 7 ] || exit; echo $x; done"}, no_limit);

  BOOST_TEST(answer_or_reason(program, "a", {1}) == "1.000000 ");
  BOOST_TEST(answer_or_reason(program, "a", {7}) == "the program ended before it answered");
  BOOST_TEST(answer_or_reason(program, "a", {2}) == "2.000000 ");
  BOOST_TEST(answer_or_reason(program, "b", {7}) == "the program ended before it answered");
  BOOST_TEST(answer_or_reason(program, "a", {3}) == "3.000000 ");
  BOOST_TEST(answer_or_reason(program, "c", {7}) == "the program ended before it answered");
  BOOST_TEST(answer_or_reason(program, "a", {4}) ==
             "the program failed too often before and was not started again");
}

BOOST_AUTO_TEST_CASE(an_empty_answer_costs_only_its_question) {
  StudentProgram program({"sh", "-c", "while read -r task x; do echo $x; done"}, no_limit);

  for (int i = 0; i < 5; ++i) {
    BOOST_TEST(answer_or_reason(program, "task" + std::to_string(i)) ==
               "the program has no answer");
  }
  BOOST_TEST(answer_or_reason(program, "task", {1}) == "1.000000 ");
}

BOOST_AUTO_TEST_CASE(a_question_that_hangs_leaves_time_for_others_but_not_endlessly) {
  StudentProgram program(
      {"sh", "-c", "while read -r task x; do [ $task != slow ] || sleep 100; echo $x; done"}, 4);

  BOOST_TEST(answer_or_reason(program, "slow", {1}) == "the program did not answer in time");
  BOOST_TEST(answer_or_reason(program, "quick", {2}) == "2.000000 ");
  BOOST_TEST(answer_or_reason(program, "slow", {3}) == "the program did not answer in time");
  BOOST_TEST(answer_or_reason(program, "quick", {4}) == "the program did not answer in time");
}

BOOST_AUTO_TEST_SUITE_END()
