// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/try_checks.hpp"
#include "message_of.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>

#include "course/toy_grading.hpp"
#include "course/walls.hpp"
#include "holds.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(try_checks_test, *boost::unit_test::fixture(&need_walls))

using namespace course;

namespace {

struct Graded {
  Built built;
  std::vector<CheckResult> results;
};

Built compiled(const Files& files, const TemporaryFolder& scratch,
               Isolation isolation = Isolation::sandbox) {
  return build(toy_grading::assignment(), toy_grading::toolkit(), files, scratch.path(), isolation);
}

std::vector<CheckResult> results_of(const Built& built, const Assignment& assignment,
                                    const Checks& checks,
                                    Isolation isolation = Isolation::sandbox) {
  ProgramRun run(assignment, built, isolation);
  return try_checks(assignment, checks, built, Variant{}, run);
}

Graded grade(const Files& files, const Assignment& assignment = toy_grading::assignment()) {
  const TemporaryFolder scratch;
  Graded graded;
  graded.built =
      build(assignment, toy_grading::toolkit(), files, scratch.path(), Isolation::sandbox);
  graded.results = results_of(graded.built, assignment, toy_grading::checks());
  return graded;
}

Files with(const std::string& file, const std::string& text) {
  Files files = toy_grading::solution();
  files[file] = text;
  return files;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_solution_has_all_points) {
  const Graded graded = grade(toy_grading::solution());

  BOOST_TEST(total(graded.results) == 20);
  BOOST_TEST(graded.built.compile_errors.empty());
}

BOOST_AUTO_TEST_CASE(stubs_have_none) {
  const Graded graded = grade({});

  BOOST_TEST(total(graded.results) == 0);
  BOOST_TEST(graded.built.compile_errors.at("sum") == "src/sum.cpp was not taken");
  BOOST_TEST(graded.results[0].message == "src/square.cpp was not taken or does not compile");
}

BOOST_AUTO_TEST_CASE(what_does_not_compile_costs_its_own_exercise_and_keeps_its_message) {
  const Graded graded = grade(with("src/sum.cpp", "double x = missing;\n"));

  BOOST_TEST(total(graded.results) == 10);
  BOOST_TEST(graded.built.compile_errors.at("sum") ==
             "src/sum.cpp:1:12: error: 'missing' was not declared in this scope\n"
             "    1 | double x = missing;\n"
             "      |            ^~~~~~~\n");
}

BOOST_AUTO_TEST_CASE(a_message_keeps_what_a_student_wrote_of_folders) {
  const Graded graded = grade(with("src/sum.cpp", "#include \"../../tmp/mine.hpp\"\n"));

  BOOST_TEST(graded.built.compile_errors.at("sum").starts_with(
                 "src/sum.cpp:1:10: fatal error: ../../tmp/mine.hpp: No such file or directory\n"
                 "    1 | #include \"../../tmp/mine.hpp\"\n"),
             graded.built.compile_errors.at("sum"));
}

BOOST_AUTO_TEST_CASE(what_does_not_link_costs_its_own_exercise) {
  const Graded graded = grade(with("src/sum.cpp", "int main() {}\n"));

  BOOST_TEST(total(graded.results) == 10);
  BOOST_TEST(holds(graded.built.compile_errors.at("sum"), "multiple definition of `main'"));
}

BOOST_AUTO_TEST_CASE(a_helper_of_the_same_name_in_two_files_costs_the_second_only) {
  const std::string helper = "#include \"toy.hpp\"\ndouble twice(double x) { return 2 * x; }\n";
  Files files = toy_grading::solution();
  for (auto& [file, text] : files) text = helper + text;

  const Graded graded = grade(files);

  BOOST_TEST(total(graded.results) == 10);
  BOOST_TEST(graded.built.link_error == "");
  BOOST_TEST(!graded.built.compile_errors.contains("square"));
  BOOST_TEST(
      holds(graded.built.compile_errors.at("sum"), "multiple definition of `twice(double)'"));
}

BOOST_AUTO_TEST_CASE(what_one_file_does_when_it_starts_or_ends_costs_no_other_exercise) {
  const std::string sum = toy_grading::solution().at("src/sum.cpp");
  for (const char* fault :
       {"#include <cstdlib>\nstruct Last { ~Last() { std::abort(); } } last;\n",
        "#include <cstdlib>\nstruct First { First() { std::abort(); } } first;\n",
        "char large[1'400'000'000];\n"}) {
    const Graded graded = grade(with("src/sum.cpp", fault + sum));

    BOOST_TEST(graded.results[0].points == 4, fault);
    BOOST_TEST(graded.results[1].points == 6, fault);
    BOOST_TEST(graded.results[3].points == 0, fault);
  }
}

BOOST_AUTO_TEST_CASE(a_file_that_uses_what_another_defines_is_linked_with_it) {
  Files files = toy_grading::solution();
  files["src/sum.cpp"] += "double twice(double x) { return 2 * x; }\n";
  files["src/square.cpp"] =
      "#include \"toy.hpp\"\ndouble twice(double);\n"
      "double square(double x) { return x * twice(x) / 2; }\n";

  BOOST_TEST(total(grade(files).results) == 20);
}

BOOST_AUTO_TEST_CASE(a_file_may_call_the_students_own_function_of_any_other_exercise) {
  const Graded graded =
      grade(with("src/square.cpp",
                 "#include \"toy.hpp\"\n"
                 "double square(double x) { return sum({x * x / 2, x * x / 2}); }\n"));

  BOOST_TEST(total(graded.results) == 20);
}

BOOST_AUTO_TEST_CASE(what_a_program_says_when_it_fails_is_in_the_message) {
  const Graded asserts = grade(with("src/square.cpp",
                                    "#include <cassert>\n"
                                    "double square(double x) { assert(x > 9); return x * x; }\n"));
  const Graded throws =
      grade(with("src/square.cpp",
                 "#include <stdexcept>\n"
                 "double square(double) { throw std::runtime_error(\"no end\"); }\n"));

  for (const std::size_t check : {0U, 1U}) {
    BOOST_TEST(asserts.results[check].message ==
               "the program crashed (SIGABRT) and said: program: src/square.cpp:2: double "
               "square(double): Assertion `x > 9' failed.");
    BOOST_TEST(
        throws.results[check].message ==
        "the program crashed (SIGABRT) and said: terminate called after throwing an instance "
        "of 'std::runtime_error'; what():  no end");
  }
}

BOOST_AUTO_TEST_CASE(as_many_threads_as_are_allowed_may_use_memory) {
  Assignment assignment = toy_grading::assignment();
  assignment.limits.processes = 72;
  const std::string sum =
      "#include \"toy.hpp\"\n#include <thread>\n"
      "double sum(const std::vector<double>& numbers) {\n"
      "  std::vector<double> parts(64);\n"
      "  std::vector<std::thread> threads;\n"
      "  for (double& part : parts) {\n"
      "    threads.emplace_back([&] {\n"
      "      for (double number : std::vector<double>(numbers)) part += number / 64;\n"
      "    });\n"
      "  }\n"
      "  double total = 0;\n"
      "  for (std::size_t i = 0; i < parts.size(); ++i) { threads[i].join(); total += parts[i]; }\n"
      "  return total;\n"
      "}\n";

  const Graded few = grade(with("src/sum.cpp", sum));
  const Graded graded = grade(with("src/sum.cpp", sum), assignment);

  BOOST_TEST(
      few.results[2].message ==
      "the program started more than 8 processes and threads, or they needed more than 512 MB");
  BOOST_TEST(graded.results[2].message == "");
  BOOST_TEST(graded.results[2].points == 5);
}

BOOST_AUTO_TEST_CASE(who_includes_a_header_of_their_own_is_told_that_it_is_not_taken) {
  const Graded graded = grade(with("src/square.cpp", "#include \"helper.hpp\"\n"));

  BOOST_TEST(graded.built.compile_errors.at("square").ends_with(
      "Only the exercises' own files are taken from a submission: what stands in another file must "
      "stand in them.\n"));
}

BOOST_AUTO_TEST_CASE(a_macro_before_the_headers_has_its_effect) {
  const Graded graded = grade(with("src/square.cpp",
                                   "#define NDEBUG\n#include <cassert>\n"
                                   "double square(double x) { assert(x > 1e9); return x * x; }\n"));

  BOOST_TEST(total(graded.results) == 20);
}

BOOST_AUTO_TEST_CASE(one_number_that_is_none_leaves_the_others_to_the_check) {
  BOOST_TEST(parse_answer("1 2.5\n").size() == 2U);
  const Numbers numbers = parse_answer("1\nnan\n-inf\n");
  BOOST_REQUIRE(numbers.size() == 3U);
  BOOST_TEST(numbers[0] == 1);
  BOOST_TEST(std::isnan(numbers[1]));
  BOOST_TEST(std::isnan(numbers[2]));
  BOOST_CHECK_THROW(parse_answer("1 Infinity"), ProgramFailure);
  BOOST_CHECK_THROW(parse_answer(" \n"), ProgramFailure);
}

BOOST_AUTO_TEST_CASE(numbers_of_other_kinds_are_compared_each_by_itself) {
  using course::is_same_answer;
  const Numbers contact = {1.9e-5, 3e-4, 0, 5e8, 1e-7};
  BOOST_TEST(is_same_answer(contact, {1.9e-5, 3e-4, 0, 5e8, 3e-7}, 2));
  BOOST_TEST(is_same_answer(contact, {1.9e-5 * (1 + 1e-12), 3e-4, 0, 5e8 * (1 + 1e-12), 0}, 2));
  BOOST_TEST(is_same_answer({1.9e-5, 3e-4, 1e-7, 5e8}, {1.9e-5, 3e-4, 3e-7, 5e8}, 2));
  BOOST_TEST(!is_same_answer(contact, {1.8e-5, 3e-4, 0, 5e8, 1e-7}, 2));
  BOOST_TEST(!is_same_answer(contact, {1.9e-5, 2e-4, 0, 5e8, 1e-7}, 2));
  BOOST_TEST(!is_same_answer(contact, {1.9e-5, 3e-4, 1e-3, 5e8, 1e-7}, 2));
  BOOST_TEST(!is_same_answer(contact, {1.9e-5, 3e-4, 0, 5e8}, 2));
}

BOOST_AUTO_TEST_CASE(answers_that_differ_as_threads_add_up_are_the_same) {
  const Graded graded =
      grade(with("src/sum.cpp",
                 "#include \"toy.hpp\"\n#include <chrono>\n"
                 "double sum(const std::vector<double>& numbers) {\n"
                 "  double total = 0;\n"
                 "  for (const double number : numbers) total += number;\n"
                 "  const auto now = std::chrono::steady_clock::now();\n"
                 "  const bool other = now.time_since_epoch().count() / 1000 % 2;\n"
                 "  return total * (1 + (other ? 1e-15 : 0));\n"
                 "}\n"));

  for (const CheckResult& result : graded.results) {
    BOOST_TEST(!holds(result.message, "different answers"));
  }
}

BOOST_AUTO_TEST_CASE(answers_that_differ_from_run_to_run_are_none) {
  const Graded graded = grade(with("src/square.cpp",
                                   "#include <chrono>\n"
                                   "double square(double x) {\n"
                                   "  const auto now = std::chrono::steady_clock::now();\n"
                                   "  return x * x + 1e-12 * now.time_since_epoch().count();\n"
                                   "}\n"));

  BOOST_TEST(graded.results[0].message ==
             "the program gives different answers to the same question");
  BOOST_TEST(total(graded.results) == 10);
}

BOOST_AUTO_TEST_CASE(a_function_that_remembers_an_earlier_question_answers_wrong) {
  const std::string begin =
      "#include <map>\n#include <numeric>\n#include \"toy.hpp\"\n"
      "double sum(const std::vector<double>& numbers) {\n";
  const Graded stale = grade(
      with("src/sum.cpp", begin + "  static const double total =\n"
                                  "      std::accumulate(numbers.begin(), numbers.end(), 0.0);\n"
                                  "  return total;\n}\n"));
  const Graded keyed = grade(
      with("src/sum.cpp",
           begin + "  static std::map<std::vector<double>, double> known;\n"
                   "  const auto sum = std::accumulate(numbers.begin(), numbers.end(), 0.0);\n"
                   "  return known.emplace(numbers, sum).first->second;\n}\n"));

  BOOST_TEST(stale.results[3].message ==
             "the program gives different answers to the same question, asked alone and after "
             "another one");
  BOOST_TEST(total(stale.results) == 10);
  BOOST_TEST(total(keyed.results) == 20);
}

// Whether it computes or sleeps.
BOOST_AUTO_TEST_CASE(an_exercise_that_takes_too_long_in_all_is_asked_no_more_and_hinders_no_other) {
  Assignment assignment = toy_grading::assignment();
  assignment.limits.run_seconds = 5;
  assignment.limits.submission_seconds = 12;

  for (const char* spend :
       {"const auto end = std::clock() + 2 * CLOCKS_PER_SEC; while (std::clock() < end) {}",
        "usleep(2000000);"}) {
    const Graded graded =
        grade(with("src/square.cpp", std::string("#include <unistd.h>\n#include <ctime>\n"
                                                 "double square(double x) { static int n = 0;\n") +
                                         "if (n++ % 3 == 0) { " + spend + " }\n return x * x; }\n"),
              assignment);

    BOOST_TEST(graded.results[1].message ==
               "all answers of the exercise together took more than 4 s");
    BOOST_TEST(total(graded.results) == 10);
  }
}

BOOST_AUTO_TEST_CASE(a_submission_that_takes_too_long_in_all_is_asked_no_more) {
  const Assignment assignment = toy_grading::assignment();
  const TemporaryFolder folder;
  Built built = compiled(toy_grading::solution(), folder);
  BOOST_TEST(built.seconds > 0);
  built.seconds = 120.5;
  ProgramRun run(assignment, built, Isolation::sandbox);

  const auto results = try_checks(assignment, toy_grading::checks(), built, Variant{}, run);

  BOOST_TEST(results[3].message == "compiling and all answers together took more than 120 s");
  BOOST_TEST(total(results) == 0);
}

BOOST_AUTO_TEST_CASE(no_message_of_the_compiler_tells_when_it_ran) {
  for (const char* macro : {"__TIME__", "__DATE__", "__TIMESTAMP__"}) {
    const Files files =
        with("src/square.cpp", std::string("static_assert(false, ") + macro + ");\n");

    const std::string message = grade(files).built.compile_errors.at("square");

    const bool is_fixed = holds(message, "00:00:00") || holds(message, "Jan  1 1970") ||
                          holds(message, "assertion failed\n") ||
                          holds(message, "assertion failed: \n");
    BOOST_TEST(is_fixed, macro << ": " << message);
  }
}

BOOST_AUTO_TEST_CASE(all_files_together_have_a_limit_to_compile) {
  Assignment assignment = toy_grading::assignment();
  assignment.limits.submission_seconds = 2;
  Files files =
      with("src/square.cpp", sys::read_file(std::filesystem::path(HALFSPACE_SOURCE_DIR) /
                                            "tests/course/hostile/constexpr_bomb/src/square.cpp"));

  const Graded graded = grade(files, assignment);

  BOOST_TEST(graded.built.compile_errors.at("sum") ==
             "all files together take longer than 1 s to compile");
}

BOOST_AUTO_TEST_CASE(hidden_questions_are_asked_when_all_public_answers_are_known) {
  const Assignment assignment = toy_grading::assignment();
  const TemporaryFolder folder;
  const Built built = compiled(toy_grading::solution(), folder);
  ProgramRun run(assignment, built, Isolation::sandbox);
  std::vector<std::string> order;
  Checks checks;
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& entry : exercise.checks) {
      checks[entry.id] = [&order, id = entry.id](const Program&, const Variant&) {
        order.push_back(id);
        return Outcome{1, ""};
      };
    }
  }

  const auto results = try_checks(assignment, checks, built, Variant{}, run,
                                  [&] { order.emplace_back("pictures"); });

  const std::vector<std::string> expected = {"square-growth", "sum-order", "pictures",
                                             "square-values", "sum-values"};
  BOOST_TEST(order == expected, boost::test_tools::per_element());
  BOOST_TEST(results[1].id == "square-values");
}

