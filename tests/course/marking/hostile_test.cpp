// SPDX-License-Identifier: GPL-3.0-or-later
// Grades submissions that are broken or mean harm: those in tests/course/hostile, and others that
// cannot be kept as files. Each is graded in a process of its own, as in a class.
#include <fmt/core.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "course/assignment/student.hpp"
#include "course/marking/grade.hpp"
#include "course/toy_grading.hpp"
#include "course/walls.hpp"
#include "holds.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"
#include "system/process.hpp"

BOOST_AUTO_TEST_SUITE(hostile_test, *boost::unit_test::fixture(&need_walls))

using namespace course;
namespace fs = std::filesystem;

namespace {

const fs::path fixtures = fs::path(HALFSPACE_SOURCE_DIR) / "tests/course/hostile";

/// What the log must say about each of them; all but those of `with_points` have none.
const std::map<std::string, std::string> reasons = {
    {"answers_by_the_clock", "different answers to the same question"},
    {"answers_by_the_uptime", "file not found: /proc/uptime"},
    {"answers_commas", "no decimal number"},
    {"answers_hexadecimal", "no decimal number"},
    {"answers_infinity", "no decimal number"},
    {"answers_markup", "no decimal number"},
    {"answers_nan", "does not grow"},
    {"answers_nothing", "answered nothing"},
    {"answers_too_few", "does not grow"},
    {"answers_too_many", "does not grow"},
    {"answers_twice", "does not grow"},
    {"archive_climbs", "entries that lead out of its folder"},
    {"archive_through_link", "does not grow"},
    {"asks_for_the_plugin", "undefined reference to `square(double)"},
    {"asserts_the_date", "src/square.cpp:4:10: error: 'nothing' was not declared"},
    {"attacks_linker", "the program crashed (SIGSEGV)"},
    {"becomes_root", "does not grow"},
    {"changes_its_program", "does not grow"},
    {"closes_streams", "the program ended with a failure"},
    {"constexpr_bomb", "to compile"},
    {"defines_the_other_exercise", "multiple definition of `sum"},
    {"edits_makefile", "does not grow"},
    {"endless_constructor", "the program took longer than 1 s"},
    {"endless_loop", "the program took longer than 1 s"},
    {"ends_ill", "the program ended with a failure"},
    {"exhausts_asynchronous_reads", "does not grow"},
    {"exits_as_if_too_slow", "the program ended with a failure"},
    {"fills_many_files", "does not grow"},
    {"fills_one_file", "does not grow"},
    {"fills_socket_pairs", "does not grow"},
    {"floods_errors", "the program wrote more than 16 kB"},
    {"floods_output", "the program wrote more than 16 kB"},
    {"forgets_its_children", "the program took longer than 1 s"},
    {"forgets_short_children", "the program took longer than 1 s"},
    {"fork_bomb", "the program took longer than 1 s"},
    {"holds_shared_memory", "does not grow"},
    {"honest", "20 of 20 points"},
    {"huge_object", "to compile"},
    {"incbin_of_passwords", "file not found: /etc/shadow"},
    {"includes_a_terminal", "/dev/ptmx: No such file or directory"},
    {"includes_hidden_checks", "No such file or directory"},
    {"includes_its_memory_map", "/proc/self/maps: No such file or directory"},
    {"includes_itself", "nested depth 200 exceeds maximum"},
    {"includes_noise", "/dev/urandom: No such file or directory"},
    {"includes_passwords", "/etc/passwd: No such file or directory"},
    {"includes_standard_input", "/dev/stdin: No such file or directory"},
    {"includes_the_time", "00:00:00: No such file or directory"},
    {"includes_the_time_stamp", "empty filename in #include"},
    {"includes_the_uptime", "/proc/uptime: No such file or directory"},
    {"includes_zeros", "/dev/zero: No such file or directory"},
    {"is_no_cpp", "src/square.cpp:2:1: error: stray"},
    {"keeps_keys", "does not grow"},
    {"kills_itself", "the program crashed (SIGKILL)"},
    {"kills_others", "does not grow"},
    {"leaves_a_daemon", "does not grow"},
    {"leaves_a_sibling", "does not grow"},
    {"lines_of_noise", "/dev/urandom:1:10: error: 'nothing' was not declared"},
    {"locks_parts_of_what_others_see", "does not grow"},
    {"locks_what_others_see", "does not grow"},
    {"looks_at_the_machine", "does not grow"},
    {"looks_at_the_page_cache", "does not grow"},
    {"macro_bomb", "to compile"},
    {"marks_its_output", "does not grow"},
    {"memory_bomb", "the program crashed (SIGABRT)"},
    {"memory_bomb_in_children", "does not grow"},
    {"memory_bomb_of_a_thread", "the program used more than 512 MB"},
    {"mounts_over_the_system", "does not grow"},
    {"never_ends", "the program took longer than 1 s"},
    {"patches_in_constructor", "does not grow"},
    {"pins_pages_in_pipes", "does not grow"},
    {"pragmas", "No such file or directory"},
    {"prints_in_constructors", "20 of 20 points"},
    {"prints_numbers_early", "does not grow"},
    {"prints_on_the_way", "20 of 20 points"},
    {"prints_passed", "no decimal number"},
    {"prints_results", "no decimal number"},
    {"raises_limits", "does not grow"},
    {"reads_environments", "does not grow"},
    {"reads_neighbour", "does not grow"},
    {"recurses_for_ever", "the program crashed (SIGSEGV)"},
    {"redefines_main", "multiple definition"},
    {"replaces_checks", "does not grow"},
    {"replaces_header", "../provided/answers.hpp: No such file or directory"},
    {"searches_for_tests", "does not grow"},
    {"signals_itself", "the program crashed (SIGSEGV)"},
    {"sleeps", "the program took longer than 1 s"},
    {"sleeps_behind_vfork", "the program took longer than 1 s"},
    {"slows_the_linker", "to compile"},
    {"spins_in_children", "the program took longer than 1 s"},
    {"stops_its_parent", "does not grow"},
    {"stops_itself", "the program took longer than 1 s"},
    {"takes_over_printing", "the program answered nothing"},
    {"takes_over_the_channel", "multiple definition of `course::answer_descriptor"},
    {"template_bomb", "to compile"},
    {"thread_bomb", "the program"},
    {"throws", "the program crashed (SIGABRT)"},
    {"traces_parent", "does not grow"},
    {"turns_its_text", "/*? } ? */ return nothing;"},
    {"uses_network", "does not grow"},
    {"watches_what_others_read", "does not grow"},
    {"writes_before_the_channel_is_apart", "does not grow"},
    {"writes_results", "does not grow"},
    {"writes_results_when_compiled", "results.json"},
};

/// Submissions that are odd and do no wrong.
const std::map<std::string, std::string> with_points = {
    {"honest", "20"}, {"prints_in_constructors", "20"}, {"prints_on_the_way", "20"}};

/// Submissions of which nothing can be taken, and what is said of them: they have no mark and wait
/// for a person.
const std::map<std::string, std::string> not_graded = {
    {"archive_bomb", "src/square.cpp is larger than 64 kB"},
    {"archive_is_empty", "the archive is empty"},
    {"archive_is_none", "the archive cannot be read: Error opening archive: Unrecognized"},
    {"archive_of_odd_names", "there is 'src/squ?are.cpp', but src/square.cpp is looked for"},
    {"archive_of_two", "the submission holds files in two places, 'a/' and 'b/'"},
    {"binary_file", "src/square.cpp is no text in UTF-8: byte 9 is zero"},
    {"device", "src/square.cpp is a device, not a file"},
    {"empty_file", "src/square.cpp is empty"},
    {"empty_folder", "the submission is empty, or cannot be read"},
    {"folder_for_file", "src/square.cpp is a folder, not a file"},
    {"huge_file", "src/square.cpp is larger than 64 kB"},
    {"huge_submission", "the submission is larger than 1 MB"},
    {"link_for_file", "src/square.cpp is a symbolic link"},
    {"link_for_folder", "is a symbolic link, or lies behind one"},
    {"missing_file", "there is 'src/squares.cpp', but src/square.cpp is looked for"},
    {"pipe_for_file", "src/square.cpp is a pipe, not a file"}};

std::string points_of(const std::string& name) {
  const auto known = with_points.find(name);
  return known == with_points.end() ? "0" : known->second;
}

/// Whether a submission is graded: all are, or those that the command line names,
/// `course_slow_tests --run_test=hostile_test -- honest sleeps`.
bool is_wanted(const std::string& name) {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  const std::vector<std::string> named(suite.argv + 1, suite.argv + suite.argc);
  return named.empty() || std::ranges::find(named, name) != named.end();
}

Assignment hostile_assignment() {
  Assignment assignment = toy_grading::assignment();
  assignment.limits.compile_seconds = 5;
  return assignment;
}

void tar(const fs::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"--format=pax"});
  const sys::ProcessResult result =
      sys::run({.program = "bsdtar", .arguments = arguments, .working_directory = folder});
  BOOST_REQUIRE_MESSAGE(result.exit_status == 0, result.output);
}

