// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/proof.hpp"
#include "message_of.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>

#include "config/table.hpp"
#include "course/assignment/assignment.hpp"
#include "course/release/make_toolkit.hpp"
#include "course/release/variant_check.hpp"
#include "course/release/wrong_solutions.hpp"
#include "course/sandbox/sandbox.hpp"
#include "course/toy.hpp"
#include "course/walls.hpp"
#include "holds.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(proof_test, *boost::unit_test::fixture(&need_walls))

namespace fs = std::filesystem;

namespace {

const fs::path& toolkit() {
  static const TemporaryFolder made;
  static const fs::path folder = [] {
    course::make_toolkit(toy::assignment(), toy::source, made.path() / "toolkit");
    course::make_readable(made.path());
    return made.path() / "toolkit";
  }();
  return folder;
}

/// A copy of the toy, its handout, and the proof of it.
class Toy {
 public:
  Toy() { fs::copy(toy::folder, folder_.path() / "toy", fs::copy_options::recursive); }

  void replace(const std::string& file, const std::string& before, const std::string& after) const {
    std::string text = sys::read_file(folder_.path() / file);
    BOOST_REQUIRE(holds(text, before));
    text.replace(text.find(before), before.size(), after);
    folder_.write(file, text);
  }

  void write_wrong_solutions(const std::string& text) const {
    folder_.write("toy/wrong_solutions.toml", text);
  }

  course::Assignment assignment() const { return course::read_assignment(folder_.path() / "toy"); }
  course::Project project() const { return course::read_project(assignment(), toy::source); }

  // Writes the handout of the variant and packs it.
  fs::path write_handout(const course::Variant& variant) const {
    course::write_project(project(), course::Edition::handout, assignment(), variant, {},
                          folder_.path() / "handout");
    sys::run({.program = "zip",
              .arguments = {"-q", "-r", "handout.zip", "handout"},
              .working_directory = folder_.path()});
    return folder_.path() / "handout";
  }

  fs::path write_handout() const { return write_handout(course::nominal_variant(assignment())); }

  // The claims that do not hold, by their first words, with the reasons.
  std::string prove(const course::Variant& variant, const fs::path& zip = {}) const {
    const course::Assignment assignment = this->assignment();
    const course::Project project = this->project();
    std::string faults;
    const bool all_hold = course::prove({.assignment = assignment,
                                         .project = project,
                                         .visible = toy::public_checks(),
                                         .hidden = toy::hidden_checks(),
                                         .variant = variant,
                                         .handout = folder_.path() / "handout",
                                         .zip = zip,
                                         .toolkit = toolkit(),
                                         .secret_files = {toy::folder / "hidden/hidden_checks.hpp"},
                                         .source = toy::source,
                                         .n_jobs = 2},
                                        [&](const course::ProvedClaim& claim) {
                                          for (const std::string& fault : claim.faults)
                                            faults += claim.says + ": " + fault + "\n";
                                        });
    BOOST_TEST(all_hold == faults.empty());
    BOOST_TEST_MESSAGE(faults);
    return faults;
  }

  std::string prove() const { return prove(course::nominal_variant(assignment())); }

  fs::path zip() const { return folder_.path() / "handout.zip"; }