BOOST_AUTO_TEST_CASE(a_programs_own_status_is_not_told) {
  const Graded graded = grade(
      with("src/square.cpp", "#include <cstdlib>\ndouble square(double) { std::exit(42); }\n"));

  BOOST_TEST(graded.results[0].message == "the program ended with a failure");
}

BOOST_AUTO_TEST_CASE(a_name_that_only_the_precompiled_header_brings_does_no_harm) {
  const Graded graded = grade(with("src/square.cpp",
                                   "#include \"toy.hpp\"\nusing namespace std;\nint vector;\n"
                                   "int distance, advance, max;\n"
                                   "double square(double x) { return x * x + ::max; }\n"));

  BOOST_TEST(total(graded.results) == 20);
}

BOOST_AUTO_TEST_CASE(public_checks_count_only_as_far_as_the_hidden_ones_of_the_exercise_hold) {
  const Files files = with("src/square.cpp",
                           "#include \"toy.hpp\"\n"
                           "double square(double x) { return 2 * x * x; }\n");
  const TemporaryFolder scratch;
  const Assignment assignment = toy_grading::assignment();
  const Built built = compiled(files, scratch);

  const auto none = results_of(built, assignment, toy_grading::checks());
  BOOST_TEST(none[0].points == 0);
  BOOST_TEST(none[0].message ==
             "4 of 4 points, but it counts only as far as the hidden checks of the exercise hold");
  BOOST_TEST(none[1].message == "differs");
  BOOST_TEST(total(none) == 10);

  Checks half = toy_grading::checks();
  half["square-values"] = [](const Program&, const Variant&) { return Outcome{0.5, "by half"}; };
  const auto some = results_of(built, assignment, half);
  BOOST_TEST(some[0].points == 2);
  BOOST_TEST(some[1].points == 3);

  half["square-growth"] = [](const Program&, const Variant&) { return Outcome{0.25, "a part"}; };
  const auto less = results_of(built, assignment, half);
  BOOST_TEST(less[0].points == 1);
  BOOST_TEST(less[0].message == "a part");

  Assignment open = assignment;
  for (CheckEntry& entry : open.exercises[0].checks) entry.visibility = Visibility::visible;
  const auto all = results_of(built, open, toy_grading::checks());
  BOOST_TEST(all[0].points == 4);
}

