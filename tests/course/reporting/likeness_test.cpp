// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/likeness.hpp"

#include <boost/test/unit_test.hpp>

#include "course/toy_grading.hpp"
#include "course/walls.hpp"
#include "needed_tool.hpp"

namespace {

void need_walls_and_similarity_tester() {
  need_walls();
  need_tool("sim_c++", "likeness of submissions");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(likeness_test, *boost::unit_test::fixture(&need_walls_and_similarity_tester))

using namespace course;

namespace {

const std::string given =
    "#include \"toy.hpp\"\n\ndouble square(double x) {\n  double sum = 0;\n"
    "  for (int i = 0; i < 100; ++i) sum += x * i;\n  return sum / x + (x < 0 ? -x : x) * x;\n}\n";

const std::string first =
    "double part(double a, int n) {\n  double b = 1;\n  while (n > 0) { b *= a; n = n - 1; }\n"
    "  if (b > 3 && a < 7) b = b / 2 + a * (b - 1);\n  return b;\n}\n";

/// The same with other names, numbers, layout and a comment.
const std::string copied =
    "// mine\ndouble share(double u, int k)\n{\n  double v = 2; while (k > 1) {\n    v *= u;\n"
    "    k = k - 2;\n  }\n  if (v > 4 && u < 8) v = v / 3 + u * (v - 2);\n  return v;\n}\n";

const std::string other =
    "struct P { double x[3]; };\nstatic P make(double q) {\n  P p{};\n  for (auto& e : p.x) e = "
    "q;\n"
    "  switch (int(q)) { case 1: return p; default: break; }\n  p.x[0] += p.x[1] - p.x[2];\n"
    "  return p;\n}\n";

Likeness likeness(const std::vector<std::string>& texts, const std::set<std::string>& known = {},
                  int percent = 50) {
  const TemporaryFolder work;
  const std::vector<std::string> units = {"alice", "bob", "carol", "dave"};
  std::vector<Written> all;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    all.push_back({units[i], {{"src/square.cpp", texts[i]}}});
  }
  return likeness_of(toy_grading::assignment(), all, known, percent, work.path(),
                     Isolation::sandbox);
}

std::vector<LikePair> pairs(const std::vector<std::string>& texts,
                            const std::set<std::string>& known, int percent = 50) {
  return likeness(texts, known, percent).pairs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_copy_with_other_names_is_found_and_another_text_is_not) {
  const auto found = pairs({first, other, copied}, {});

  BOOST_REQUIRE(found.size() == 1U);
  BOOST_TEST(found[0].exercise == "square");
  BOOST_TEST(found[0].percent_of_first > 90);
  BOOST_TEST(found[0].percent_of_second > 90);
  BOOST_TEST((std::set<std::string>{found[0].first, found[0].second} ==
              std::set<std::string>{"alice", "carol"}));
}

BOOST_AUTO_TEST_CASE(what_everybody_was_given_is_no_likeness) {
  const std::vector<std::string> texts = {given + first, given + other};

  BOOST_TEST(pairs(texts, {}, 30).size() == 1U);
  BOOST_TEST(pairs(texts, known_lines({{{"src/square.cpp", given}}}), 30).empty());
}

BOOST_AUTO_TEST_CASE(a_part_that_was_taken_is_that_of_the_shorter_text) {
  const auto found = pairs({first + other, copied}, {});

  BOOST_REQUIRE(found.size() == 1U);
  BOOST_TEST(found[0].first == "bob");
  BOOST_TEST(found[0].percent_of_first > found[0].percent_of_second);
}

BOOST_AUTO_TEST_CASE(who_wrote_nothing_of_their_own_is_like_nobody) {
  BOOST_TEST(pairs({given, given, ""}, known_lines({{{"src/square.cpp", given}}})).empty());
  BOOST_TEST(pairs({first}, {}).empty());
}

BOOST_AUTO_TEST_CASE(a_text_that_is_too_long_hinders_no_other_from_being_compared) {
  std::string huge;
  while (huge.size() < 250 * 1024) huge += "a + b, ";

  const Likeness found = likeness({huge, first, huge + "c", copied});

  BOOST_REQUIRE(found.pairs.size() == 1U);
  BOOST_TEST((std::set<std::string>{found.pairs[0].first, found.pairs[0].second} ==
              std::set<std::string>{"bob", "dave"}));
  BOOST_REQUIRE(found.problems.size() == 2U);
  BOOST_TEST(found.problems[0] ==
             "src/square.cpp of alice is not compared: 250 kB of it are neither given nor "
             "expected, more than 32 kB");
}

BOOST_AUTO_TEST_CASE(a_text_that_keeps_sim_busy_hinders_no_other_from_being_compared) {
  const auto repeated = [](const std::string& part, int n) {
    std::string text;
    for (int i = 0; i < n; ++i) text += part;
    return text;
  };
  const std::string idle = repeated("0;", 8000);

  const Likeness found = likeness({"void f() {" + idle + "return;" + idle + "}\n", first,
                                   other + "void f() {" + idle + "}\n", copied});

  BOOST_REQUIRE(found.pairs.size() == 1U);
  BOOST_TEST((std::set<std::string>{found.pairs[0].first, found.pairs[0].second} ==
              std::set<std::string>{"bob", "dave"}));
  BOOST_TEST_REQUIRE(!found.problems.empty());
  BOOST_TEST(found.problems[0] ==
             "src/square.cpp of alice is not compared: sim_c++ takes longer than 3 s for it");
  const std::string table = "double x[] = {" + repeated("0.5, ", 400) + "1};\n";
  BOOST_TEST(likeness({table + first, table + other}).problems.empty());
}

// sim_c++ would take the copy behind it for a comment.
BOOST_AUTO_TEST_CASE(a_raw_string_which_sim_does_not_know_is_told) {
  const Likeness found = likeness({first, "const char* note = R\"(\n/*\n)\";\n" + copied, copied});

  BOOST_TEST(found.pairs.size() == 1U);
  BOOST_REQUIRE(found.problems.size() == 1U);
  BOOST_TEST(found.problems[0].starts_with("src/square.cpp of bob is to be read by a person"));
}

BOOST_AUTO_TEST_CASE(lines_are_known_whatever_their_blanks) {
  const auto known = known_lines({{{"a.cpp", "int a = 1;\r\n\treturn a;\n"}}});

  BOOST_TEST(own_lines("  int a=1;\nint b;\nreturn  a;\n", known) == "int b;\n");
}

BOOST_AUTO_TEST_CASE(the_table_has_a_line_for_each_pair) {
  BOOST_TEST(pairs_csv({{"square", "alice", "bob", 97, 41}}) ==
             "exercise,first,percent of the first,second,percent of the second\r\n"
             "square,alice,97,bob,41\r\n");
}

BOOST_AUTO_TEST_SUITE_END()
