// SPDX-License-Identifier: GPL-3.0-or-later
// `halfspace-report check`, and a program that is older than the sources it is to quote.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "literate/document/document.hpp"
#include "program.hpp"

BOOST_AUTO_TEST_SUITE(prose_test)

namespace fs = std::filesystem;

namespace {

// A document and what a computation registered for it: a value, a table that it must use.
class Workplace {
 public:
  explicit Workplace(const std::string& prose, bool holds = true) {
    folder_.write("report/report.tex", prose);
    literate::Document document;
    document.value("peak", literate::Value(1.5, literate::exact()));
    document.table(literate::Table("peaks", {literate::Column("n", literate::integer())}));
    document.check("balance", holds, "The forces balance.");
    document.write(folder_.path() / "generated");
  }

  void write(const std::string& file, const std::string& text) { folder_.write(file, text); }
  std::string path(const std::string& file) const { return (folder_.path() / file).string(); }

  Words check() const {
    return ReportSettings{steel_case, folder_.path(), folder_.path() / "report"}.stage("check");
  }

 private:
  TemporaryFolder folder_;
};

const std::string all_used = "A peak of \\val{peak}, and\n\\tab{peaks}.\n";

void check_found(int status, const Workplace& workplace, const std::string& errors) {
  const Outcome outcome = run_program(workplace.check());
  BOOST_TEST(outcome.status == status);
  BOOST_TEST(outcome.output == "");
  BOOST_TEST(outcome.errors == errors);
}

// The only line says this of a line of this file.
void check_told(const Workplace& workplace, const std::string& what) {
  const Outcome outcome = run_program(workplace.check());
  BOOST_TEST(outcome.status == 1);
  BOOST_TEST(outcome.errors.starts_with("halfspace: tests/end_to_end/prose_test.cpp:"),
             outcome.errors);
  BOOST_TEST(outcome.errors.ends_with(what), outcome.errors);
  BOOST_TEST(std::ranges::count(outcome.errors, '\n') == 1, outcome.errors);
}

}  // namespace

BOOST_AUTO_TEST_CASE(prose_that_uses_all_and_types_nothing_passes_in_silence) {
  check_found(0, Workplace(all_used), "");
}

BOOST_AUTO_TEST_CASE(an_unknown_name_stops_with_its_place) {
  check_found(2, Workplace(all_used + " \\val{peek}"),
              "halfspace: report/report.tex:3:2: unknown value 'peek', did you mean 'peak'?\n");
}

BOOST_AUTO_TEST_CASE(what_is_registered_and_not_used_fails) {
  check_told(Workplace("\\val{peak}"), ": table 'peaks' is registered and not used\n");
}

BOOST_AUTO_TEST_CASE(a_typed_result_fails_with_its_place) {
  const Outcome outcome = run_program(Workplace(all_used + "It is 1.50 high.").check());

  BOOST_TEST(outcome.status == 1);
  BOOST_TEST(outcome.errors.starts_with("halfspace: report/report.tex:3:7: 1.50 is typed"));
}

BOOST_AUTO_TEST_CASE(what_does_not_hold_fails) {
  check_told(Workplace(all_used, false), ": check balance failed: The forces balance.\n");
}

BOOST_AUTO_TEST_CASE(a_quotation_that_the_text_does_not_have_fails_with_both_places) {
  Workplace workplace(all_used + "They are \\quoted{high}.\n");
  workplace.write("report/quotations.toml", "[high]\npage = 3\nwords = \"higher than the sea\"\n");
  workplace.write("text.txt", "Mountains,\nhigher than the\nhills");

  const Outcome outcome =
      run_program(workplace.check() + Words{"--quoted-text", workplace.path("text.txt")});

  BOOST_TEST(outcome.status == 1);
  BOOST_TEST(outcome.errors ==
             "halfspace: report/quotations.toml:3:9: quotation 'high' differs after 'higher than "
             "the': it goes on 'sea', line 3 of the text 'hills'\n");
  check_found(0, workplace, "");
}

BOOST_AUTO_TEST_SUITE_END()