/// The submissions that consist of a special kind of file.
void make_odd_files(const TemporaryFolder& made) {
  made.write("binary_file/src/square.cpp", std::string("int x = \0;", 10));
  made.write("empty_file/src/square.cpp", "");
  made.write("huge_file/src/square.cpp", std::string(65 * 1024, '\n'));
  made.write("huge_submission/notes.txt", std::string(1'100'000, 'x'));
  made.write("huge_submission/src/square.cpp", "double square(double x) { return x * x; }\n");
  made.write("missing_file/src/squares.cpp", "double square(double x) { return x * x; }\n");
  made.write("missing_file/src/line\nend '\" $(touch x).cpp", "\n");
  made.write("folder_for_file/src/square.cpp/square.cpp", "\n");
  for (const char* name : {"link_for_file/src", "pipe_for_file/src", "device/src", "empty_folder",
                           "link_for_folder"}) {
    fs::create_directories(made.path() / name);
  }
  fs::create_symlink("/etc/shadow", made.path() / "link_for_file/src/square.cpp");
  fs::create_directory_symlink(toy_grading::folder / "template/src",
                               made.path() / "link_for_folder/src");
  BOOST_REQUIRE(::mkfifo((made.path() / "pipe_for_file/src/square.cpp").c_str(), 0600) == 0);
  if (::mknod((made.path() / "device/src/square.cpp").c_str(), S_IFCHR | 0666, makedev(1, 5)) !=
      0) {
    fs::remove_all(made.path() / "device");  // only root can make one
  }
}

