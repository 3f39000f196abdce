// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/gnuplot.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr int figure_seconds = 300;  // the slowest seen took 3

/// Overwrites the creation date of a PDF with a fixed one of the same length, because cairo writes
/// the present second whatever SOURCE_DATE_EPOCH says. cairo 1.18 hides it in a compressed stream
/// of objects, which qpdf takes apart.
void fix_creation_date(const fs::path& file) {
  constexpr std::string_view key = "/CreationDate (D:";
  constexpr std::string_view zero = "19700101000000";
  std::string pdf = sys::read_file(file);
  const bool is_whole = pdf.ends_with("%%EOF\n");  // half of one is told by who checks the figure
  if (is_whole && pdf.find("/ObjStm") != std::string::npos) {
    const sys::ProcessResult result = sys::run(
        {.program = "qpdf",
         .arguments = {"--object-streams=disable", "--static-id", "--replace-input", file.string()},
         .environment = {{"LC_ALL", "C.UTF-8"}}});
    if (result.exit_status != 0) {
      throw sys::ToolError(fmt::format("qpdf cannot read '{}': {}", file.string(), result.output));
    }
    pdf = sys::read_file(file);
  }
  const auto at = pdf.rfind(key);
  if (at == std::string::npos) return;
  const auto digits = at + key.size();
  if (pdf.find_first_not_of("0123456789", digits) != digits + zero.size()) return;
  pdf.replace(digits, zero.size(), zero);
  sys::write_file_atomically(file, pdf);
}

}  // namespace

sys::ProcessResult run_gnuplot(const fs::path& folder, const std::string& name,
                               const std::string& settings) {
  std::vector<std::string> arguments{"--default-settings"};
  if (!settings.empty()) arguments.insert(arguments.end(), {"-e", settings});
  arguments.push_back(name + ".gp");
  // With default settings gnuplot does not read the user's ~/.gnuplot. Its handler of an interrupt
  // calls what no handler may call, so that some of its runs would wait for a lock for ever.
  sys::ProcessResult result =
      sys::run({.program = "gnuplot",
                .arguments = arguments,
                .working_directory = folder,
                .environment = {{"LC_ALL", "C.UTF-8"}, {"TZ", "UTC"}, {"SOURCE_DATE_EPOCH", "0"}},
                .limit = {fmt::format("figure '{}'", name), figure_seconds},
                .ends_with_caller = true});
  const fs::path pdf = folder / (name + ".pdf");
  if (fs::is_regular_file(pdf)) fix_creation_date(pdf);
  return result;
}

std::vector<std::string> computed_files(const fs::path& folder, const std::string& name) {
  std::vector<std::string> files = sys::files_below(folder);
  std::erase_if(files, [&](const std::string& file) {
    return file != name + ".gp" && !file.ends_with(".csv");
  });
  return files;
}

void copy_computed(const fs::path& folder, const std::string& name, const fs::path& copy) {
  fs::create_directories(copy);
  for (const std::string& file : computed_files(folder, name)) {
    fs::copy_file(folder / file, copy / file);
  }
}

