// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that are allowed and unlike the paper's: each makes a report without a word of complaint,
// and what it says is true of that case.
#include <boost/test/unit_test.hpp>
#include <regex>
#include <string>

#include "report.hpp"

BOOST_AUTO_TEST_SUITE(odd_cases_test)

namespace {

const std::string papers_text = sys::read_file(papers_case);

std::string without_table(std::string text, const std::string& begin, const std::string& end) {
  const auto first = text.find("\n[" + begin + "]");
  const auto last = end.empty() ? text.size() : text.find("\n[" + end + "]");
  BOOST_TEST_REQUIRE((first < last && last != std::string::npos), begin);
  return text.erase(first, last - first) + "\n";
}

// Other bodies than the paper's, of which the paper prints nothing.
const std::string unprinted = without_table(papers_text, "printed", "");

// Makes the report and looks for sentences that must be there and others that must not.
void check_report(const std::string& case_text, const Words& said, const Words& not_said) {
  const TemporaryFolder folder;
  const Report report{folder.write("odd.toml", case_text), folder.path() / "output"};
  std::filesystem::create_directory(report.output);

  report.make();

  const std::string text = std::regex_replace(report.text(), std::regex("- "), "-");
  for (const std::string& sentence : said) {
    BOOST_TEST(holds(text, std::regex_replace(sentence, std::regex("- "), "-")), sentence);
  }
  for (const std::string& sentence : not_said) BOOST_TEST(!holds(text, sentence), sentence);
  BOOST_TEST(!holds(text, "??"));
  BOOST_TEST(!std::regex_search(text, std::regex("\\b(nan|inf)\\b")));
}

// A body's material, with another Young's modulus and Poisson's ratio.
std::string with_material(const std::string& text, const std::string& body,
                          const std::string& young, const std::string& poisson) {
  const std::string head = "[contact." + body + ".material]\n";
  return with(text, head + "young = {value = 30e6, unit = \"psi\"}\npoisson = 0.30",
              head + "young = {value = " + young + ", unit = \"psi\"}\npoisson = " + poisson);
}

}  // namespace

BOOST_AUTO_TEST_CASE(of_the_papers_own_case_everything_is_said) {
  check_report(
      papers_text,
      {"Their loads differ: the formula was evaluated for",
       "The two cylinders of the paper, of radii",
       "of the smaller radius, which is consistent with treating the bodies as half-spaces",
       "The paper put its datum where", "5 The block acts like a half-space with its datum at",
       "The run, a plane-strain model", "the sum is zero. Between bodies of like materials"},
      {"counts as a cylinder", "of this case differ", "The paper puts its datum"});
}

BOOST_AUTO_TEST_CASE(without_a_block_nothing_is_said_of_one) {
  check_report(
      without_table(papers_text, "block", "printed"),
      {"Two cylinders in contact are solved on grids with",
       "only the results of other programs are stored", "beside the columns that the paper prints"},
      {"The block acts like", "Our model has", "The run, a plane-strain model", "Three findings"});
}

BOOST_AUTO_TEST_CASE(without_a_point_contact_nothing_is_said_of_one) {
  check_report(without_table(papers_text, "point_contact", "block"),
               {"The two cylinders of the paper, of radii"},
               {"pyramid of pressure", "crossed at right angles", "rough sphere",
                "hold for pyramids between"});
}

BOOST_AUTO_TEST_CASE(a_cylinder_on_a_plane_with_a_block_and_a_datum_of_the_users) {
  const std::string datum_at_point =
      with(unprinted, "datum = {value = 10, unit", "datum = {value = 0.05, unit");

  check_report(
      with(datum_at_point, "radius = {value = 3, unit = \"in\"}", "radius = \"plane\""),
      {"A cylinder on a plane is solved on grids with", "A cylinder and a plane, R",
       "The plane counts as a cylinder of infinite radius",
       "The plane counts as a sphere of infinite radius", "of the cylinder’s radius, which",
       "The paper puts its datum where", "At x = 0.05 in, the datum of this case",
       "The block of this case is 2 in wide", "holds no results that the paper prints"},
      {"Two cylinders", "two cylinders of", "crossed at right angles", "The paper put its datum",
       "prints the summary", "Two like cylinders in contact", "not the paper’s own"});
}

BOOST_AUTO_TEST_CASE(a_cylinder_in_a_hollow_that_is_nearly_as_wide) {
  std::string text = without_table(unprinted, "block", "");
  text = with(text, "radius = {value = 1, unit = \"in\"}", "radius = {value = 25, unit = \"mm\"}");
  text = with(text, "radius = {value = 3, unit = \"in\"}", "radius = {value = -26, unit = \"mm\"}");
  text = with(text, "datum = {value = 1, unit", "datum = {value = 5, unit");
  text = with(text, "load = {value = 2500,", "load = {value = 12000,");
  text = with(text, "first = {value = 0,", "first = {value = -0.05,");  // points that end at 0

  check_report(text,
               {"A cylinder in a hollow is solved on grids with", "a hollow that it lies in",
                "The hollow counts as a cylinder of negative radius", "questionable"},
               {"Two cylinders", "is consistent with treating", "Our model has"});
}

BOOST_AUTO_TEST_CASE(two_materials_in_other_units) {
  std::string text = with_material(unprinted, "body2", "10e6", "0.33");
  text = with(text, "units = \"in-lbf\"", "units = \"m-N\"");
  text = with(text, "poisson = 0.30", "poisson = 0.499");  // the half-space and its block
  text = with(text, "order = 7", "order = 9");

  check_report(text, {"the materials differ, and the two slopes do not cancel"},
               {"the sum is zero. Between bodies", " psi", " lbf", " in wide"});
}

BOOST_AUTO_TEST_CASE(two_bodies_that_are_nearly_incompressible) {
  const std::string first = with_material(unprinted, "body1", "30e6", "0.4999999");

  check_report(with_material(without_table(first, "block", ""), "body2", "30e6", "0.49999"),
               {"the materials differ, but hardly in"},
               {"0.00 %: the materials differ", "do not cancel."});
}

BOOST_AUTO_TEST_SUITE_END()