void make_archives(const TemporaryFolder& made, const TemporaryFolder& parts) {
  const std::string source = "double square(double) { return 0; }\n";
  const auto archive = [&](const char* name) { return (made.path() / name).string(); };
  parts.write("up/src/square.cpp", source);
  parts.write("up/escaped.txt", "climbed out\n");
  tar(parts.path() / "up", {"-cf", archive("archive_climbs.zip"), "--format=zip", "-s",
                            ",^escaped,../../escaped,", "escaped.txt", "src/square.cpp"});

  fs::create_directories(parts.path() / "link");
  fs::create_directory_symlink(parts.path(), parts.path() / "link/src");
  tar(parts.path() / "link", {"-cf", archive("archive_through_link.tar.gz"), "-z", "src", "-C",
                              "../up", "src/square.cpp"});

  parts.write("bomb/src/square.cpp", std::string(50'000'000, '\n'));
  tar(parts.path() / "bomb", {"-cf", archive("archive_bomb.tar.xz"), "-J", "src/square.cpp"});

  parts.write("odd/src/squ\nare.cpp", source);
  parts.write("odd/-rf/src/$(touch x)", source);
  tar(parts.path() / "odd", {"-cf", archive("archive_of_odd_names.tgz"), "-z", "."});

  parts.write("two/a/src/square.cpp", source);
  parts.write("two/b/src/square.cpp", source);
  tar(parts.path() / "two", {"-cf", archive("archive_of_two.tar"), "a", "b"});

  made.write("archive_is_none.zip", "this is no archive\n");
  made.write("archive_is_empty.zip", "");
}

std::vector<fs::path> all_submissions(const fs::path& made) {
  std::vector<fs::path> submissions;
  for (const fs::path& folder : {fixtures, made}) {
    for (const auto& entry : fs::directory_iterator(folder)) submissions.push_back(entry.path());
  }
  std::erase_if(submissions, [](const fs::path& path) { return !is_wanted(student_of(path)); });
  std::ranges::sort(submissions, {}, [](const fs::path& path) { return student_of(path); });
  return submissions;
}

/// Grades in a child process, because the jobs of two gradings are kept apart by their processes;
/// false if it fails.
bool grade_apart(const fs::path& submission, const fs::path& grades) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      GradingTask task = toy_grading::task_for(submission);
      task.submitted = hostile_assignment().deadline;
      grade_submission(hostile_assignment(), task, grades / task.student);
    } catch (const std::exception& error) {
      sys::write_file_atomically(grades / (student_of(submission) + ".why"), error.what());
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status == 0;
}

/// The names of all processes of the machine.
std::vector<std::string> processes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream stream(entry.path() / "comm");
    std::string name;
    if (std::getline(stream, name)) names.push_back(name);
  }
  return names;
}