namespace {

/// What gnuplot says about a line of a script.
struct Message {
  std::string place;  ///< «figures/name.gp:12»
  std::string text;
};

/// gnuplot names the last line of a command that a backslash continues; this is its first.
std::size_t first_line_of_command(const fs::path& script, std::size_t last) {
  const std::string text = sys::read_file(script);
  const auto lines = sys::lines_of(text);
  std::size_t first = last;
  while (first > 1 && first <= lines.size() && lines[first - 2].ends_with('\\')) --first;
  return first;
}

std::string place_in(const ScriptRun& run, std::string_view file, std::string_view line) {
  const bool is_style = file == "../style.gp";
  if (file != "script.gp" && !is_style) return fmt::format("{}:{}", file, line);
  const std::size_t last = std::stoul(std::string(line));
  return fmt::format("{}/{}.gp:{}", run.label, is_style ? "style" : run.name,
                     first_line_of_command(run.folder / file, last));
}

/// The first «"script" line N: message».
std::optional<Message> first_message(const ScriptRun& run, std::string_view output) {
  static const sys::Pattern told(R"re("([^"\n]+\.gp)" line (\d+): (?:warning: )?([^\n]+))re");
  const auto found = told.find_in(output);
  if (!found) return std::nullopt;
  return Message{place_in(run, found->parts[1], found->parts[2]), std::string(found->parts[3])};
}

/// The variables that the program set, as name.gp lists them.
std::vector<std::string> registered_names(const ScriptRun& run) {
  static const sys::Pattern assignment("([A-Za-z_][A-Za-z0-9_]*) = .*");
  const std::string prelude = sys::read_file(run.folder / (run.name + ".gp"));
  std::vector<std::string> names;
  for (const std::string_view line : sys::lines_of(prelude)) {
    if (const auto found = assignment.match_all_of(line)) names.emplace_back(found->parts[1]);
  }
  return names;
}

std::string registration(const ScriptRun& run) {
  return fmt::format("figure '{}' is registered at {}", run.name, run.place);
}

/// Throws if a message tells of something that the program did not register.
void require_registered(const ScriptRun& run, const Message& message) {
  static const sys::Pattern variable(R"(undefined variable: (\S+))");
  static const sys::Pattern column(R"re(no column with header "([^"]*)")re");
  static const sys::Pattern file(R"re(annot find or open file "([^"]*)")re");
  if (const auto found = variable.find_in(message.text)) {
    const auto names = registered_names(run);
    throw sys::InputError(fmt::format(
        "{}: '{}' is neither defined nor registered; {} with {}", message.place, found->parts[1],
        registration(run), names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", "))));
  }
  if (const auto found = column.find_in(message.text)) {
    throw sys::InputError(fmt::format("{}: the data have no column '{}'; {}", message.place,
                                      found->parts[1], registration(run)));
  }
  if (const auto found = file.find_in(message.text)) {
    throw sys::InputError(fmt::format("{}: there are no data '{}'; {}", message.place,
                                      found->parts[1], registration(run)));
  }
}

/// Refuses half a file, which gnuplot leaves when it is ended or the disk is full, sometimes with
/// status 0.
void require_whole(const ScriptRun& run, const std::string& script, const std::string& extension,
                   std::string_view begins, std::string_view ends) {
  const std::string text = sys::read_file(run.folder / (run.name + extension));
  if (text.starts_with(begins) && sys::stripped(text).ends_with(ends)) return;
  throw sys::ToolError(fmt::format(
      "{}: gnuplot ended without an error, but {} is not whole: it does not end with {} ({})",
      script, run.name + extension, ends, registration(run)));
}

/// The statements of a script with the lines on which they begin; a backslash continues a line.
std::vector<std::pair<int, std::string>> statements_of(std::string_view script) {
  std::vector<std::pair<int, std::string>> statements;
  int number = 0;
  bool continues = false;
  for (const std::string_view line : sys::lines_of(script)) {
    ++number;
    if (!continues) statements.emplace_back(number, "");
    continues = line.ends_with('\\');
    statements.back().second += line.substr(0, line.size() - (continues ? 1 : 0));
  }
  return statements;
}

/// The file that a statement plots by its name; empty for none. Registered data have names of their
/// own, and «», «+», «++» and «-» are no files.
std::string plotted_file(const std::string& statement) {
  static const sys::Pattern plots(R"re((?:^|[;{)])\s*(?:s?p(?:l(?:ot?)?)?|rep\w*|sta\w*)\b\s*)re");
  static const sys::Pattern source(
      R"re((?:^|,)\s*(?:for\s*\[[^\]]*\]\s*|\[[^\]]*\]\s*)*(["'](?!(?:\+\+?|-)?["'])[^"']+["'])\s*)re"
      R"re((?:$|[,;#]|(?:using|u|with|w|title|t|notitle|every|index|matrix|binary|smooth|skip|axes|l[cstw])\b))re");
  const auto plotted = plots.find_in(statement);
  if (!plotted) return "";
  const auto found = source.find_in(plotted->rest);
  return found ? std::string(found->parts[1]) : "";
}

}  // namespace

void require_draws_only(std::string_view script, const std::string& file) {
  static const sys::Pattern forbidden(
      R"re((?:^|;)\s*(set\s+ou?t?p?u?t?\b|set\s+term\w*|set\s+print|set\s+table\s+['"]|save\b|system\b|shell\b|load\b|call\b|cd\b|!)|(system\s*\(|`))re");
  int number = 0;
  for (const std::string_view line : sys::lines_of(script)) {
    ++number;
    if (sys::stripped(line).starts_with("#")) continue;
    const auto found = forbidden.find_in(line);
    if (!found) continue;
    throw sys::InputError(fmt::format(
        "{}:{}: '{}' has no place in a figure's script: it draws from its data, to its own output",
        file, number, found->parts[1].empty() ? found->parts[2] : found->parts[1]));
  }
  for (const auto& [line, statement] : statements_of(script)) {
    const std::string name = plotted_file(statement);
    if (name.empty()) continue;
    throw sys::InputError(fmt::format(
        "{}:{}: {} is plotted from a file, and a figure draws from its registered data: give them "
        "to document.figure()",
        file, line, name));
  }
}

void require_drawn_well(const ScriptRun& run, const sys::ProcessResult& result) {
  if (const auto message = first_message(run, result.output)) {
    require_registered(run, *message);
    throw sys::ToolError(
        fmt::format("{}: gnuplot: {} ({})", message->place, message->text, registration(run)));
  }
  const std::string script = fmt::format("{}/{}.gp", run.label, run.name);
  if (result.exit_status != 0) {
    const std::string said = sys::one_line(result.output);
    throw sys::ToolError(fmt::format("{}: gnuplot ended with {}{}{} ({})", script,
                                     sys::end_of(result), said.empty() ? " and said nothing" : ": ",
                                     said, registration(run)));
  }
  for (const std::string extension : {".tex", ".pdf"}) {
    const fs::path drawing = run.folder / (run.name + extension);
    if (fs::is_regular_file(drawing) && fs::file_size(drawing) > 0) continue;
    throw sys::ToolError(fmt::format("{}: gnuplot drew nothing: {} is missing or empty ({})",
                                     script, drawing.filename().string(), registration(run)));
  }
  require_whole(run, script, ".pdf", "%PDF-", "%%EOF");
  require_whole(run, script, ".tex", "", "\\endgroup");
  const std::vector<std::string> own = {run.name + ".gp", run.name + ".pdf", run.name + ".tex",
                                        "script.gp"};
  for (const std::string& file : sys::files_below(run.folder)) {
    if (file.ends_with(".csv") || std::ranges::find(own, file) != own.end()) continue;
    throw sys::InputError(fmt::format("{}: the script wrote a file of its own, '{}'; {}", script,
                                      file, registration(run)));
  }
}

}  // namespace literate
