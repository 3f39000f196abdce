// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/mistake_patterns.hpp"

#include <boost/test/unit_test.hpp>

#include "course/toy.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(mistake_patterns_test)

using namespace course;

namespace {

MistakePattern pattern() {
  return {.id = "root-of-nothing",
          .says = "the root of 0",
          .exercises = {"root"},
          .points = {{"root-square", 0.5}, {"root-reference", 0}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(patterns_are_read_as_they_were_written) {
  const TemporaryFolder folder;
  const auto file = folder.write("patterns.json", patterns_json({pattern()}));

  const auto read = read_patterns(toy::assignment(), file);

  BOOST_REQUIRE(read.size() == 1U);
  BOOST_TEST(read[0].id == "root-of-nothing");
  BOOST_TEST(read[0].says == "the root of 0");
  BOOST_TEST(read[0].exercises.front() == "root");
  BOOST_TEST(read[0].points.at("root-square") == 0.5);
}

BOOST_AUTO_TEST_CASE(patterns_of_another_assignment_are_refused) {
  const TemporaryFolder folder;
  MistakePattern other = pattern();
  other.exercises = {"integral"};
  const auto text = folder.write("none.json", "no JSON");
  const auto file = folder.write("patterns.json", patterns_json({other}));
  const auto message = [&](const std::filesystem::path& path) {
    return message_of<sys::OutputError>([&] { read_patterns(toy::assignment(), path); });
  };

  BOOST_TEST(message(text) ==
             "'" + text.string() + "' does not hold the patterns of wrong solutions");
  BOOST_TEST(message(file).find("wrong solution root-of-nothing is of another state") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_exercises_of_a_wrong_solution_are_those_whose_files_it_changes) {
  const WrongSolution wrong{.id = "both",
                            .says = "both",
                            .changes = {{"src/mean.cpp", "a", "b"}, {"src/root.cpp", "a", "b"}}};

  BOOST_TEST(
      (changed_exercises(toy::assignment(), wrong) == std::vector<std::string>{"root", "mean"}));
}

BOOST_AUTO_TEST_SUITE_END()
