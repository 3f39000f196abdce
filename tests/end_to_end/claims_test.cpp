// SPDX-License-Identifier: GPL-3.0-or-later
// A case in which a statement fares otherwise than the prose says.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(claims_test)

namespace fs = std::filesystem;

namespace {

// One printed digit altered: the stresses are then no longer those of plane strain.
std::string altered_case() {
  return with(sys::read_file(papers_case), "max_stress_zz = \"-5.914541e+02\"",
              "max_stress_zz = \"-5.915541e+02\"");
}

const std::string fault_line =
    ": claim plane-strain is refuted, not confirmed: that ratio: 0.300051, 5.1e-5 from 0.3 (asked: "
    "within 1e-6 of 0.3)\n";

// It begins with the line that registered the claim.
bool is_fault_line(const std::string& errors) {
  return errors.starts_with("halfspace: src/paper/block_claims.cpp:") &&
         errors.ends_with(fault_line) && std::ranges::count(errors, '\n') == 1;
}

struct AlteredReport {
  std::string case_text = altered_case();
  TemporaryFolder folder = {};
  fs::path case_file = folder.write("altered.toml", case_text);
  ReportSettings settings{case_file, folder.path()};

  Outcome compute() const { return run_program(settings.stage("compute")); }

  Outcome typeset() const {
    const Outcome drawn = run_program(settings.stage("draw"));
    return drawn.status == 0 ? run_program(settings.stage("typeset")) : drawn;
  }

  // The text of the PDF, a page an entry.
  Words pages() const {
    const auto read =
        sys::run({.program = "pdftotext", .arguments = {"-layout", settings.pdf().string(), "-"}});
    BOOST_TEST_REQUIRE(read.exit_status == 0, read.output);
    Words pages;
    std::string text = read.output;
    for (auto end = text.find('\f'); end != std::string::npos; end = text.find('\f')) {
      pages.push_back(text.substr(0, end));
      text.erase(0, end + 1);
    }
    return pages;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(an_altered_print_is_typeset_stamped_on_every_page_and_exits_1_with_one_line) {
  const AlteredReport report;

  const Outcome computed = report.compute();
  const Outcome typeset = report.typeset();

  BOOST_TEST(computed.status == 0);
  BOOST_TEST(computed.errors == "");
  BOOST_TEST(typeset.status == 1);
  BOOST_TEST(is_fault_line(typeset.errors), typeset.errors);
  const Words pages = report.pages();
  BOOST_TEST(pages.size() > 20U);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    BOOST_TEST(
        (pages[i].find("Not to be trusted: a statement is not as expected") != std::string::npos),
        "page " << i + 1 << " has no stamp");
  }
}

BOOST_AUTO_TEST_CASE(a_poissons_ratio_that_no_load_fits_is_typeset_with_the_claims_that_it_turns) {
  const AlteredReport report{
      with(sys::read_file(papers_case), "poisson = 0.30", "poisson = 0.28")};  // of the half-space

  const Outcome computed = report.compute();
  const Outcome typeset = report.typeset();

  BOOST_TEST(computed.status == 0);
  BOOST_TEST(computed.errors == "");
  BOOST_TEST(typeset.status == 1);
  BOOST_TEST((typeset.errors.find("claim shape-undecided is refuted, not confirmed: their number: "
                                  "0 (asked: at least 2)") != std::string::npos),
             typeset.errors);
  BOOST_TEST(report.pages().size() > 20U);
}

BOOST_AUTO_TEST_SUITE_END()
