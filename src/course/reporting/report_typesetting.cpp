// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/report_typesetting.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/erase.hpp>
#include <chrono>
#include <csignal>

#include "course/assignment/student.hpp"
#include "literate/typesetting/latex_log.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_of_log = 4U << 20U;  ///< bytes

/// Where Debian's TeX and fontconfig keep what is not below /usr.
std::vector<Readable> settings_of_tools() {
  std::vector<Readable> settings;
  for (const char* folder :
       {"/etc/texmf", "/var/lib/texmf", "/etc/fonts", "/var/cache/fontconfig"}) {
    if (fs::is_directory(folder)) settings.push_back({folder, folder});
  }
  return settings;
}

// A copy is drawn in, since the script writes beside its data.
constexpr const char* gnuplot_script = R"sh(
cp -R "$1" "$2" && chmod -R u+w "$2" && mkdir -p "$2/generated" && cd "$2" &&
env LC_ALL=C.UTF-8 TZ=UTC gnuplot --default-settings "$3.gp" >&2 && cat "generated/$3.pdf")sh";

// Trailer, figures and random numbers of the PDF would else tell folder and time. The kernel ends
// LaTeX alone, so that its log can still be told. A report can write report.pdf and report.log
// itself, but not what LaTeX prints after the report's end: how many bytes the PDF has. `p` keeps
// it from files that are named by an absolute path or lie above, also where there are no walls.
constexpr const char* latex_script = R"sh(
scratch=$1
export openin_any=p openout_any=p max_print_line=1000 TZ=UTC FORCE_SOURCE_DATE=1 SOURCE_DATE_EPOCH="$3"
for pass in 1 2; do
  said=$({
    prlimit --cpu="$2:$(($2 + 1))" pdflatex -jobname=report -no-shell-escape -no-parse-first-line -interaction=nonstopmode \
      -file-line-error -output-directory="$scratch" '\pdftrailerid{}\pdfsuppressptexinfo=-1 \pdfsetrandomseed 1 \input{report.tex}'
    printf '\n%s\n' "$?"
  } | tail -n 4)
  status=${said##*[!0-9]}
  size=$(printf '%s\n' "$said" | sed -n 's/^Output written on .* (.* \([0-9]*\) bytes)\.$/\1/p')
  if [ "$status" -gt 1 ] || [ -z "$size" ]; then break; fi
done
if [ -s "$scratch/report.log" ]; then cat "$scratch/report.log" >&2; else printf '%s\n' "$said" >&2; fi
if [ -n "$size" ] && [ "$(wc -c <"$scratch/report.pdf")" -eq "$size" ]; then cat "$scratch/report.pdf" || exit; fi
exit "$status")sh";

}  // namespace

/// What a job wrote, and how it ended.
struct ReportTypesetting::Product {
  JobEnd end;
  std::string output, errors;
};

ReportTypesetting::ReportTypesetting(const Assignment& assignment, const fs::path& work,
                                     Isolation isolation)
    : assignment_(assignment), work_(fs::absolute(work)), sandbox_(isolation, work_) {
  require_tools();
}

ReportTypesetting::Product ReportTypesetting::run(const fs::path& folder, const std::string& script,
                                                  const std::vector<std::string>& arguments,
                                                  int seconds) const {
  const Readable report{folder, "/report"};
  Job job;
  job.command = {"/bin/sh", "-c", script, "sh"};
  job.command.insert(job.command.end(), arguments.begin(), arguments.end());
  job.readable = settings_of_tools();
  job.readable.push_back(report);
  job.folder = sandbox_.place(report);
  job.output = work_ / "product";
  job.errors = work_ / "said";
  job.seconds = seconds;
  job.waiting_seconds = 5;  // what waits longer reads from something that gives it nothing
  job.memory_mb = assignment_.limits.memory_mb;
  job.processes = assignment_.limits.processes;
  job.file_kb = 1024 * assignment_.limits.submission_mb;
  job.scratch_mb = 4 * assignment_.limits.submission_mb;
  const JobEnd end = sandbox_.run(job);
  return {end, beginning_of(job.output, static_cast<std::size_t>(job.file_kb) * 1024),
          beginning_of(job.errors, most_of_log)};
}

