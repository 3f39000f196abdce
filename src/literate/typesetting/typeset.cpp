// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/typeset.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <system_error>

#include "literate/figures/draw.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/prose/references.hpp"
#include "literate/text/latex.hpp"
#include "literate/typesetting/latex_log.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// The files that LaTeX and latexmk wrote for themselves and read in the next run: .aux, .toc,
/// .fdb_latexmk, the log and the PDF.
///
/// A run that was interrupted or failed leaves them broken in ways that neither tool recovers from,
/// so they are kept only as a run that ended well left them. «as-left.sha256» tells: it is written
/// by keep() and removed by begin().
class LatexFolder {
 public:
  explicit LatexFolder(const TypesetOptions& options)
      : folder_(options.build_dir),
        stem_(fs::path(options.main_file).filename().replace_extension().string()),
        record_(folder_ / "as-left.sha256") {}

  /// Whether there are such files, and they are as the last run that ended well left them.
  bool is_as_left() const {
    return fs::is_regular_file(record_) && sys::read_file(record_) == digests();
  }

  /// Removes all of them, so that LaTeX begins from nothing. Throws sys::OutputError.
  void clear() const {
    begin();
    for (const std::string& file : files()) sys::remove_file(folder_ / file);
  }

  /// From now on until keep() the files are not to be trusted.
  void begin() const { sys::remove_file(record_); }
  void keep() const { sys::write_file_atomically(record_, digests()); }

 private:
  // Those that bear the document's name, and the .aux files of its parts. A folder that is the
  // author's own may hold sources of the same name.
  std::vector<std::string> files() const {
    static const std::set<std::string> sources = {".tex", ".bib", ".sty", ".cls", ".bst"};
    std::vector<std::string> files = sys::files_below(folder_);
    std::erase_if(files, [&](const std::string& file) {
      const bool is_made_for_it = file.starts_with(stem_ + ".") || file.ends_with(".aux");
      return !is_made_for_it || sources.contains(fs::path(file).extension().string()) ||
             file.starts_with("preamble/") || file.starts_with("at-width/");
    });
    return files;
  }

  std::string digests() const { return sys::record_text(sys::record_entries(folder_, files())); }

  fs::path folder_;
  std::string stem_;  // of the main file, which begins the names
  fs::path record_;
};

constexpr int latex_seconds = 600;  // for all passes; the slowest seen took 20

/// The last lines of what latexmk printed, for failures that are not in LaTeX's log.
std::string last_lines(std::string_view output) {
  const auto lines = sys::lines_of(output);
  const std::size_t n_shown = std::min<std::size_t>(lines.size(), 12);
  return fmt::format(
      "{}", fmt::join(lines.end() - static_cast<std::ptrdiff_t>(n_shown), lines.end(), "\n"));
}

/// Whether latexmk and what it runs made a whole PDF.
bool is_whole(const fs::path& pdf) {
  if (!fs::is_regular_file(pdf)) return false;
  const std::string text = sys::read_file(pdf);
  return text.starts_with("%PDF-") && sys::stripped(text).ends_with("%%EOF");
}

sys::ProcessResult run_latexmk(const TypesetOptions& options, const PreambleFormat& preamble,
                               const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"-norc",
                                     "-e",
                                     std::string(contents_decide_pl),
                                     options.engine == "lualatex" ? "-lualatex" : "-pdf",
                                     "-interaction=nonstopmode",
                                     "-halt-on-error",
                                     "-file-line-error",
                                     "-outdir=" + seen_from(options.source_dir, options.build_dir)};
  auto environment = latex_environment(options);
  if (preamble.is_usable) {
    environment["TEXFORMATS"] = seen_from(options.source_dir, preamble.folder) + ":";
    arguments.emplace_back("-pdflatex=pdflatex -fmt=preamble %O %S");
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.push_back(options.main_file);
  return sys::run({"latexmk", arguments, options.source_dir, environment,
                   sys::TimeLimit{fmt::format("LaTeX on {}", options.main_file), latex_seconds}});
}

/// When LaTeX last wrote its log; the earliest time if there is none.
fs::file_time_type time_of_log(const TypesetOptions& options) {
  std::error_code error;
  const auto time = fs::last_write_time(in_build_dir(options, ".log"), error);
  return error ? fs::file_time_type::min() : time;
}

