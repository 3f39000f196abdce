// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/sheet.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "assignment/programs.hpp"
#include "holds.hpp"
#include "literate/document/names.hpp"
#include "literate/prose/references.hpp"
#include "message_of.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(sheet_test)

namespace {

const course::Assignment description = programs::assignment();

literate::Document sheet_of(const course::Variant& variant) {
  literate::Document document;
  assignment::register_sheet(document, description, variant);
  return document;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_exercise_has_its_points_and_a_line_for_each_check) {
  const literate::Document sheet = sheet_of(course::nominal_variant(description));

  for (const course::Exercise& exercise : description.exercises) {
    BOOST_TEST(*sheet.values().at("points." + exercise.id).number() == exercise.points());
    const std::string checks = sheet.tables().at("checks-" + exercise.id).csv();
    for (const course::CheckEntry& check : exercise.checks) {
      BOOST_TEST(holds(checks, check.says), check.says);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_sheet_counts_the_exercises) {
  course::Assignment shorter = description;
  shorter.exercises.resize(2);
  literate::Document sheet;

  assignment::register_sheet(sheet, shorter, course::nominal_variant(description));

  BOOST_TEST(sheet.values().at("sheet.exercises").printed() == "two");
}

BOOST_AUTO_TEST_CASE(grace_and_slip_days_are_told_if_there_are_any) {
  BOOST_TEST(!sheet_of(course::nominal_variant(description)).flags().at("late.has-slip-days"));
  course::Assignment generous = description;
  generous.late.grace_minutes = 15;
  generous.late.slip_days = 3;
  literate::Document sheet;

  assignment::register_sheet(sheet, generous, course::nominal_variant(description));

  BOOST_TEST(sheet.flags().at("late.has-grace"));
  BOOST_TEST(sheet.flags().at("late.has-slip-days"));
  BOOST_TEST(sheet.values().at("late.slip-days").printed() == "3");
}

BOOST_AUTO_TEST_CASE(a_rubric_of_the_report_is_told_with_its_points) {
  course::Assignment unmarked = description;
  unmarked.criteria.clear();
  literate::Document without;
  assignment::register_sheet(without, unmarked, course::nominal_variant(description));
  BOOST_TEST(!without.flags().at("report.has-rubric"));
  course::Assignment marked = description;
  marked.criteria = {{.id = "words", .title = "Words", .says = "is it said?", .points = 4},
                     {.id = "figures", .title = "Figures", .says = "axes", .points = 6.5}};
  literate::Document sheet;

  assignment::register_sheet(sheet, marked, course::nominal_variant(description));

  BOOST_TEST(sheet.flags().at("report.has-rubric"));
  BOOST_TEST(*sheet.values().at("report.points").number() == 10.5);
  BOOST_TEST(holds(sheet.tables().at("criteria").csv(), "is it said?"));
}

BOOST_AUTO_TEST_CASE(no_table_names_a_hidden_check) {
  const literate::Document sheet = sheet_of(course::nominal_variant(description));

  for (const auto& [name, table] : sheet.tables()) {
    for (const course::Exercise& exercise : description.exercises) {
      for (const course::CheckEntry& check : exercise.checks) {
        const bool is_hidden = check.visibility == course::Visibility::hidden;
        BOOST_TEST(!(is_hidden && holds(table.csv(), check.id)), check.id);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(it_holds_the_students_own_numbers) {
  course::Variant variant = course::nominal_variant(description);
  BOOST_TEST(!sheet_of(variant).flags().at("sheet.is-personal"));
  variant.student = "ada";
  variant.quantities["radius1"] = 0.0346;

  const literate::Document sheet = sheet_of(variant);

  BOOST_TEST(sheet.flags().at("sheet.is-personal"));
  BOOST_TEST(sheet.values().at("sheet.student").printed() == "ada");
  BOOST_TEST(holds(sheet.tables().at("quantities").latex(), "\\qty{0.0346}{m}"));
}

BOOST_AUTO_TEST_CASE(every_quantity_has_a_symbol) {
  const std::string table =
      sheet_of(course::nominal_variant(description)).tables().at("quantities").latex();

  std::size_t n_symbols = 0;
  for (auto at = table.find("\n  $"); at != std::string::npos; at = table.find("\n  $", at + 1)) {
    ++n_symbols;
  }
  BOOST_TEST(n_symbols == description.quantities.size());
}

BOOST_AUTO_TEST_CASE(a_variant_that_lacks_a_quantity_is_refused) {
  literate::Document document;
  BOOST_TEST(holds(
      message_of<std::out_of_range>([&] { assignment::register_sheet(document, description, {}); }),
      "young1"));
}

BOOST_AUTO_TEST_CASE(sheet_tex_uses_all_that_is_registered_and_nothing_else) {
  const TemporaryFolder folder;
  sheet_of(course::nominal_variant(description)).write(folder.path() / "generated");

  const literate::ReferenceReport report = literate::check_references(
      description.folder, literate::read_names(folder.path() / "generated" / "names.json"));

  BOOST_TEST(report.errors == std::vector<std::string>{}, boost::test_tools::per_element());
  BOOST_TEST(report.unused == std::vector<std::string>{}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