std::string ReportTypesetting::draw(const fs::path& folder, const std::string& name,
                                    double& seconds_left) const {
  const Product drawn =
      run(folder, gnuplot_script,
          {sandbox_.place({folder, "/report"}), sandbox_.scratch() + "/drawn", name},
          std::max(1, static_cast<int>(seconds_left)));
  seconds_left -= drawn.end.seconds;
  const bool has_worked = drawn.end.ending == Ending::normal && drawn.end.status == 0;
  if (has_worked && drawn.output.starts_with("%PDF")) {
    sys::write_file_atomically(folder / "generated" / (name + ".pdf"), drawn.output);
    make_readable(folder / "generated");
    return "";
  }
  std::string why = "it exceeds a limit";
  for (const std::string_view line : sys::lines_of(drawn.errors)) {
    // gnuplot shows the script's line and a mark below it, and then says what is wrong.
    if (!sys::stripped(line).empty()) why = shown_name(line);
  }
  return fmt::format("report/{}.gp: it draws nothing: {}", name, why);
}

ReportTypesetting::Product ReportTypesetting::latex(const fs::path& folder) const {
  const int seconds_of_a_pass = std::max(1, assignment_.limits.report_seconds / 2);
  const auto date = assignment_.deadline.time_since_epoch();
  return run(
      folder, latex_script,
      {sandbox_.scratch(), fmt::format("{}", seconds_of_a_pass), fmt::format("{}", date.count())},
      2 * seconds_of_a_pass + 2);  // two passes, and what runs beside them
}

Typeset ReportTypesetting::typeset(const fs::path& folder) const {
  const Limits& limits = assignment_.limits;
  const Product made = latex(folder);
  Typeset typeset{made.output.starts_with("%PDF") ? made.output : "",
                  boost::algorithm::erase_all_copy(made.errors, sandbox_.scratch() + "/"), "",
                  made.end.status == 1};
  const Ending ending = made.end.ending;
  const int status = made.end.status;
  const auto is_ended_by = [&](int signal) { return ending == Ending::crash && status == signal; };
  if (ending == Ending::too_slow || is_ended_by(SIGXCPU)) {
    typeset.problem =
        fmt::format("two passes of LaTeX take longer than {} s", limits.report_seconds);
  } else if (ending == Ending::too_large) {
    typeset.problem = fmt::format("LaTeX uses more than {} MB of memory", limits.memory_mb);
  } else if (ending == Ending::too_much_output) {
    typeset.problem = fmt::format("LaTeX writes a file of more than {} MB", limits.submission_mb);
  } else if (ending != Ending::normal) {
    typeset.problem = "LaTeX crashed, or started too many processes";
  } else if (typeset.pdf.empty() && status == 0) {
    typeset.problem = "LaTeX does not say that it wrote a page";
  }
  // A PDF that LaTeX had not finished is none.
  if (!typeset.problem.empty()) typeset.pdf.clear();
  return typeset;
}

void ReportTypesetting::require_tools() const {
  for (const char* tool : {"gnuplot", "pdflatex"}) sys::find_tool(tool);
  const fs::path folder = work_ / "trial";
  sys::write_file_atomically(folder / "trial.gp",
                             "set terminal pdfcairo\nset output 'generated/trial.pdf'\nplot x\n");
  sys::write_file_atomically(folder / "report.tex",
                             "\\documentclass{article}\\begin{document}x\\end{document}\n");
  fs::create_directories(folder / "generated");
  make_readable(folder);
  double seconds = assignment_.limits.report_seconds;
  const std::string failure = draw(folder, "trial", seconds);
  if (!failure.empty()) throw sys::ToolError("gnuplot does not work in the sandbox: " + failure);
  const Typeset made = typeset(folder);
  if (!made.pdf.empty()) return;
  const std::vector<std::string> errors = literate::latex_errors(made.log, "trial");
  throw sys::ToolError(fmt::format("pdflatex does not work in the sandbox: {}",
                                   !made.problem.empty() ? made.problem
                                   : errors.empty()      ? shown(made.log, 1000)
                                                         : errors.front()));
}

}  // namespace course
