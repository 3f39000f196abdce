// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/marked_report.hpp"

#include <fmt/core.h>

#include <chrono>
#include <optional>
#include <set>
#include <stdexcept>

#include "course/assignment/student.hpp"
#include "course/marking/toolkit.hpp"
#include "course/sandbox/child.hpp"
#include "literate/typesetting/latex_log.hpp"
#include "system/files.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_shown_of_log = 256U << 10U;  ///< bytes that a marker gets

std::string text_of(const Files& files, const std::string& name) {
  const auto file = files.find(name);
  return file == files.end() ? "" : file->second;
}

/// Makes a report ready in a folder of its own.
class ReportMaker {
 public:
  ReportMaker(const Assignment& assignment, const ReportTypesetting& typesetting,
              const ReportTask& task, const fs::path& scratch)
      : assignment_(assignment),
        typesetting_(typesetting),
        task_(task),
        scratch_(scratch),
        folder_(scratch / "report"),
        seconds_left_(assignment.limits.report_seconds) {}

  Files made() {
    for (const char* name : {"report.tex", "report.pdf"}) {
      const auto file = task_.report.files.find(std::string("report/") + name);
      if (file != task_.report.files.end()) given_[name] = file->second;
    }
    texts_.report = text_of(given_, "report.tex");
    const std::string fault = fault_of_report();
    compute();
    if (fault.empty()) {
      draw();
      typeset();
      check();
    } else {
      tell(fmt::format("report/report.tex {}", fault));
    }
    given_["findings.txt"] = findings_;
    return std::move(given_);
  }

 private:
  void tell(const std::string& finding) { findings_ += shown_name(finding) + "\n"; }

  /// A text, unless it is larger than a file of a submission may be.
  std::string of_this_size(std::string text) const {
    return text.size() > max_bytes() ? "" : std::move(text);
  }

  std::size_t max_bytes() const {
    return static_cast<std::size_t>(assignment_.limits.file_kb) * 1024;
  }

  /// Why report.tex cannot be typeset; empty if it can be tried.
  std::string fault_of_report() const {
    if (!task_.report.fault.empty()) return task_.report.fault;
    if (!given_.contains("report.tex")) return "is missing";
    if (texts_.report.size() > max_bytes()) {
      return fmt::format("is larger than {} kB", assignment_.limits.file_kb);
    }
    return fault_of(texts_.report);
  }

  void compute() {
    const fs::path numbers_folder = scratch_ / "numbers";
    fs::create_directories(numbers_folder);
    const ReportNumbers numbers =
        report_numbers(assignment_, task_.toolkit, task_.exercises, task_.variant, numbers_folder,
                       task_.isolation, seconds_left_);
    for (const std::string& problem : numbers.problems) tell(problem);
    const std::string computed = text_of(numbers.files, "numbers.tex");
    texts_.computed = of_this_size(computed);
    if (texts_.computed != computed) {
      tell(fmt::format("report/figures.cpp: generated/numbers.tex is larger than {} kB",
                       assignment_.limits.file_kb));
    }
    if (!texts_.computed.empty()) given_["numbers.tex"] = texts_.computed;
    fs::create_directories(folder_ / "generated");
    for (const auto& [name, text] : numbers.files) {
      if (name == "numbers.tex" && texts_.computed.empty()) continue;
      sys::write_file_atomically(folder_ / "generated" / name, text);
    }
  }

  /// By the handout's scripts, not by the student's.
  void draw() {
    const fs::path handout = open_toolkit(assignment_, task_.toolkit).report();
    if (!fs::is_directory(handout)) return;
    std::vector<std::string> names;
    for (const std::string& file : sys::files_below(handout)) {
      if (!file.ends_with(".gp")) continue;
      sys::write_file_atomically(folder_ / file, sys::read_file(handout / file));
      names.push_back(file.substr(0, file.size() - 3));
    }
    make_readable(folder_);
    for (const std::string& name : names) {
      const std::string failure = typesetting_.draw(folder_, name, seconds_left_);
      if (!failure.empty()) tell(failure);
    }
  }

  void typeset() {
    sys::write_file_atomically(folder_ / "report.tex", texts_.report);
    make_readable(folder_);
    // LaTeX can print the times of files.
    for (const std::string& file : sys::files_below(folder_)) {
      fs::last_write_time(folder_ / file, std::chrono::file_clock::from_sys(assignment_.deadline));
    }
    const Typeset made = typesetting_.typeset(folder_);
    if (!made.problem.empty()) tell(fmt::format("report/report.tex: {}", made.problem));
    if (!made.pdf.empty()) given_["typeset.pdf"] = made.pdf;
    given_["typeset.log"] = shown(made.log, most_shown_of_log);
    texts_.log = made.log;
    if (made.has_errors && literate::latex_errors(made.log, "report").empty()) {
      tell("report/report.tex: LaTeX met errors that its log does not hold");
    }
  }

  /// In a process of its own: a matcher may take long, or deep recursion, over what means harm.
  void check() {
    check("commands", findings_of_commands);
    check("numbers", findings_of_numbers);
  }

  void check(const char* what, std::vector<std::string> (*findings_of)(const ReportTexts&)) {
    const auto seconds = static_cast<unsigned>(assignment_.limits.report_seconds);
    const auto work = [&] {
      std::string lines;
      for (const std::string& finding : findings_of(texts_)) lines += finding + "\n";
      return lines;
    };
    const std::optional<std::string> found =
        apart(work, seconds, static_cast<unsigned>(assignment_.limits.memory_mb));
    if (found) {
      findings_ += *found;
    } else {
      tell(fmt::format("report/report.tex: its {} cannot be checked within {} s", what, seconds));
    }
  }

  const Assignment& assignment_;
  const ReportTypesetting& typesetting_;
  const ReportTask& task_;
  fs::path scratch_, folder_;
  Files given_;
  ReportTexts texts_;
  std::string findings_;
  double seconds_left_;  ///< for program and drawings
};

}  // namespace

Files marked_report(const Assignment& assignment, const ReportTypesetting& typesetting,
                    const ReportTask& task, const fs::path& scratch) {
  return ReportMaker(assignment, typesetting, task, scratch).made();
}

std::map<std::string, std::string> anonymous_names(const std::vector<std::string>& units,
                                                   const std::string& seed) {
  constexpr std::size_t n_digits = 10;
  std::map<std::string, std::string> names;
  std::set<std::string> known;
  for (const std::string& unit : units) {
    const std::string digest = sys::sha256_of_text("report\n" + seed + "\n" + unit);
    names[unit] = "report-" + digest.substr(0, n_digits);
    if (!known.insert(names[unit]).second) throw std::logic_error("two reports have one name");
  }
  return names;
}

}  // namespace course