BOOST_AUTO_TEST_CASE(a_check_without_code_is_the_instructors_mistake) {
  const TemporaryFolder scratch;

  const Built built{
      .program = scratch.path() / "program", .alone = {}, .compile_errors = {}, .link_error = {}};
  BOOST_CHECK_THROW(results_of(built, toy_grading::assignment(), {}), std::logic_error);
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_no_toolkit_is_named) {
  const TemporaryFolder scratch;

  const std::string message = message_of<sys::OutputError>([&] {
    build(toy_grading::assignment(), scratch.path(), {}, scratch.path() / "work",
          Isolation::sandbox);
  });
  BOOST_TEST(message.ends_with("is no toolkit; `halfspace-course toolkit` makes one"), message);
}

BOOST_AUTO_TEST_CASE(a_toolkit_replaces_a_toolkit_and_nothing_else) {
  const TemporaryFolder folder;
  const std::filesystem::path output = folder.path() / "toolkit";

  make_toolkit(toy_grading::assignment(), HALFSPACE_SOURCE_DIR, output);
  BOOST_CHECK_NO_THROW(make_toolkit(toy_grading::assignment(), HALFSPACE_SOURCE_DIR, output));
  folder.write("letters/one.txt", "mine\n");
  BOOST_CHECK_THROW(
      make_toolkit(toy_grading::assignment(), HALFSPACE_SOURCE_DIR, folder.path() / "letters"),
      sys::OutputError);
  Assignment other = toy_grading::assignment();
  other.exercises[0].file = "src/cube.cpp";
  BOOST_CHECK_THROW(open_toolkit(other, output), sys::OutputError);
}