/// Messages with the places at which the document's author can mend them.
std::vector<std::string> placed(std::vector<std::string> messages, const TypesetOptions& options) {
  for (std::string& message : messages) {
    message = with_place_of_use(message, options.source_dir, options.scripts);
  }
  return messages;
}

/// All messages in one error.
sys::ToolError failure(const std::vector<std::string>& messages, const TypesetOptions& options) {
  return sys::ToolError(fmt::format("{}", fmt::join(placed(messages, options), "\n")));
}

/// Throws the errors in LaTeX's log, or the last lines of latexmk if there are none.
[[noreturn]] void fail(const TypesetOptions& options, const std::string& output) {
  const auto text_of = [&](const char* extension) {
    const fs::path file = in_build_dir(options, extension);
    return fs::exists(file) ? sys::read_file(file) : std::string();
  };
  const std::string label = source_label(options.source_dir);
  std::vector<std::string> errors = latex_errors(text_of(".log"), label);
  std::ranges::move(bibtex_errors(text_of(".blg"), label), std::back_inserter(errors));
  if (errors.empty()) {
    throw sys::ToolError(
        fmt::format("latexmk failed for {}:\n{}", options.main_file, last_lines(output)));
  }
  throw failure(errors, options);
}

/// Calls visit(parts) for each line that LaTeX wrote to its .aux files and that matches.
template <typename Visit>
void for_each_told(const TypesetOptions& options, const sys::Pattern& pattern, Visit visit) {
  for (const std::string& file : sys::files_below(options.build_dir)) {
    if (!file.ends_with(".aux")) continue;
    const std::string text = sys::read_file(options.build_dir / file);
    for (const std::string_view line : sys::lines_of(text)) {
      if (const auto found = pattern.match_all_of(line)) visit(found->parts);
    }
  }
}

/// What each label stands for: «2 on page 3».
std::map<std::string, std::string> labels_of(const TypesetOptions& options) {
  static const sys::Pattern told(R"(\\newlabel\{([^{}]+)\}\{\{([^{}]*)\}\{([^{}]*)\}.*)");
  std::map<std::string, std::string> labels;
  for_each_told(options, told, [&](const auto& parts) {
    labels[std::string(parts[1])] = fmt::format("'{}' on page {}", parts[2], parts[3]);
  });
  return labels;
}

/// The error of a document that is another one after each pass, such as one that breaks a page
/// because a label stands at its top. One more pass tells which label it is.
sys::ToolError unsettled(const TypesetOptions& options, const PreambleFormat& preamble) {
  const auto before = labels_of(options);
  run_latexmk(options, preamble, {"-g", "-e", "$max_repeat = 1"});
  std::string causes;
  for (const auto& [label, place] : labels_of(options)) {
    const auto known = before.find(label);
    if (known == before.end() || known->second == place) continue;
    causes += fmt::format("\n  label '{}' is {} in one pass and {} in the next", label,
                          known->second, place);
  }
  if (causes.empty()) {
    causes = "\n  " + rerun_request(sys::read_file(in_build_dir(options, ".log")));
  }
  return sys::ToolError(fmt::format("{}: LaTeX asks for another run after each one{}",
                                    (options.source_dir / options.main_file).string(), causes));
}

/// The figures with a width.
std::set<FigureAtWidth> wanted_widths(const TypesetOptions& options) {
  static const sys::Pattern told(R"(\\LiterateWidth\s*\{([^{}]+)\}\{(\d+)\})");
  std::set<FigureAtWidth> figures;
  for_each_told(options, told, [&](const auto& parts) {
    figures.insert({std::string(parts[1]), std::stoll(std::string(parts[2]))});
  });
  return figures;
}

std::size_t draw_wanted(const TypesetOptions& options) {
  return draw_at_widths(options.generated_dir, at_width_dir(options), wanted_widths(options),
                        options.figures, options.scripts.filename().string());
}

