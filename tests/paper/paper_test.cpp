// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <regex>
#include <set>

#include "parameters/papers_case.hpp"

BOOST_AUTO_TEST_SUITE(paper_test)

using literate::Document;
using literate::Verdict;

namespace {

const std::string source_dir = HALFSPACE_SOURCE_DIR;

std::string steel_text() {
  return sys::read_file(source_dir + "/tests/end_to_end/steel_mm.toml");
}

struct Computed {
  Document document;
  std::string log;
};
Computed computed(const std::string& text) {
  Computed result;
  result.log = paper::compute(result.document, case_of(text));
  return result;
}

const Computed& papers() {
  static const Computed result = computed(papers_text());
  return result;
}

double number(const Document& document, const std::string& key) {
  return document.values().at(key).number();
}

// The files of the document except the assignment, and the figures' scripts.
std::map<std::string, std::string> prose() {
  std::map<std::string, std::string> texts;
  for (const auto& file : std::filesystem::directory_iterator(source_dir + "/report/sections")) {
    texts[file.path().filename()] = sys::read_file(file.path());
  }
  texts["report.tex"] = sys::read_file(source_dir + "/report/report.tex");
  return texts;
}

// Every name that the prose passes to one of its commands.
std::set<std::string> names(const std::string& command) {
  const std::regex use("\\\\" + command + R"((?:\[[^\]]*\])?\{([A-Za-z0-9.\-_]+)\})");
  std::set<std::string> found;
  for (const auto& [file, text] : prose()) {
    for (auto i = std::sregex_iterator(text.begin(), text.end(), use); i != std::sregex_iterator();
         ++i) {
      found.insert((*i)[1]);
    }
  }
  return found;
}

template <class Registered>
std::set<std::string> keys(const Registered& registered) {
  std::set<std::string> found;
  for (const auto& [key, what] : registered) found.insert(key);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_claim_of_the_papers_case_has_the_verdict_that_the_prose_gives) {
  BOOST_TEST(papers().log == "");
  BOOST_TEST(papers().document.faults() == std::vector<std::string>{},
             boost::test_tools::per_element());
  std::map<std::string, Verdict> verdicts;
  for (const auto& [id, claim] : papers().document.claims()) verdicts[id] = claim.verdict();
  for (const char* id : {"error-of-z", "same-load", "insensitive-to-c", "robust-model",
                         "tangential-negligible", "contact-m-load"}) {
    BOOST_CHECK(verdicts.at(id) == Verdict::fails);
  }
}

BOOST_AUTO_TEST_CASE(the_prose_uses_what_is_registered_and_nothing_else) {
  const Document& document = papers().document;
  std::set<std::string> values = names("val");
  values.merge(names("rawval"));
  BOOST_TEST(values == keys(document.values()), boost::test_tools::per_element());
  BOOST_TEST(names("tab") == keys(document.tables()), boost::test_tools::per_element());
  BOOST_TEST(names("fig") == keys(document.figures()), boost::test_tools::per_element());
  BOOST_TEST(names("ifflag") == keys(document.flags()), boost::test_tools::per_element());
  BOOST_TEST(names("claim") == keys(document.claims()), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_figure_has_a_script_and_no_script_is_left_over) {
  std::set<std::string> scripts;
  for (const auto& file : std::filesystem::directory_iterator(source_dir + "/figures")) {
    if (file.path().stem() != "style") scripts.insert(file.path().stem());
  }
  BOOST_TEST(scripts == keys(papers().document.figures()), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_script_reads_everything_registered_for_its_figure) {
  for (const auto& [name, figure] : papers().document.figures()) {
    const std::string script = sys::read_file(source_dir + "/figures/" + name + ".gp");
    const auto check_read = [&](const std::string& registered) {
      // as it is, or numbered: 'panel_%d' for panel_3
      const std::string word = std::regex_replace(registered, std::regex("_[0-9]+$"), "_%d");
      BOOST_TEST(
          std::regex_search(script, std::regex(word.front() == '"' ? word : "\\b" + word + "\\b")),
          name << ".gp does not read " << registered);
    };
    for (const auto& [block, data] : figure.data) {
      check_read(block);
      for (const auto& column : data.columns) check_read("\"" + column.first + "\"");
    }
    for (const auto& [key, value] : figure.numbers) check_read(key);
    for (const auto& [key, value] : figure.texts) check_read(key);
  }
}

BOOST_AUTO_TEST_CASE(results_agree_with_independent_computations) {
  // Recomputed independently with p-FEM, a Fourier series and boundary elements.
  const Document& d = papers().document;
  const std::map<std::string, double> expected = {
      {"shares.datum", 5.5302e-7},           {"shares.datum.roller", 5.52716e-7},
      {"shares.datum.free", 5.3846e-7},      {"shares.datum.roller-on-rollers", 5.47e-7},
      {"block.larger.level", 1.3385e-7},     {"fit.round-share", 0.666},
      {"loads.wide-triangle.share", 7.75},   {"loads.best-triangle.share", 3.42},
      {"contact-m.symmetric-load", 600.822}, {"cylinders.hertz.half-width", 0.0120346},
      {"spheres.radius", 0.015055}};
  for (const auto& [key, value] : expected) {
    BOOST_TEST_CONTEXT(key) {
      BOOST_TEST(number(d, key) == value, boost::test_tools::tolerance(2e-3));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_finer_mesh_of_the_block_changes_no_printed_digit) {
  const Document finer = computed(with(papers_text(), "order = 7", "order = 8")).document;
  // Except the values that describe the mesh or include its error.
  const std::set<std::string> of_the_mesh = {"block.order", "block.unknowns",
                                             "block.displacement-error", "block.larger.shape",
                                             "fit.by-level"};
  for (const auto& [key, value] : papers().document.values()) {
    if (of_the_mesh.contains(key)) continue;
    BOOST_TEST(finer.values().at(key).printed() == value.printed(), key);
  }
}

BOOST_AUTO_TEST_CASE(values_are_those_of_the_case_in_its_units) {
  // Johnson (4.43), (4.45) with 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, and K = 2(1−ν²)p₀a/(πE).
  const Document d = computed(steel_text()).document;
  const double pi = std::numbers::pi;
  const double modulus = 1 / ((1 - 0.28 * 0.28) / 206e3 + (1 - 0.345 * 0.345) / 71.5e3);
  const double half_width = std::sqrt(4 * 780 * 25 / (pi * modulus));
  const auto close = boost::test_tools::tolerance(1e-13);

  BOOST_TEST(d.values().at("young").printed() == "206000 MPa");
  BOOST_TEST(d.values().at("cylinders.load").printed() == "780 N/mm");
  BOOST_TEST(d.values().at("cylinders.radius2").printed() == "∞");
  BOOST_TEST(number(d, "cylinders.hertz.half-width") == half_width, close);
  BOOST_TEST(number(d, "cylinders.hertz.peak") == 2 * 780 / (pi * half_width), close);
  BOOST_TEST(number(d, "displacement-scale") == 2 * (1 - 0.28 * 0.28) * 63.5 * 0.42 / (pi * 206e3),
             close);
}

BOOST_AUTO_TEST_CASE(other_cases_hold_and_omit_the_print) {
  const std::string paper = papers_text(), steel = steel_text();
  const std::pair<const char*, std::string> cases[] = {
      {"other radii and load",
       with(with(with(paper, "radius = {value = 1,", "radius = {value = 2,"),
                 "radius = {value = 3,", "radius = {value = 5,"),
            "load = {value = 2500,", "load = {value = 1200,")},
      {"no block", without(paper, "[block]", "# The paper's printed numbers")},
      {"no spheres", without(paper, "[point_contact]", "# The finite body")},
      {"a plane and other units", steel},
      {"a hollow", with(steel, "radius = \"plane\"", "radius = {value = -61, unit = \"mm\"}")},
      {"a wide load", with(steel, "0.42", "42")},
      {"two points on both sides", with(with(steel, "0.07", "-0.1"), "count = 9", "count = 2")},
      {"an even number of nodes", with(steel, "nodes = 91", "nodes = 38")}};
  for (const auto& [what, text] : cases) {
    BOOST_TEST_CONTEXT(what) {
      const Computed c = computed(text);
      BOOST_TEST(c.document.faults() == std::vector<std::string>{},
                 boost::test_tools::per_element());
      BOOST_TEST(!c.document.flags().at("printed"));
      BOOST_TEST((c.log == "") == (text.find("\n[printed]") == std::string::npos), c.log);
      BOOST_TEST(c.document.claims().size() == 4U);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
