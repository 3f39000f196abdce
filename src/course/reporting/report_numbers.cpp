// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/marked_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "course/assignment/student.hpp"
#include "course/marking/archive.hpp"
#include "course/marking/build.hpp"
#include "course/marking/program_run.hpp"
#include "course/marking/toolkit.hpp"
#include "course/release/handout.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char* program_file = "report/figures.cpp";
constexpr std::size_t most_files = 100;
constexpr std::size_t most_said = 4000;  ///< bytes of what a program says that a marker reads

/// Whether a file is one that the scripts and the report can ask for: numbers.tex or NAME.dat, with
/// a name that means nothing else to any program. What else a student's functions leave beside
/// them, such as drawings of their own, is not taken.
bool is_wanted(const std::string& name) {
  constexpr std::size_t longest = 100;
  if (name.empty()) return false;
  const bool is_plain =
      sys::is_alphanumeric(name.front()) && std::ranges::all_of(name, [&](char c) {
        return sys::is_alphanumeric(c) || c == '.' || c == '-' || c == '_';
      });
  return is_plain && name.size() <= longest && (name == "numbers.tex" || name.ends_with(".dat"));
}

/// Runs the program, whose files come back as an archive on standard output.
class FiguresRun {
 public:
  FiguresRun(const Assignment& assignment, const fs::path& work, Isolation isolation)
      : limits_(assignment.limits), work_(work), isolation_(isolation), sandbox_(isolation, work) {
    limits_.file_kb = 1024 * limits_.submission_mb;
    limits_.output_kb = limits_.file_kb;
    limits_.run_seconds = limits_.report_seconds;
  }

  ReportNumbers run(const fs::path& program, double& seconds_left) const {
    ReportNumbers numbers;
    const JobEnd end = run_in_sandbox(program, std::max(1, static_cast<int>(seconds_left)));
    seconds_left -= end.seconds;
    const std::string said = shown(beginning_of(work_ / "errors", most_said), most_said);
    for (const std::string_view line : sys::lines_of(said)) {
      numbers.problems.push_back(fmt::format("{}: {}", program_file, line));
    }
    const std::string why = failure_of(limits_, end);
    if (!why.empty()) {
      numbers.problems.push_back(
          fmt::format("{}: with these functions there are no numbers: it {}", program_file, why));
      return numbers;
    }
    take_files(numbers);
    return numbers;
  }

 private:
  JobEnd run_in_sandbox(const fs::path& program, int seconds) const {
    const Readable readable{program, "/program"};
    Job job;
    job.command = {"/bin/sh",
                   "-c",
                   R"(mkdir "$2" && "$1" "$2" >/dev/null && exec "$3" -cf - -C "$2" .)",
                   "sh",
                   sandbox_.place(readable),
                   sandbox_.scratch() + "/generated",
                   sys::find_tool("bsdtar")};
    job.readable = {readable};
    job.output = archive();
    job.errors = work_ / "errors";
    job.seconds = seconds;
    job.waiting_seconds = seconds;
    job.memory_mb = limits_.memory_mb;
    job.processes = limits_.processes;
    job.file_kb = limits_.file_kb;
    job.scratch_mb = 2 * limits_.submission_mb;
    return sandbox_.run(job);
  }

  void take_files(ReportNumbers& numbers) const {
    const fs::path unpacking = work_ / "unpacking";
    fs::create_directories(unpacking);
    try {
      Archive files(limits_, archive(), unpacking, isolation_);
      std::size_t n_bytes = 0;  // an archive is small although its files have holes
      for (const std::string& name : files.entries()) {
        if (!is_wanted(name) || numbers.files.size() == most_files) continue;
        const std::string bytes = bytes_of(files, name, numbers);
        n_bytes += bytes.size();
        if (n_bytes > static_cast<std::size_t>(limits_.submission_mb) << 20U) {
          numbers.problems.push_back(fmt::format("{}: its files hold more than {} MB", program_file,
                                                 limits_.submission_mb));
          break;
        }
        if (!bytes.empty()) numbers.files[name] = bytes;
      }
    } catch (const std::invalid_argument& error) {
      numbers.problems.push_back(
          fmt::format("{}: its files cannot be read: {}", program_file, error.what()));
    }
  }

  /// Empty if it cannot be read, which is told.
  static std::string bytes_of(Archive& files, const std::string& name, ReportNumbers& numbers) {
    try {
      return files.read(name);
    } catch (const std::invalid_argument& fault) {
      numbers.problems.push_back(
          fmt::format("{}: generated/{} {}", program_file, name, fault.what()));
      return "";
    }
  }

  fs::path archive() const { return work_ / "files.tar"; }

  Limits limits_;
  fs::path work_;
  Isolation isolation_;
  Sandbox sandbox_;
};

/// Runs the program twice, and tells what differs.
ReportNumbers run_twice(const Assignment& assignment, const fs::path& program,
                        const fs::path& scratch, Isolation isolation, double& seconds_left) {
  const auto run = [&](const char* name) {
    const fs::path work = scratch / name;
    fs::create_directories(work);
    return FiguresRun(assignment, work, isolation).run(program, seconds_left);
  };
  ReportNumbers numbers = run("figures");
  if (numbers.files.empty()) return numbers;
  const Files again = run("again").files;
  for (const auto& [name, bytes] : numbers.files) {
    const auto found = again.find(name);
    if (found != again.end() && found->second == bytes) continue;
    numbers.problems.push_back(
        fmt::format("{}: generated/{} differs from run to run", program_file, name));
  }
  return numbers;
}

}  // namespace

ReportNumbers report_numbers(const Assignment& assignment, const fs::path& toolkit,
                             const Files& exercises, const Variant& variant,
                             const fs::path& scratch, Isolation isolation, double& seconds_left) {
  if (!fs::exists(open_toolkit(assignment, toolkit).project() / program_file)) return {};
  const OtherMain figures{program_file, {{variant_file, variant_header(assignment, variant)}}};
  const Built built = build(assignment, toolkit, exercises, scratch / "build", isolation, figures);
  ReportNumbers numbers;
  if (built.link_error.empty()) {
    numbers = run_twice(assignment, built.program, scratch, isolation, seconds_left);
    if (!numbers.files.empty() && !numbers.files.contains("numbers.tex")) {
      numbers.problems.push_back(fmt::format("{}: there is no numbers.tex", program_file));
    }
  } else {
    numbers.problems.push_back("the submission does not link: " + built.link_error);
  }
  std::vector<std::string> compiling;
  for (const auto& [exercise, message] : built.compile_errors) {
    compiling.push_back(fmt::format("{}: {}", exercise, message.substr(0, message.find('\n'))));
  }
  numbers.problems.insert(numbers.problems.begin(), compiling.begin(), compiling.end());
  return numbers;
}

}  // namespace course