/// Runs LaTeX until nothing that it reads changes by the run, and each figure is drawn at the width
/// that the document has for it.
void run_until_settled(const TypesetOptions& options, const PreambleFormat& preamble, bool is_new) {
  // The widths of the run before are those of this one, but for what its author changed.
  draw_wanted(options);
  constexpr int most_runs = 5;  // a width that depends on its own figure might never settle
  for (int n_runs = 1;; ++n_runs) {
    const auto time_before = time_of_log(options);
    const sys::ProcessResult result = run_latexmk(
        options, preamble, is_new ? std::vector<std::string>{"-g"} : std::vector<std::string>{});
    if (result.output.find(" needed too many passes") != std::string::npos) {
      throw unsettled(options, preamble);
    }
    if (result.exit_status != 0) fail(options, result.output);
    // latexmk believes an engine that does nothing and succeeds, and the PDF of the run before
    // would be published as the one of this.
    const bool is_run = result.output.find("\nRun number ") != std::string::npos;
    if (is_run && time_of_log(options) == time_before) {
      throw sys::ToolError(fmt::format("LaTeX on {} ended without an error, but did not write '{}'",
                                       options.main_file, in_build_dir(options, ".log").string()));
    }
    if (!is_whole(in_build_dir(options, ".pdf"))) {
      throw sys::ToolError(
          fmt::format("LaTeX on {} ended without an error, but '{}' is not a whole PDF",
                      options.main_file, in_build_dir(options, ".pdf").string()));
    }
    const bool asks_again = !rerun_request(sys::read_file(in_build_dir(options, ".log"))).empty();
    if (draw_wanted(options) == 0 && !asks_again) break;
    if (n_runs == most_runs && asks_again) throw unsettled(options, preamble);
    if (n_runs == most_runs) {
      throw sys::ToolError(fmt::format("{}: the widths of its figures do not settle",
                                       (options.source_dir / options.main_file).string()));
    }
    is_new = true;
  }
}

}  // namespace

Typeset typeset(const TypesetOptions& options) {
  std::error_code error;
  fs::create_directories(options.build_dir, error);
  if (error) {
    throw sys::OutputError(fmt::format("cannot make the folder '{}': {}",
                                       options.build_dir.string(), error.message()));
  }
  if (!fs::exists(options.source_dir / options.main_file)) {
    throw sys::OutputError(
        fmt::format("there is no '{}'", (options.source_dir / options.main_file).string()));
  }
  // \include writes a file of its own, and LaTeX makes no folder for it.
  for (const std::string& file : document_files(options.source_dir)) {
    fs::create_directories((options.build_dir / file).parent_path());
  }
  sys::find_tool(options.engine);
  const PreambleFormat preamble =
      options.engine == "pdflatex" ? keep_preamble(options) : PreambleFormat{};
  // latexmk does not notice a new date, although the document prints it.
  const bool is_new_date = sys::write_if_changed(options.build_dir / "source_date_epoch",
                                                 fmt::format("{}\n", options.source_date_epoch));
  const bool is_new = is_new_date || preamble.is_new;

  // Begin from what the last run left only if it ended well, and once from nothing before an error
  // is told, since what is left may be the cause of it.
  const LatexFolder folder(options);
  const bool is_from_nothing = !folder.is_as_left() || !was_made_here(options, options.build_dir);
  const auto begin_from_nothing = [&] {
    folder.clear();
    fs::remove_all(at_width_dir(options));  // one of these figures may be what LaTeX stopped at
  };
  if (is_from_nothing) begin_from_nothing();
  folder.begin();
  try {
    run_until_settled(options, preamble, is_new);
  } catch (const sys::ToolError&) {
    if (is_from_nothing) throw;
    begin_from_nothing();
    run_until_settled(options, preamble, true);
  }
  folder.keep();

  Typeset result{.drawn = keep_at_widths(at_width_dir(options), wanted_widths(options)),
                 .warnings = {}};
  std::vector<std::string> defects = latex_defects(sys::read_file(in_build_dir(options, ".log")),
                                                   source_label(options.source_dir));
  if (options.tolerates_overfull) {
    const auto is_error = [](const std::string& defect) { return !is_overfull_box(defect); };
    const auto tolerated = std::stable_partition(defects.begin(), defects.end(), is_error);
    result.warnings = placed({tolerated, defects.end()}, options);
    defects.erase(tolerated, defects.end());
  }
  if (!defects.empty()) throw failure(defects, options);
  require_read_within(options);
  sys::write_if_changed(options.output_pdf, sys::read_file(in_build_dir(options, ".pdf")));
  return result;
}

}  // namespace literate