/// The first lines that differ, one beside the other.
std::string first_difference(const std::string& one, const std::string& other) {
  std::istringstream left(one), right(other);
  std::string left_line, right_line;
  while (std::getline(left, left_line) && std::getline(right, right_line)) {
    if (left_line != right_line) return left_line + " | " + right_line;
  }
  return "one ends early";
}

class Class {
 public:
  Class() {
    make_odd_files(made_);
    make_archives(made_, parts_);
    submissions_ = all_submissions(made_.path());
    ::setenv("HALFSPACE_SECRET", "hidden", 1);
    toy_grading::toolkit();
  }

  const std::vector<fs::path>& submissions() const { return submissions_; }
  const fs::path& made() const { return made_.path(); }
  const fs::path& parts() const { return parts_.path(); }

  /// Grades all submissions, `n_jobs` at a time.
  void grade(const fs::path& grades, std::size_t n_jobs, bool is_backwards) const {
    const std::size_t n = submissions_.size();
    std::vector<char> has_worked(n);
    sys::for_each_parallel(n, n_jobs, [&](std::size_t i) {
      const std::size_t which = is_backwards ? n - 1 - i : i;
      has_worked[which] = grade_apart(submissions_[which], grades);
    });
    for (std::size_t i = 0; i < n; ++i) {
      const std::string name = student_of(submissions_[i]);
      BOOST_TEST((has_worked[i] != 0) == !not_graded.contains(name),
                 name << (has_worked[i] != 0 ? " was graded" : " was not graded"));
    }
  }

 private:
  TemporaryFolder made_, parts_;
  std::vector<fs::path> submissions_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(no_hostile_submission_gains_a_point_does_harm_or_hinders_the_others) {
  const Class students;
  const TemporaryFolder grades;
  const auto files_before = sys::files_below(students.made());

  const auto begin = std::chrono::steady_clock::now();
  students.grade(grades.path() / "forwards", 2, false);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  students.grade(grades.path() / "backwards", 1, true);

  BOOST_TEST_MESSAGE(students.submissions().size() << " submissions in " << time.count() << " s");
  for (const fs::path& submission : students.submissions()) {
    const std::string name = student_of(submission);
    if (not_graded.contains(name)) {
      BOOST_TEST(!fs::exists(grades.path() / "forwards" / name));
      const std::string why = sys::read_file(grades.path() / "forwards" / (name + ".why"));
      BOOST_TEST(holds(why, not_graded.at(name)), name << ": " << why);
      continue;
    }
    const std::string log = sys::read_file(grades.path() / "forwards" / name / "log.txt");
    BOOST_REQUIRE_MESSAGE(reasons.contains(name), name << " has no reason");
    const std::string sum = fmt::format(": {} of 20 points", points_of(name));
    BOOST_TEST(holds(log, name + sum), log);
    BOOST_TEST(holds(log, reasons.at(name)), reasons.at(name) << " is not in\n" << log);
    for (const char* file : {"results.json", "feedback.html", "mark.json", "log.txt"}) {
      const std::string forwards = sys::read_file(grades.path() / "forwards" / name / file);
      const std::string backwards = sys::read_file(grades.path() / "backwards" / name / file);
      BOOST_TEST(forwards == backwards, name << "/" << file << " depends on order or parallelism: "
                                             << first_difference(forwards, backwards));
      for (const char* turning : {"\u202E", "\u2066"}) {
        BOOST_TEST(!holds(forwards, turning), name << "/" << file << " is turned");
      }
      BOOST_TEST(forwards.find("/tmp/") == forwards.find("/tmp/results.json"),
                 name << "/" << file << " names a scratch folder:\n"
                      << forwards);
    }
  }
  BOOST_TEST(sys::files_below(students.made()) == files_before);
  for (const char* written : {"/tmp/fill", "/tmp/0", "/tmp/results.json", "/tmp/made-by-makefile",
                              "/autograder/results/results.json", "/results.json"}) {
    BOOST_TEST(!fs::exists(written), written);
  }
  BOOST_TEST(!fs::exists(students.parts().parent_path() / "escaped.txt"));
  BOOST_TEST(std::ranges::count(processes(), "left-behind") == 0);
}

BOOST_AUTO_TEST_CASE(every_reason_is_of_a_submission) {
  const Class students;

  for (const auto& [name, reason] : reasons) {
    BOOST_TEST(!reason.empty(), name);
    if (!is_wanted(name)) continue;
    const bool is_there = std::ranges::any_of(
        students.submissions(), [&](const fs::path& path) { return student_of(path) == name; });
    BOOST_TEST((is_there || name == "device"), name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