 private:
  TemporaryFolder folder_;
};

const course::Assignment toy_assignment = toy::assignment();
const course::Project toy_project = toy::project();

/// The toy's variants of some students, all of which are valid.
course::VariantCheckInput variants_of(const std::vector<std::string>& students) {
  return {.assignment = toy_assignment,
          .project = toy_project,
          .visible = toy::public_checks(),
          .hidden = toy::hidden_checks(),
          .toolkit = toolkit(),
          .is_valid = [](const course::Variant&) { return true; },
          .seed = "winter",
          .students = students,
          .n_jobs = 2};
}

void check_only(const std::string& faults, const std::string& expected) {
  BOOST_TEST(holds(faults, expected), "no «" << expected << "» in " << faults);
  BOOST_TEST(std::count(faults.begin(), faults.end(), '\n') == 1, faults);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_students_handout_is_proved_with_its_zip) {
  const Toy toy;
  const course::Variant ada{"ada", {{"first", 4.7}, {"second", 77}}};
  toy.write_handout(ada);

  BOOST_TEST(toy.prove(ada, toy.zip()) == "");
}

BOOST_AUTO_TEST_CASE(what_a_student_would_trip_over_is_a_fault) {
  const Toy toy;
  toy.write_handout();

  toy.replace("handout/src/root.cpp", "(void)x;", "");
  check_only(toy.prove(), "compiles without a warning, and its checks run: make: ");
  toy.replace("handout/src/root.cpp", "return -1;", "(void)x; return -1;");
  toy.replace("handout/checks/main.cpp", "<< id", "<< 0");
  const std::string faults = toy.prove();
  BOOST_TEST(holds(faults, "make check says nothing of root-square"));
  BOOST_TEST(holds(faults, "make check says nothing of mean-zeros"));
}

BOOST_AUTO_TEST_CASE(a_handout_that_does_not_compile_is_a_fault) {
  const Toy toy;
  toy.write_handout();

  toy.replace("handout/checks/main.cpp", "int main", "int man");

  check_only(toy.prove(), "its checks run: make ends with status 2: ");
}

BOOST_AUTO_TEST_CASE(a_stub_that_scores_is_a_fault) {
  const Toy toy;
  toy.replace("toy/template/src/root.cpp", "STUB: return -1;", "STUB: return 1.5165750888103102;");
  toy.write_handout();

  const std::string faults = toy.prove();

  BOOST_TEST(holds(faults, "the untouched handout scores 3"));
  BOOST_TEST(holds(faults, "src/root.cpp holds the expected value 1.5165750888103102"));
}

BOOST_AUTO_TEST_CASE(a_solution_that_loses_points_is_a_fault) {
  const Toy toy;
  toy.replace("toy/template/src/mean.cpp", "sum = 0", "sum = 1");
  toy.write_handout();

  const std::string faults = toy.prove();

  BOOST_TEST(holds(faults, "scores all 10 points: mean-reference: 0 of 3 points: differs"));
  BOOST_TEST(holds(faults,
                   "wrong solution quarter (a quarter stands where a half should) scores 0, "
                   "the list says 4"));
}

BOOST_AUTO_TEST_CASE(a_misspelt_task_of_single_numbers_is_a_fault) {
  const Toy toy;
  toy.replace("toy/assignment.toml", "floor = 0",
              "floor = 0\nsingle_numbers = {root = 1, mena = 1}");
  toy.write_handout();

  check_only(toy.prove(), "single_numbers: no check asks the task 'mena'");
}

BOOST_AUTO_TEST_CASE(a_solution_left_in_a_handout_is_a_fault) {
  const Toy toy;
  const fs::path handout = toy.write_handout();

  fs::copy(toy::folder / "template/src/mean.cpp", handout / "src/mean.cpp.orig");

  const std::string faults = toy.prove(course::nominal_variant(toy.assignment()), toy.zip());
  BOOST_TEST(holds(faults, "src/mean.cpp.orig holds the line "));
  BOOST_TEST(holds(faults, "zip and folder: src/mean.cpp.orig is in one but not in the other"));
  BOOST_TEST(!holds(faults, "compiles"));
}

BOOST_AUTO_TEST_CASE(a_handout_of_another_variant_is_a_fault) {
  const Toy toy;
  toy.write_handout();

  toy.replace("handout/provided/variant_of_this_handout.hpp", "2.3", "2.4");

  check_only(toy.prove(), "variant_of_this_handout.hpp has other numbers");
}

BOOST_AUTO_TEST_CASE(a_wrong_solution_must_change_one_place) {
  const auto error_of = [&](const std::string& before, const std::string& after) {
    const Toy changed;
    changed.replace("toy/wrong_solutions.toml", before, after);
    return message_of<config::Error>([&] {
      course::read_wrong_solutions(changed.assignment(),
                                   course::texts(changed.project(), course::Edition::solution));
    });
  };
  BOOST_TEST(holds(error_of("\"0.5 * (guess\"", "\"guess\""),
                   ":5:10: wrong.before: stands 5 times in the solution's src/root.cpp, not once"));
  BOOST_TEST(holds(error_of("\"0.5 * (guess\"", "\"0.5 * (gues\\n\""), "stands 0 times"));
  BOOST_TEST(holds(error_of("\"0.5 * (guess\"", "\"\""), ":5:10: wrong.before: must not be empty"));
  BOOST_TEST(
      holds(error_of("\"src/root.cpp\"", "\"README.md\""), "README.md is no exercise's file"));
  BOOST_TEST(
      holds(error_of("points = 4", "points = 11"), ":7:10: wrong.points: 11 is not from 0 to 10"));
  BOOST_TEST(holds(error_of("\"one-more\"", "\"quarter\""), "\"quarter\" stands here again"));
  BOOST_TEST(holds(error_of("points = 4", "points = 4\nscore = 5"), "wrong.score: unknown key"));
  const std::string change =
      "points = 4\n[[wrong.change]]\nfile = \"src/mean.cpp\"\nbefore = \"sum += number;\"\n"
      "after = \"sum += 1;\"";
  BOOST_TEST(holds(error_of("points = 4", change), "wrong.after: unknown key"));
}

BOOST_AUTO_TEST_CASE(a_wrong_solution_may_change_several_files) {
  const Toy toy;
  const std::string root =
      "[[wrong.change]]\nfile = \"src/root.cpp\"\nbefore = \"0.5 * (guess\"\nafter = \"guess * "
      "(guess\"\n";
  const std::string mean =
      "[[wrong.change]]\nfile = \"src/mean.cpp\"\nbefore = \"sum += number;\"\nafter = \"\"\n";
  const auto read = [&](const std::string& changes) {
    toy.write_wrong_solutions("[[wrong]]\nid = \"both\"\nsays = \"two\"\npoints = 0\n" + changes);
    return course::read_wrong_solutions(toy.assignment(),
                                        course::texts(toy.project(), course::Edition::solution));
  };

  const auto wrong = read(root + mean).front();
  const course::Files files =
      course::with_mistake(course::texts(toy.project(), course::Edition::solution), wrong);

  BOOST_TEST(holds(files.at("src/root.cpp"), "guess * (guess"));
  BOOST_TEST(!holds(files.at("src/mean.cpp"), "sum += number;"));
  BOOST_TEST(message_of<config::Error>([&] {
               read(root + root);
             }).ends_with("src/root.cpp is changed twice"));
}

BOOST_AUTO_TEST_CASE(the_solution_holds_on_every_variant) {
  BOOST_TEST(course::faults_of_variants(variants_of(course::invented_students(20))).empty());
}

BOOST_AUTO_TEST_CASE(two_students_with_one_variant_and_lost_points_are_told) {
  course::VariantCheckInput input = variants_of(course::invented_students(200));
  input.hidden["mean-reference"] = [](const course::Program&, const course::Variant& variant) {
    return variant("first") < 5 ? course::Outcome{1, ""} : course::Outcome{0.5, "differs"};
  };
  input.is_valid = [](const course::Variant& v) { return v("first") > 4.75 && v("second") < 14; };
  std::string faults;
  for (const std::string& fault : course::faults_of_variants(input)) faults += fault + "\n";

  BOOST_TEST(holds(faults, "has the same variant as student-"));
  BOOST_TEST(holds(faults, ": mean-reference: 1.5 of 3 points: differs"));
}

BOOST_AUTO_TEST_CASE(each_students_handout_is_proved_to_be_theirs) {
  const TemporaryFolder folder;
  course::VariantCheckInput input = variants_of({"ada", "build"});
  input.handouts = folder.path();
  input.secret_files = {toy::folder / "hidden/hidden_checks.hpp"};
  const auto write = [&](const std::string& student, const std::string& numbers_of) {
    const auto variant = course::variant_of(toy_assignment, numbers_of, "winter", input.is_valid);
    course::write_project(toy_project, course::Edition::handout, toy_assignment, variant, {},
                          folder.path() / student);
    sys::run({.program = "zip",
              .arguments = {"-q", "-r", student + ".zip", student},
              .working_directory = folder.path()});
  };
  const auto faults = [&] {
    std::string all;
    for (const std::string& fault : course::faults_of_variants(input)) all += fault + "\n";
    return all;
  };

  write("ada", "ada");
  check_only(faults(), "build: '" + (folder.path() / "build").string() + "' or its zip is missing");
  write("build", "build");
  BOOST_TEST(faults() == "");
  write("build", "ada");
  check_only(faults(), "build: provided/variant_of_this_handout.hpp is not what it must be");
  write("build", "build");
  folder.write("ada/notes.txt", "mean-reference");
  const std::string found = faults();
  BOOST_TEST(holds(found, "ada: notes.txt is not what it must be"));
  BOOST_TEST(holds(found, "ada: notes.txt holds the id of the hidden check mean-reference"));
  BOOST_TEST(holds(found, "ada: zip and folder: notes.txt is in one but not in the other"));
}

BOOST_AUTO_TEST_SUITE_END()
