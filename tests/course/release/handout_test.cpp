// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/handout.hpp"
#include "message_of.hpp"

#include <boost/test/unit_test.hpp>
#include <functional>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/toy.hpp"
#include "holds.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(handout_test)

namespace fs = std::filesystem;
using course::Edition;

namespace {

void write(Edition edition, const fs::path& folder, const fs::path& sheet = {}) {
  const auto assignment = toy::assignment();
  course::write_project(toy::project(), edition, assignment, course::nominal_variant(assignment),
                        sheet, folder);
}

template <class Error>
void check_error(const std::function<void()>& act, const std::string& expected) {
  const std::string what = message_of<Error>(act);
  BOOST_TEST(holds(what, expected), what);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_handout_is_the_template_without_what_students_must_find) {
  const TemporaryFolder folder;
  const fs::path handout = folder.path() / "for students";

  write(Edition::handout, handout);

  const auto root = sys::read_file(handout / "src/root.cpp");
  BOOST_TEST(holds(root, "  // YOUR SOLUTION HERE\n  (void)x;\n  return -1;\n}"));
  BOOST_TEST(!holds(root, "guess"));
  BOOST_TEST(!holds(sys::read_file(handout / "checks/main.cpp"), "HIDDEN"));
  BOOST_TEST(sys::read_file(handout / "provided/course/assignment/check.hpp") ==
             sys::read_file(toy::source / "src/course/assignment/check.hpp"));
  BOOST_TEST(!fs::exists(handout / "sheet.pdf"));
  BOOST_TEST(sys::files_below(folder.path()).size() == sys::files_below(handout).size());
}

BOOST_AUTO_TEST_CASE(the_solution_is_the_template_without_markers) {
  const TemporaryFolder folder;

  write(Edition::solution, folder.path() / "solution");

  const auto root = sys::read_file(folder.path() / "solution/src/root.cpp");
  BOOST_TEST(holds(root, "return guess;"));
  BOOST_TEST(!holds(root, "SOLUTION"));
  BOOST_TEST(!holds(root, "STUB"));
}

BOOST_AUTO_TEST_CASE(scripts_stay_executable_and_only_they_are) {
  const TemporaryFolder folder;
  const auto is_executable = [&](const char* file) {
    const auto permissions = fs::status(folder.path() / "h" / file).permissions();
    return (permissions & fs::perms::owner_exec) != fs::perms::none;
  };

  write(Edition::handout, folder.path() / "h");

  BOOST_TEST(is_executable("checks/again"));
  BOOST_TEST(!is_executable("Makefile"));
}

BOOST_AUTO_TEST_CASE(the_variants_header_holds_its_numbers_as_literals_of_double) {
  const auto assignment = toy::assignment();
  const auto header = course::variant_header(assignment, {"ada", {{"first", 2.3}, {"second", 41}}});

  BOOST_TEST(holds(header, "\"ada\","));
  BOOST_TEST(holds(header, "{\"first\", 2.3},  // m\n"));
  BOOST_TEST(holds(header, "{\"second\", 41.0},  // a pure number\n"));
}

BOOST_AUTO_TEST_CASE(the_sheet_goes_along) {
  const TemporaryFolder folder;
  const auto sheet = folder.write("my sheet.pdf", "%PDF");

  write(Edition::handout, folder.path() / "h", sheet);

  BOOST_TEST(sys::read_file(folder.path() / "h/sheet.pdf") == "%PDF");
}

BOOST_AUTO_TEST_CASE(a_handout_is_replaced_as_a_whole) {
  const TemporaryFolder folder;
  const fs::path handout = folder.path() / "h";
  write(Edition::solution, handout);
  folder.write("h/src/left over.cpp", "");

  write(Edition::handout, handout / "");

  BOOST_TEST(!fs::exists(handout / "src/left over.cpp"));
  BOOST_TEST(!fs::exists(folder.path() / "h.part"));
}

BOOST_AUTO_TEST_CASE(a_failure_leaves_the_old_handout) {
  const TemporaryFolder folder;
  const fs::path handout = folder.path() / "h";
  write(Edition::handout, handout);
  const auto before = sys::files_below(folder.path());

  check_error<sys::OutputError>([&] { write(Edition::handout, handout, "no such sheet.pdf"); },
                                "'no such sheet.pdf'");

  BOOST_CHECK(sys::files_below(folder.path()) == before);
}

BOOST_AUTO_TEST_CASE(a_folder_of_somebody_elses_is_left_alone) {
  const TemporaryFolder folder;
  folder.write("thesis/chapter.tex", "");

  check_error<sys::OutputError>([&] { write(Edition::handout, folder.path() / "thesis"); },
                                "was not written by this command");
  check_error<sys::OutputError>(
      [&] { write(Edition::handout, folder.path() / "thesis/chapter.tex"); }, "chapter.tex'");

  BOOST_TEST(fs::exists(folder.path() / "thesis/chapter.tex"));
}

BOOST_AUTO_TEST_CASE(a_template_that_cannot_be_right_is_refused) {
  const TemporaryFolder folder;
  fs::copy(toy::folder, folder.path() / "toy", fs::copy_options::recursive);
  auto assignment = course::read_assignment(folder.path() / "toy");
  const auto read = [&] { course::read_project(assignment, toy::source); };

  assignment.provided = {"course/no_such.hpp"};
  check_error<sys::SourceError>(read, "assignment.toml: provided: there is no src/course/no");
  assignment.provided = {"course/assignment/check.hpp"};
  folder.write("toy/template/provided/course/assignment/check.hpp", "");
  check_error<sys::SourceError>(read,
                                "template/provided/course/assignment/check.hpp exists as well");
  assignment.provided = {};
  folder.write("toy/template/src/root.cpp", "// BEGIN SOLUTION\n");
  check_error<sys::SourceError>(read, "root.cpp:1: BEGIN SOLUTION has no END");
  folder.write("toy/template/src/root.cpp", "");
  folder.write("toy/template/sheet.pdf", "");
  check_error<sys::SourceError>(read, "are made for each handout");
  folder.write("toy/template/build/root.o", "");
  check_error<sys::SourceError>(read, "somebody has compiled in the template");
}

BOOST_AUTO_TEST_CASE(binary_files_are_copied_as_they_are) {
  const TemporaryFolder folder;
  fs::copy(toy::folder, folder.path() / "toy", fs::copy_options::recursive);
  const std::string bytes("\0// BEGIN SOLUTION\r", 18);
  folder.write("toy/template/logo.png", bytes);

  const auto project =
      course::read_project(course::read_assignment(folder.path() / "toy"), toy::source);

  BOOST_TEST(project.at("logo.png").text.handout == bytes);
}

BOOST_AUTO_TEST_SUITE_END()
