// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/submission.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/assignment/student.hpp"
#include "course/marking/archive.hpp"
#include "course/toy_grading.hpp"
#include "course/walls.hpp"
#include "system/error.hpp"
#include "system/process.hpp"

BOOST_AUTO_TEST_SUITE(submission_test, *boost::unit_test::fixture(&need_walls))

using namespace course;
namespace fs = std::filesystem;

namespace {

Submission take(const fs::path& path) {
  const TemporaryFolder work;
  return take_submission(toy_grading::assignment(), path, work.path(), Isolation::sandbox);
}

fs::path packed(const TemporaryFolder& folder, const std::string& name, const fs::path& what) {
  const fs::path archive = folder.path() / name;
  const auto result = sys::run({.program = "bsdtar",
                                .arguments = {"-caf", archive.string(), what.string()},
                                .working_directory = folder.path()});
  BOOST_REQUIRE_MESSAGE(result.exit_status == 0, result.output);
  return archive;
}

/// Writes both of the exercises' files into a folder.
void write_both(const TemporaryFolder& folder, const std::string& name) {
  folder.write(name + "/src/square.cpp", "int a;\n");
  folder.write(name + "/src/sum.cpp", "int b;\n");
}

/// Checks that both of them are taken, without a problem.
void check_both(const Submission& submission, const std::string& name) {
  BOOST_TEST(submission.files.size() == 2U, name);
  for (const auto& problem : submission.problems) BOOST_TEST(problem == "", name);
}

// A zip with a file src/square.cpp and a file src/sum.cpp, whose names are any bytes: a program of
// Windows writes those of its own code page, and bsdtar would convert them.
fs::path zip_of(const TemporaryFolder& folder, const std::string& before,
                const std::vector<std::string>& files = {"src/square.cpp", "src/sum.cpp"}) {
  const auto number = [](std::uint64_t value, int n_bytes) {
    std::string bytes;
    for (int i = 0; i < n_bytes; ++i, value >>= 8) bytes += static_cast<char>(value);
    return bytes;
  };
  std::string entries, directory;
  for (const std::string& file : files) {
    const std::string name = before + file;
    const std::string text = "int a;\n";
    const std::uint32_t crc = 0x88aef662;
    const auto size = static_cast<std::uint32_t>(text.size());
    const std::string common = number(20, 2) + number(0, 4) + number(0, 2) + number(0x21, 2) +
                               number(crc, 4) + number(size, 4) + number(size, 4) +
                               number(static_cast<std::uint32_t>(name.size()), 2);
    directory += "PK\x01\x02" + number(20, 2) + common + number(0, 12) +
                 number(static_cast<std::uint32_t>(entries.size()), 4) + name;
    entries += "PK\x03\x04" + common + number(0, 2) + name + text;
  }
  return folder.write(
      "a.zip", entries + directory + "PK\x05\x06" + number(0, 4) + number(2, 2) + number(2, 2) +
                   number(static_cast<std::uint32_t>(directory.size()), 4) +
                   number(static_cast<std::uint32_t>(entries.size()), 4) + number(0, 2));
}

std::string problem_of(const fs::path& path) {
  try {
    const Submission submission = take(path);
    return submission.problems.empty() ? "" : submission.problems.front();
  } catch (const sys::OutputError& error) {
    const std::string what = error.what();
    return "waits: " + what.substr(what.find(": ") + 2);
  }
}

/// A small archive that takes long to go through, with this many files src/0.cpp and so on.
fs::path slow_archive(const TemporaryFolder& folder, int n_files) {
  for (int i = 0; i < n_files; ++i) folder.write(fmt::format("src/{}.cpp", i), "int a;\n");
  folder.write("zero", "");
  fs::resize_file(folder.path() / "zero", 100'000'000);
  const auto result = sys::run({.program = "sh",
                                .arguments = {"-c", "tar -cf - src zero | bzip2 -1 > a.tar.bz2"},
                                .working_directory = folder.path()});
  BOOST_REQUIRE_MESSAGE(result.exit_status == 0, result.output);
  return folder.path() / "a.tar.bz2";
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_exercises_files_and_nothing_else_are_taken) {
  const TemporaryFolder folder;
  write_both(folder, "alice");
  folder.write("alice/src/toy.hpp", "#error\n");
  folder.write("alice/Makefile", "all:\n");

  const Submission submission = take(folder.path() / "alice");

  check_both(submission, "alice");
  BOOST_TEST(submission.files.at("src/sum.cpp") == "int b;\n");
  BOOST_TEST(!submission.has_report);
}

BOOST_AUTO_TEST_CASE(the_report_is_taken_as_it_is_and_nothing_beside_it) {
  const TemporaryFolder folder;
  const std::string pdf("%PDF\0\n", 6);
  folder.write("hers/src/square.cpp", "int a;\n");
  folder.write("hers/report/report.tex", "x\n");
  folder.write("hers/report/report.pdf", pdf);
  folder.write("hers/report/notes.txt", "alice\n");
  folder.write("bob/src/square.cpp", "int a;\n");
  fs::create_directories(folder.path() / "bob/report");
  fs::create_symlink("/etc/passwd", folder.path() / "bob/report/report.tex");
  const auto report = [&](const fs::path& path) {
    const TemporaryFolder work;
    return take_report(toy_grading::assignment(), path, work.path(), Isolation::sandbox);
  };

  for (const fs::path& path : {folder.path() / "hers", packed(folder, "a.zip", "hers"),
                               packed(folder, "a.tar.xz", "hers")}) {
    const Files files = report(path).files;
    BOOST_TEST(files.size() == 2U);
    BOOST_TEST(files.at("report/report.tex") == "x\n");
    BOOST_TEST(files.at("report/report.pdf") == pdf);
  }
  BOOST_TEST(report(folder.path() / "bob").files.empty());
  BOOST_TEST(report(folder.path() / "bob").fault == "is a symbolic link, or lies behind one");
  BOOST_TEST(!report(folder.write("none.zip", "no archive")).is_there());
}

BOOST_AUTO_TEST_CASE(every_kind_of_archive_gives_the_same_files) {
  for (const char* name :
       {"a.zip", "a.tar", "a.tar.gz", "a.tgz", "a.tar.xz", "a.tar.bz2", "a.7z"}) {
    const TemporaryFolder folder;
    write_both(folder, "Alice's work, ü [1]");
    folder.write("Alice's work, ü [1]/report/report.tex", "x\n");

    const Submission submission = take(packed(folder, name, "Alice's work, ü [1]"));

    check_both(submission, name);
    BOOST_TEST(submission.has_report, name);
  }
}

BOOST_AUTO_TEST_CASE(a_folder_in_a_zip_may_have_any_name) {
  for (const char* name : {"", "M\xfcller/", "M\x81ller/", "Müller/", "a\\b/", "a\nb/", "a?[b]*/",
                           "a\\101/", "\x01/", "M\xfc\xfcll er's \"x\"/"}) {
    const TemporaryFolder folder;
    check_both(take(zip_of(folder, name)), name);
  }
}

BOOST_AUTO_TEST_CASE(a_zip_of_windows_may_have_backslashes_between_folders) {
  for (const char* name : {"", "M\xfcller\\", "alice\\"}) {
    const TemporaryFolder folder;
    check_both(take(zip_of(folder, name, {"src\\square.cpp", "src\\sum.cpp"})), name);
  }
}

BOOST_AUTO_TEST_CASE(a_folder_in_a_tar_may_have_any_name) {
  for (const char* name : {"M\xfcller", "M\x81ller", "a\\b", "a\nb", "*", "\x01"}) {
    const TemporaryFolder folder;
    write_both(folder, name);
    const TemporaryFolder packages;
    const fs::path tar = packages.path() / "a.tar.gz";
    const auto packed = sys::run({.program = "tar",
                                  .arguments = {"-czf", tar.string(), "--format=gnu", "."},
                                  .working_directory = folder.path()});
    BOOST_REQUIRE_MESSAGE(packed.exit_status == 0, packed.output);

    check_both(take(tar), name);
  }
}

BOOST_AUTO_TEST_CASE(an_ending_in_capitals_is_that_of_an_archive) {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "alice.ZIP";
  fs::rename(zip_of(folder, ""), zip);

  BOOST_TEST(take(zip).files.size() == 2U);
  BOOST_TEST(student_of(zip) == "alice");
  BOOST_TEST(student_of("bob.Tar.GZ") == "bob");
}

BOOST_AUTO_TEST_CASE(files_that_are_elsewhere_are_told) {
  const TemporaryFolder folder;
  folder.write("deep/one/two/src/square.cpp", "int a;\n");
  folder.write("packed/notes.txt", "see the zip\n");
  fs::copy(zip_of(folder, ""), folder.path() / "packed/mine.zip");

  BOOST_TEST(problem_of(folder.path() / "deep") ==
             "waits: there is src/square.cpp in 'one/two/', but files are looked for at the top "
             "and one folder below it");
  BOOST_TEST(problem_of(folder.path() / "packed") ==
             "waits: there is an archive in the submission, 'mine.zip'; nothing is taken from "
             "that");

  BOOST_TEST(problem_of(packed(folder, "deep.zip", "deep")) ==
             "waits: there is src/square.cpp in 'deep/one/two/', but files are looked for at the "
             "top and one folder below it");
  BOOST_TEST(problem_of(packed(folder, "packed.tgz", "packed")) ==
             "waits: there is an archive in the submission, 'packed/mine.zip'; nothing is taken "
             "from that");
}

BOOST_AUTO_TEST_CASE(a_submission_of_which_nothing_can_be_taken_waits) {
  const TemporaryFolder folder;
  folder.write("other/notes.txt", "see the web\n");
  BOOST_TEST(problem_of(folder.path() / "other") ==
             "waits: none of the files that are looked for is in it");
  folder.write("bad/src/square.cpp", "");
  BOOST_TEST(problem_of(folder.path() / "bad") == "waits: src/square.cpp is empty");
  folder.write("bad/src/sum.cpp", "int b;\n");
  BOOST_TEST(take(folder.path() / "bad").problems.front() == "src/square.cpp is empty");
  folder.write("reported/report/report.tex", "A report alone.\n");
  BOOST_TEST(take(folder.path() / "reported").has_report);
}

BOOST_AUTO_TEST_CASE(a_locked_archive_waits_with_a_report_in_it_too) {
  const TemporaryFolder folder;
  folder.write("alice/src/square.cpp", "int a;\n");
  folder.write("alice/report/report.tex", "A report.\n");
  const fs::path archive = folder.path() / "a.zip";
  const auto locked =
      sys::run({.program = "bsdtar",
                .arguments = {"-cf", archive.string(), "--format=zip", "--options=zip:encryption",
                              "--passphrase=x", "alice"},
                .working_directory = folder.path()});
  BOOST_REQUIRE_MESSAGE(locked.exit_status == 0, locked.output);

  BOOST_TEST(problem_of(archive) ==
             "waits: src/square.cpp cannot be unpacked: the archive is damaged or locked");
}

BOOST_AUTO_TEST_CASE(a_tar_to_which_a_file_was_appended_again_waits) {
  const TemporaryFolder folder;
  folder.write("src/square.cpp", "int a;\n");
  for (const char* how : {"-cf", "-rf"}) {
    sys::run(
        {.program = "tar", .arguments = {how, "a.tar", "src"}, .working_directory = folder.path()});
  }

  BOOST_TEST(problem_of(folder.path() / "a.tar") ==
             "waits: the archive holds src/square.cpp more than once");
}

BOOST_AUTO_TEST_CASE(a_file_of_a_zip_that_is_damaged_is_not_taken) {
  const TemporaryFolder folder;
  std::string bytes = sys::read_file(zip_of(folder, ""));
  bytes[bytes.find("int a")] = 'x';

  BOOST_TEST(problem_of(folder.write("b.zip", bytes)) ==
             "src/square.cpp cannot be unpacked: the archive is damaged or locked");
}

BOOST_AUTO_TEST_CASE(folders_that_are_deep_in_one_another_wait) {
  const TemporaryFolder folder;
  std::string deep = "alice/";
  for (int i = 0; i < 40; ++i) deep += "d/";
  folder.write(deep + "src/square.cpp", "int a;\n");
  folder.write("alice/src/square.cpp", "int a;\n");
  BOOST_TEST(problem_of(folder.path() / "alice") ==
             "waits: the submission has more than 16 folders in one another");
}

BOOST_AUTO_TEST_CASE(a_folder_of_one_folder_is_that_folder) {
  const TemporaryFolder folder;
  folder.write("alice/project/src/square.cpp", "int a;\n");

  const Submission submission = take(folder.path() / "alice");

  BOOST_TEST(submission.files.contains("src/square.cpp"));
  BOOST_TEST(submission.problems == std::vector<std::string>{"src/sum.cpp is missing"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_history_of_a_repository_does_not_count) {
  const TemporaryFolder folder;
  write_both(folder, "alice");
  folder.write("alice/.git/objects/pack", std::string(1'200'000, 'x'));

  check_both(take(folder.path() / "alice"), "alice");
}

BOOST_AUTO_TEST_CASE(the_history_in_an_archive_does_not_count) {
  const TemporaryFolder folder;
  std::string noise(1'200'000, '\0');
  std::mt19937 generator;
  for (char& byte : noise) byte = static_cast<char>(generator());
  write_both(folder, "alice");
  folder.write("alice/.git/objects/pack", noise);

  for (const char* name : {"a.zip", "a.tar.gz", "a.tar.xz", "a.7z"}) {
    check_both(take(packed(folder, name, "alice")), name);
  }
}

BOOST_AUTO_TEST_CASE(files_without_their_folder_or_in_two_places_are_named) {
  const TemporaryFolder folder;
  folder.write("flat/square.cpp", "int a;\n");
  folder.write("flat/sum.cpp", "int b;\n");
  folder.write("top/src/square.cpp", "int a;\n");
  folder.write("top/work/src/sum.cpp", "int b;\n");
  folder.write("two/a/src/square.cpp", "int a;\n");
  folder.write("two/b/src/sum.cpp", "int b;\n");

  const auto problems_of = [&](const char* name) { return take(folder.path() / name).problems; };

  BOOST_TEST(problem_of(folder.path() / "flat") ==
             "waits: there is 'sum.cpp', but src/sum.cpp is looked for");
  BOOST_REQUIRE(problems_of("top").size() == 2U);
  BOOST_TEST(problems_of("top")[1] == "there is 'work/src/sum.cpp', but src/sum.cpp is looked for");
  BOOST_TEST(
      problem_of(folder.path() / "two") ==
      "waits: the submission holds files in two places, 'a/' and 'b/', of which one is looked for");
}

BOOST_AUTO_TEST_CASE(what_is_called_like_a_missing_file_is_named) {
  const TemporaryFolder folder;
  folder.write("alice/src/Square.cpp", "int a;\n");
  folder.write("alice/src/sum.cpp", "int b;\n");
  folder.write("bob/src/square.cpp", "int a;\n");
  folder.write("bob/sum.cpp.txt", "int b;\n");

  const auto check_hint = [&](const std::string& student, const std::string& hint) {
    for (const fs::path& path :
         {folder.path() / student, packed(folder, student + ".zip", student)}) {
      const Submission submission = take(path);
      BOOST_REQUIRE(submission.problems.size() == 2U);
      BOOST_TEST(submission.problems[1].ends_with(hint), submission.problems[1]);
    }
  };
  check_hint("alice", "src/Square.cpp', but src/square.cpp is looked for");
  check_hint("bob", "sum.cpp.txt', but src/sum.cpp is looked for");
}

BOOST_AUTO_TEST_CASE(what_is_spelt_nearly_like_a_missing_file_is_named) {
  for (const std::string there : {"src/square.cc", "src/sqare.cpp", "src/s-quare.cpp"}) {
    const TemporaryFolder folder;
    folder.write("alice/" + there, "int a;\n");
    folder.write("alice/src/square.hpp", "int a();\n");
    folder.write("alice/src/sum.cpp", "int b;\n");

    const Submission submission = take(folder.path() / "alice");

    const std::vector<std::string> expected = {
        "src/square.cpp is missing", "there is '" + there + "', but src/square.cpp is looked for"};
    BOOST_TEST(submission.problems == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_header_of_the_same_name_is_not_what_is_missing) {
  const TemporaryFolder folder;
  folder.write("alice/src/square.hpp", "int a();\n");
  folder.write("alice/src/sum.cpp", "int b;\n");

  BOOST_TEST(take(folder.path() / "alice").problems ==
                 std::vector<std::string>{"src/square.cpp is missing"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_is_neither_folder_nor_archive_is_refused) {
  const TemporaryFolder folder;

  for (const fs::path& path : {folder.write("notes\n'1'.txt", "x"), folder.path() / "nothing"}) {
    BOOST_CHECK_THROW(take(path), sys::OutputError);
  }
}

BOOST_AUTO_TEST_CASE(an_archive_larger_than_allowed_is_not_opened) {
  const TemporaryFolder folder;

  BOOST_TEST(problem_of(folder.write("a.zip", std::string(11'000'000, 'x'))) ==
             "waits: the archive is larger than 10 MB");
}

BOOST_AUTO_TEST_CASE(what_is_not_wanted_of_an_archive_is_put_aside_once) {
  const TemporaryFolder folder, work, again;
  const Limits limits = toy_grading::assignment().limits;
  Archive archive(limits, slow_archive(folder, 3), work.path(), Isolation::sandbox);

  archive.keep({"src/0.cpp", "src/2.cpp", "src/9.cpp"});

  const Archive kept(limits, work.path() / "archive", again.path(), Isolation::sandbox);
  const std::set<std::string> entries(kept.entries().begin(), kept.entries().end());
  BOOST_TEST((entries == std::set<std::string>{"src/0.cpp", "src/2.cpp"}));
  BOOST_TEST(archive.read("src/2.cpp") == "int a;\n");
}

BOOST_AUTO_TEST_CASE(all_that_is_unpacked_of_an_archive_has_one_limit_of_time) {
  const TemporaryFolder folder, work;
  Archive archive(toy_grading::assignment().limits, slow_archive(folder, 1), work.path(),
                  Isolation::sandbox, 1);
  std::string fault;
  for (int i = 0; i < 40 && fault.empty(); ++i) {
    try {
      archive.read("src/0.cpp");
    } catch (const std::invalid_argument& error) {
      fault = error.what();
    }
  }
  BOOST_TEST(fault == "is not unpacked: the archive takes longer than 1 s");
}

BOOST_AUTO_TEST_CASE(what_is_no_archive_says_so_in_one_line) {
  const TemporaryFolder folder;

  BOOST_TEST(
      problem_of(folder.write("a.zip", "no archive at all\n")) ==
      "waits: the archive cannot be read: Error opening archive: Unrecognized archive format");
}

BOOST_AUTO_TEST_CASE(two_places_are_one_too_many) {
  BOOST_TEST(place_of_files({"src/a.cpp", "old/src/a.cpp"}, {"src/a.cpp"}) == "");
  BOOST_TEST(place_of_files({"x/src/a.cpp", "x/src/b.cpp"}, {"src/a.cpp", "src/b.cpp"}) == "x/");
  BOOST_TEST(place_of_files({"x/y/src/a.cpp", "/src/a.cpp", "../src/a.cpp"}, {"src/a.cpp"}) == "");
  BOOST_CHECK_THROW(place_of_files({"x/src/a.cpp", "y/src/b.cpp"}, {"src/a.cpp", "src/b.cpp"}),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_student_is_the_name_without_its_ending) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "carol.zip");

  BOOST_TEST(student_of("some/where/alice.tar.gz") == "alice");
  BOOST_TEST(student_of("bob.b.zip") == "bob.b");
  BOOST_TEST(student_of(folder.path() / "carol.zip/") == "carol.zip");
}

BOOST_AUTO_TEST_CASE(shown_texts_are_utf8_without_control_characters) {
  BOOST_TEST(shown("a\x1b[31m\xff\xc3\xa4\n\xed\xa0\x80", 100) == "a?[31m?ä\n???");
  BOOST_TEST(shown("a\u202Eb\u2066c\u200Fd\u2028e", 100) == "a?b?c?d?e");
  BOOST_TEST(shown("aää", 4) == "aä\n[… cut]");
  BOOST_TEST(shown_name("line\nend") == "line?end");
}

BOOST_AUTO_TEST_SUITE_END()