BOOST_AUTO_TEST_CASE(no_solution_is_in_the_toolkit) {
  for (const std::string& file : sys::files_below(toy_grading::toolkit())) {
    const std::string text = sys::read_file(toy_grading::toolkit() / file);
    BOOST_TEST(!holds(text, "total += number"), file);
  }
}

BOOST_AUTO_TEST_CASE(a_task_that_took_too_long_is_not_asked_again) {
  const auto begin = std::chrono::steady_clock::now();

  const Graded graded = grade(with("src/square.cpp", "double square(double) { for (;;) {} }\n"));

  BOOST_TEST(graded.results[1].message == "the program took longer than 1 s");
  BOOST_TEST(graded.results[1].message == graded.results[0].message);
  BOOST_TEST(total(graded.results) == 10);
  BOOST_TEST((std::chrono::steady_clock::now() - begin < std::chrono::seconds(20)));
}

BOOST_AUTO_TEST_CASE(without_walls_no_memory_is_shared_and_no_socket_opened) {
  const std::filesystem::path hostile =
      std::filesystem::path(HALFSPACE_SOURCE_DIR) / "tests/course/hostile";
  for (const char* name : {"holds_shared_memory", "uses_network", "keeps_keys"}) {
    const TemporaryFolder scratch;
    const std::string text = sys::read_file(hostile / name / "src/square.cpp");

    const Built built = compiled(with("src/square.cpp", text), scratch, Isolation::none);

    BOOST_TEST(built.compile_errors.empty(), name);
    BOOST_TEST(total(results_of(built, toy_grading::assignment(), toy_grading::checks(),
                                Isolation::none)) == 10,
               name);
  }
}

BOOST_AUTO_TEST_CASE(without_walls_the_solution_has_all_points_too) {
  const TemporaryFolder scratch;

  const Built built = compiled(toy_grading::solution(), scratch, Isolation::none);

  BOOST_TEST(total(results_of(built, toy_grading::assignment(), toy_grading::checks(),
                              Isolation::none)) == 20);
}

BOOST_AUTO_TEST_SUITE_END()
