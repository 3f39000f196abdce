// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's programs as Octave runs them, against this project's own computations. The folder
// with the JSON files that they wrote is named by the environment variable
// HALFSPACE_OCTAVE_RESULTS.
#include <fmt/core.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "elasticity/triangular_load.hpp"
#include "literate/document/document.hpp"
#include "literate/imports/import_json.hpp"
#include "paper/contact_m.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(octave_test)

namespace {

namespace fs = std::filesystem;

const std::string source_dir = HALFSPACE_SOURCE_DIR;

literate::Document imported(const std::string& file) {
  const char* folder = std::getenv("HALFSPACE_OCTAVE_RESULTS");
  BOOST_REQUIRE_MESSAGE(folder != nullptr, "HALFSPACE_OCTAVE_RESULTS names no folder");
  literate::Document document;
  literate::import_json(document, fs::path(folder) / file, {.root = folder});
  return document;
}

parameters::Case papers_case() {
  return parameters::read_case(source_dir + "/report/ruggiero2001.toml");
}

// Whether a number lies within the error that Octave's value was given, and a few roundings of
// ours.
void check_within_error(const literate::Document& octave, const std::string& key, double ours) {
  const literate::Value& value = octave.values().at(key);
  const double allowed = value.uncertainty().value().bound + tolerance::rounding * std::abs(ours);
  BOOST_TEST(std::abs(value.number().value() - ours) <= allowed,
             key << ": Octave has " << value.number().value() << ", here it is " << ours);
}

}  // namespace

BOOST_AUTO_TEST_CASE(tri_dist_in_octave_gives_the_closed_form_within_its_rounding) {
  const literate::Document octave = imported("tri_dist.json");
  const elasticity::Material steel(30e6, 0.30);
  const elasticity::TriangularLoad load(1000, 0.010);

  for (int i = 0; i < 11; ++i) {
    const bool steps_off = i == 0 || i == 2;
    const double x = 0.005 * i + (steps_off ? 1e-7 : 0);
    check_within_error(octave, fmt::format("u{}", i + 1), normal_displacement(steel, load, x, 10));
  }
}

BOOST_AUTO_TEST_CASE(tri_dist_in_octave_gives_the_digits_that_the_paper_prints) {
  const literate::Document octave = imported("tri_dist.json");
  const parameters::Case from_file = papers_case();
  const std::optional<paper::PrintedData> of_paper = paper::read_printed(from_file);
  const auto& printed = of_paper.value().tri_dist.displacement;

  BOOST_REQUIRE(printed.size() == 11U);
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const literate::Value& value = octave.values().at(fmt::format("u{}", i + 1));
    BOOST_TEST(printed[i].agrees_with(value.number().value()),
               printed[i].text() << " is printed, Octave has " << value.printed());
  }
}

BOOST_AUTO_TEST_CASE(contact_m_in_octave_gives_the_pressures_of_our_run_as_printed) {
  const literate::Document octave = imported("contact_m.json");
  const parameters::Case from_file = papers_case();

  const paper::ContactM ours = paper::run_contact_m(
      from_file.contact, paper::as_printed(paper::read_printed(from_file).value()));

  for (std::size_t i = 0; i < 8; ++i) {
    check_within_error(octave, fmt::format("p{}", i + 1), ours.pressure[i]);
    // The bound is that of a comparison worth making: eight digits of each pressure.
    BOOST_TEST(octave.values().at(fmt::format("p{}", i + 1)).uncertainty().value().bound <
               1e-8 * ours.pressure[i]);
  }
  check_within_error(octave, "load", ours.line_load);
  check_within_error(octave, "zero-node", static_cast<double>(ours.zero_node));
  check_within_error(octave, "hertz-half-width", ours.hertz_half_width);
  check_within_error(octave, "hertz-peak", ours.hertz_peak_pressure);
}

BOOST_AUTO_TEST_SUITE_END()
