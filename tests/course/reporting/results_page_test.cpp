// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/results_page.hpp"

#include <boost/test/unit_test.hpp>
#include <pugixml.hpp>

#include "course/reporting/toy_class.hpp"

BOOST_AUTO_TEST_SUITE(results_page_test)

using namespace course;

namespace {

std::string page(const ClassMarks& marks) {
  const Met met{
      .pattern = {.id = "halved", .says = "half of <it>", .exercises = {"square"}, .points = {}},
      .students = {"bob"}};
  return results_html(toy_grading::assignment(), marks,
                      statistics_of(toy_grading::assignment(), marks), {met});
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_page_tells_marks_checks_and_mistakes) {
  const std::string html = page(toy_class::marks());

  BOOST_TEST(
      has(html, "4 marks: mean 10.5, standard deviation 7.3, least 4.4, median 8.75, most 20."));
  BOOST_TEST(has(html, "missing: 1: erin"));
  BOOST_TEST(has(html,
                 "<td>square-values (hidden)</td><td>square</td><td>6</td><td>2</td><td>1</td>"
                 "<td>0.56</td><td>0.70</td>"));
  BOOST_TEST(has(html, "<td>halved: half of &lt;it&gt;</td><td>bob</td><td>1</td>"));
}

BOOST_AUTO_TEST_CASE(the_bars_of_the_histogram_are_as_high_as_the_counts) {
  pugi::xml_document document;
  BOOST_REQUIRE(document.load_string(page(toy_class::marks()).c_str()));

  std::vector<int> heights;
  for (const auto& bar : document.select_nodes("//svg/rect")) {
    heights.push_back(bar.node().attribute("height").as_int());
  }

  const std::vector<int> expected = {0, 0, 160, 0, 0, 0, 80, 0, 0, 80};
  BOOST_TEST(heights == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_class_without_marks_has_a_page_too) {
  ClassMarks marks;
  marks.students.push_back({.student = "erin", .state = "missing"});

  BOOST_TEST(has(page(marks), "missing: 1: erin"));
  BOOST_TEST(!has(page(marks), "<svg"));
}

BOOST_AUTO_TEST_SUITE_END()
