// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/leaks.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "course/release/secret_numbers.hpp"
#include "course/small_pdf.hpp"
#include "course/toy.hpp"
#include "holds.hpp"
#include "system/error.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(leaks_test)

namespace fs = std::filesystem;

namespace {

course::Secrets secrets() {
  return course::secrets_of(toy::assignment(), toy::project(),
                            {toy::folder / "hidden/hidden_checks.hpp"}, {1.5165750888103102, 0.25});
}

// The leaks that are found in a file with this name and these bytes.
std::vector<std::string> leaks_in(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  folder.write(name, bytes);
  return course::leaks(secrets(), folder.path());
}

void check_leak(const std::string& name, const std::string& bytes, const std::string& expected) {
  const auto found = leaks_in(name, bytes);
  BOOST_REQUIRE_MESSAGE(found.size() == 1, name << ": " << found.size() << " leaks in " << bytes);
  BOOST_TEST(holds(found[0], expected), found[0]);
  BOOST_TEST(found[0].starts_with(name));
}

const std::string solution_line =
    "for (int i = 0; i < 200; ++i) guess = 0.5 * (guess + x / guess);";

}  // namespace

BOOST_AUTO_TEST_CASE(a_solution_line_is_found_however_it_is_set) {
  const std::string place = "template/src/root.cpp:8";

  check_leak("a.txt", "x" + solution_line + "y", place);
  check_leak("b c.tex", "for(int i=0;\r\n\ti<200;++i)guess=0.5*(guess+x/guess);", place);
  check_leak("program",
             std::string("\x7f"
                         "ELF\0\0",
                         6) +
                 solution_line + '\0',
             place);
}

BOOST_AUTO_TEST_CASE(what_stands_in_public_or_is_short_is_no_secret) {
  for (const std::string text : {"return guess;", "#pragma once", "#include <cmath>", "}"}) {
    const auto found = leaks_in("a.txt", text);
    BOOST_TEST(found.size() == (text == "return guess;" ? 1U : 0U), text);
  }
  for (const auto& secret : secrets().lines) BOOST_TEST(secret.text.size() >= 10U);
}

BOOST_AUTO_TEST_CASE(the_teachers_notes_are_found_too) {
  check_leak("README",
             "Note that Heron's rule doubles the digits with each step. The teacher's "
             "notes: Heron's rule doubles the digits with each step.",
             "README.md:5");
  check_leak("x",
             "std::cout << \"the mean of one number is \" << run_task(\"mean\", {7.25}).at(0)"
             " << '\\n';",
             "checks/main.cpp:9");
}

BOOST_AUTO_TEST_CASE(names_of_what_is_hidden_are_found_as_words) {
  check_leak("a.txt", "try root-reference.", "the id of the hidden check root-reference");
  check_leak("a.txt", "(only-teachers-try-this)", "hidden tests \"only-teachers-try-this\"");
  check_leak("a.txt", "#include \"hidden_checks.hpp\"", "the name of ");
  check_leak("root-reference.txt", "", "the id of the hidden check root-reference");
  BOOST_TEST(leaks_in("a.txt", "my-root-reference root-references root-square").empty());
}

BOOST_AUTO_TEST_CASE(a_line_of_the_hidden_checks_is_found) {
  check_leak("a.txt", "return std::abs(answer - reference) <= 1e-9 * reference;",
             "hidden_checks.hpp");
}

BOOST_AUTO_TEST_CASE(an_expected_value_is_found_in_any_unit_and_to_any_digits) {
  for (const char* text : {"1.51657", "1.51658", "1.516575", "151657508.881", "-0.00151657509",
                           "1.51657508881031e-06", "{1.51657}", "1.5165750888103102,"}) {
    check_leak("a.txt", text, "the expected value");
  }
  for (const char* text : {"1.5166", "1.51659", "1.51657609", "a151657508", "0x151657", "0.25",
                           "2.500000", "11.51657", "1.51657b"}) {
    BOOST_TEST(leaks_in("a.txt", text).empty(), text);
  }
}

BOOST_AUTO_TEST_CASE(an_expected_value_is_found_in_an_object_file) {
  const double value = 1.5165750888103102;
  std::string bytes("\0\1\2", 3);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value).append("\3");

  check_leak("a.o", bytes, "an expected value as a double's bytes");
}

BOOST_AUTO_TEST_CASE(numbers_that_anybody_writes_are_no_secrets) {
  BOOST_TEST(course::SecretNumbers({0, 1, 0.25, -12000, 3.125e9, 0.9999999}).empty());
  BOOST_TEST(!course::SecretNumbers({0.12345}).empty());
}

BOOST_AUTO_TEST_CASE(the_answers_to_hidden_checks_are_heard_but_not_the_inputs) {
  course::ExpectedValues expected;
  const course::Checks checks =
      expected.listening({{"c", [](const course::Program& program, const course::Variant&) {
                             program("echo", {2.385, 4.5});
                             return course::Outcome{1, ""};
                           }}});
  const course::Program program = [](const std::string&, const course::Numbers& inputs) {
    return course::Numbers{inputs[0], -7.125, 0.5};
  };

  BOOST_TEST(checks.at("c")(program, {}).share == 1);

  BOOST_TEST((expected.values() == std::vector<double>{0.5, 7.125}));
}

BOOST_AUTO_TEST_CASE(a_pdf_is_read_as_text_with_its_thin_spaces) {
  check_leak("sheet.pdf",
             small_pdf("[(for \\(int i = 0; i < 2) -20 (00; ++i\\) guess = 0.5 *)] TJ "
                       "0 -20 Td ( \\(guess + x / gu) Tj (ess\\);) Tj"),
             "template/src/root.cpp:8");
  check_leak("sheet.pdf", small_pdf("[(1.516) -170 (575)] TJ"), "the expected value 1.516575");
  BOOST_TEST(leaks_in("sheet.pdf", small_pdf("(nothing of interest)Tj")).empty());
}

// 151657 are the first digits of an expected value.
BOOST_AUTO_TEST_CASE(the_place_of_something_in_a_pdf_is_no_leak) {
  const auto place_in = [](const std::string& pdf) {
    return std::stoul(pdf.substr(pdf.rfind("startxref") + 10));
  };
  std::size_t length = 151'000;
  const auto pdf = [&] { return small_pdf("(" + std::string(length, 'x') + ") Tj"); };
  length += 151'657 - place_in(pdf());
  BOOST_TEST_REQUIRE(place_in(pdf()) == 151'657U);

  BOOST_TEST(leaks_in("sheet.pdf", pdf()).empty());
  check_leak("notes.txt", "startxref\n151657\n", "the expected value 151657");
}

BOOST_AUTO_TEST_CASE(what_is_attached_to_a_pdf_is_read_too) {
  check_leak("sheet.pdf", small_pdf("(see attachment) Tj", "try root-reference"),
             "the id of the hidden check root-reference");
}

BOOST_AUTO_TEST_CASE(a_zip_is_unpacked_and_other_archives_are_refused) {
  const TemporaryFolder folder;
  folder.write("src/a b.txt", solution_line);
  sys::run({.program = "zip",
            .arguments = {"-q", "x.zip", "src/a b.txt"},
            .working_directory = folder.path()});

  const auto found = course::leaks(secrets(), folder.path() / "x.zip");

  BOOST_REQUIRE(found.size() == 1);
  BOOST_TEST(found[0].starts_with("x.zip: src/a b.txt holds the line "));
  check_leak("a.tar.gz", "", "what cannot be searched: it is an archive of an unknown kind");
  BOOST_CHECK_THROW(leaks_in("broken.pdf", "%PDF-1.4"), sys::ToolError);
}

BOOST_AUTO_TEST_CASE(a_solution_that_was_published_as_a_whole_is_noticed) {
  const TemporaryFolder folder;
  fs::copy(toy::folder, folder.path() / "toy", fs::copy_options::recursive);
  const auto published = [&] {
    return course::published_solutions(
        course::read_project(course::read_assignment(folder.path() / "toy"), toy::source));
  };
  BOOST_TEST(published().empty());

  folder.write("toy/template/hint.txt",
               "double sum = 0;\nfor (const double number : numbers) sum += number;\n"
               "return sum / static_cast<double>(numbers.size());\n");

  BOOST_REQUIRE(published().size() == 1);
  BOOST_TEST(holds(published()[0], "src/mean.cpp:4: all of this region"));
}

BOOST_AUTO_TEST_CASE(files_that_the_hidden_checks_compare_with_may_not_be_provided) {
  const TemporaryFolder folder;
  const fs::path hidden =
      folder.write("src/assignment/hidden_checks.cpp",
                   "#include <vector>\n#include \"course/assignment/check.hpp\"\n"
                   "#include \"contact/pressure.hpp\"\n");
  folder.write("src/contact/pressure.hpp", "");
  folder.write("src/contact/pressure.cpp",
               "#include \"numerics/fit.hpp\"\n#include \"elasticity/load.hpp\"\n");
  folder.write("src/elasticity/load.hpp", "");
  folder.write("src/numerics/fit.hpp", "#include \"numerics/fit.hpp\"\n");
  course::Assignment assignment = toy::assignment();
  assignment.provided = {"numerics/fit.hpp", "elasticity/other.cpp", "contact/pressure.hpp",
                         "assignment/tasks.hpp", "assignment/hidden_checks.cpp"};

  const auto published = course::published_references(assignment, folder.path(), {hidden});

  BOOST_REQUIRE(published.size() == 3U);
  BOOST_TEST(
      published[0].ends_with("assignment.toml: provided: src/elasticity/other.cpp belongs to "
                             "what the hidden checks compare with"));
  BOOST_TEST(holds(published[1], "src/contact/pressure.hpp"));
  BOOST_TEST(holds(published[2], "src/assignment/hidden_checks.cpp"));
}

BOOST_AUTO_TEST_SUITE_END()
