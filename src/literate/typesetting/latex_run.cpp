// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/typeset.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "literate/prose/document_files.hpp"
#include "literate/prose/tex_scanner.hpp"

#include "literate/text/latex.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;

std::string seen_from(const fs::path& source_dir, const fs::path& path) {
  const fs::path from = fs::weakly_canonical(fs::absolute(source_dir));
  return fs::weakly_canonical(fs::absolute(path)).lexically_relative(from).generic_string();
}

std::map<std::string, std::string> latex_environment(const TypesetOptions& options) {
  std::string inputs = ".:" + seen_from(options.source_dir, options.generated_dir) + ":";
  if (!options.repository_dir.empty()) {
    inputs += seen_from(options.source_dir, options.repository_dir) + ":";
  }
  inputs += seen_from(options.source_dir, at_width_dir(options)) + ":";
  // TEXMFHOME, the folder of the user's own packages, is set to one that does not exist.
  return {{"SOURCE_DATE_EPOCH", fmt::format("{}", options.source_date_epoch)},
          {"FORCE_SOURCE_DATE", "1"},
          {"TZ", "UTC"},
          {"LC_ALL", "C"},
          {"max_print_line", "1000"},
          {"TEXMFHOME", "no-texmf-of-the-user"},
          {"TEXINPUTS", inputs}};
}

fs::path in_build_dir(const TypesetOptions& options, const char* extension) {
  return options.build_dir / fs::path(options.main_file).filename().replace_extension(extension);
}

namespace {

/// What LaTeX's recorder in a folder says; empty if it left nothing there.
std::string recorded(const TypesetOptions& options, const fs::path& at) {
  const fs::path recorder = at / fs::path(options.main_file).filename().replace_extension(".fls");
  return fs::is_regular_file(recorder) ? sys::read_file(recorder) : "";
}

}  // namespace

bool was_made_here(const TypesetOptions& options, const fs::path& at) {
  const fs::path source = fs::weakly_canonical(fs::absolute(options.source_dir));
  const fs::path made = fs::weakly_canonical(fs::absolute(at));
  const std::string text = recorded(options, at);
  bool is_source = false, is_output = false;
  for (const std::string_view line : sys::lines_of(text)) {
    if (line.starts_with("PWD ")) is_source = fs::weakly_canonical(line.substr(4)) == source;
    if (line.starts_with("OUTPUT ")) {
      is_output = is_output || sys::name_below(made, fs::weakly_canonical(source / line.substr(7)));
    }
  }
  return is_source && is_output;
}

std::set<std::string> files_read(const TypesetOptions& options, const fs::path& at) {
  std::set<std::string> files;
  const std::string text = recorded(options, at);
  for (std::string_view line : sys::lines_of(text)) {
    if (!line.starts_with("INPUT ")) continue;
    line.remove_prefix(6);
    if (line.starts_with("./")) line.remove_prefix(2);
    files.emplace(line);
  }
  return files;
}

namespace {

fs::path preamble_dir(const TypesetOptions& options) {
  return options.build_dir / "preamble";
}

/// The folders of TeX's own files.
std::vector<fs::path> tex_folders() {
  const sys::ProcessResult said =
      sys::run({.program = "kpsewhich", .arguments = {"-expand-path=$TEXMF"}});
  std::vector<fs::path> folders;
  for (const std::string& name : sys::split(said.output, ':')) {
    folders.push_back(fs::weakly_canonical(sys::stripped(name)));
  }
  return folders;
}

/// Fonts are no files of an author, and may lie elsewhere.
bool is_authors(const fs::path& file) {
  static const std::set<std::string> endings = {".tex", ".sty", ".cls", ".def",  ".cfg",
                                                ".pdf", ".png", ".jpg", ".jpeg", ".csv",
                                                ".dat", ".txt", ".cpp", ".hpp",  ".py"};
  return endings.contains(file.extension().string());
}

/// The message for a file that was read from elsewhere, at the place that names it.
std::string stray(const TypesetOptions& options, const std::string& file) {
  const std::string label = source_label(options.source_dir);
  const std::string message = fmt::format(
      "'{}' lies outside the folder of the document, where no build would see it change; move it "
      "to '{}', or a program that the document quotes to a folder of sources",
      file, label);
  const std::string name = fs::path(file).replace_extension().generic_string();
  for (const DocumentFile& part : read_document(options.source_dir)) {
    if (const auto at = part.text.find(name); at != part.text.npos) {
      const auto [line, column] = place_in(part.text, std::string_view(part.text).substr(at));
      return fmt::format("{}: {}", part.at(line, column), message);
    }
  }
  return fmt::format("{}: {}", label, message);
}

}  // namespace

void require_read_within(const TypesetOptions& options) {
  std::vector<fs::path> known = tex_folders();
  for (const fs::path& folder : {options.source_dir, options.generated_dir, options.build_dir,
                                 options.repository_dir, at_width_dir(options)}) {
    if (!folder.empty()) known.push_back(fs::weakly_canonical(fs::absolute(folder)));
  }
  std::set<std::string> files = files_read(options, options.build_dir);
  // A format that came with its folder from elsewhere names files of there.
  if (was_made_here(options, preamble_dir(options))) {
    files.merge(files_read(options, preamble_dir(options)));
  }
  std::vector<std::string> errors;
  for (const std::string& file : files) {
    const fs::path path = fs::weakly_canonical(fs::absolute(options.source_dir) / file);
    const bool is_known = std::ranges::any_of(
        known, [&](const fs::path& folder) { return sys::name_below(folder, path).has_value(); });
    if (!is_known && is_authors(file)) errors.push_back(stray(options, file));
  }
  if (!errors.empty()) throw sys::InputError(fmt::format("{}", fmt::join(errors, "\n")));
}

namespace {

constexpr std::string_view format_record = "preamble.sha256";
constexpr std::string_view no_format = "-";
constexpr std::string_view file_prefix = "file ";
constexpr int preamble_seconds = 300;  // the slowest seen took 3

/// Where the body begins, and the text of the main file up to there.
struct Preamble {
  int body_line = 0;
  std::string text;
};

std::optional<Preamble> preamble_of(const TypesetOptions& options) {
  const std::string text = sys::read_file(options.source_dir / options.main_file);
  Preamble preamble;
  for (const std::string_view line : sys::lines_of(text)) {
    ++preamble.body_line;
    preamble.text.append(line).append("\n");
    if (sys::stripped(line).starts_with("\\begin{document}")) return preamble;
  }
  return std::nullopt;
}

/// The names of the TeX files right in a folder: one more could be read instead of another.
std::string tex_files_in(const fs::path& folder) {
  static const std::set<std::string> endings = {".tex", ".sty", ".cls", ".clo", ".cfg",
                                                ".def", ".fd",  ".ldf", ".map", ".enc"};
  std::set<std::string> names;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (endings.contains(entry.path().extension())) names.insert(entry.path().filename());
    }
  }
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  return sys::sha256_of_text(text);
}

/// A format in its folder, and the record of what it was made from.
class PreambleCache {
 public:
  PreambleCache(const TypesetOptions& options, Preamble preamble)
      : options_(&options),
        preamble_(std::move(preamble)),
        folder_(preamble_dir(options)),
        stem_(fs::path(options.main_file).filename().replace_extension().string()) {}

  PreambleFormat up_to_date() const {
    const std::string known = fs::is_regular_file(folder_ / format_record)
                                  ? sys::read_file(folder_ / format_record)
                                  : std::string();
    if (!known.empty() && known == record(files_named_in(known), has_format(known))) {
      return {folder_, has_format(known), false};
    }
    fs::create_directories(folder_);
    fs::remove(folder_ / format_record);
    const bool is_usable = dump();
    // The record is written last, so that an interruption leaves none.
    sys::write_file_atomically(folder_ / format_record, record(files(), is_usable));
    return {folder_, is_usable, true};
  }

 private:
  /// A line «SHA-256  name» for the format and for all that it depends on.
  std::string record(const std::set<std::string>& files, bool is_usable) const {
    const std::string format =
        is_usable ? sys::record_entry(folder_, "preamble.fmt").digest : std::string(no_format);
    sys::Record record = {{format, "format"},
                          {sys::sha256_of_text(keep_preamble_tex), "engine"},
                          {fmt::format("{}", options_->source_date_epoch), "date"},
                          {sys::sha256_of_text(preamble_.text), "preamble"},
                          {tex_files_in(options_->source_dir), "document"},
                          {tex_files_in(options_->generated_dir), "generated"}};
    for (const std::string& file : files) {
      record.push_back(
          {sys::record_entry(options_->source_dir, file).digest, std::string(file_prefix) + file});
    }
    return sys::record_text(record);
  }

  static bool has_format(const std::string& known) { return !known.starts_with(no_format); }

  static std::set<std::string> files_named_in(const std::string& known) {
    std::set<std::string> files;
    for (const auto& [digest, name] : sys::parse_record(known).value_or(sys::Record())) {
      if (name.starts_with(file_prefix)) files.insert(name.substr(file_prefix.size()));
    }
    return files;
  }

  std::set<std::string> files() const {
    std::set<std::string> files = files_read(*options_, folder_);
    std::erase_if(files, [this](const std::string& file) {
      return file == options_->main_file || file.ends_with("/keep_preamble.tex");
    });
    return files;
  }

  /// Runs iniTeX up to \begin{document}; returns whether that made a format which can be kept.
  bool dump() const {
    sys::write_file_atomically(folder_ / "keep_preamble.tex", keep_preamble_tex);
    const std::string build = seen_from(options_->source_dir, options_->build_dir);
    auto environment = latex_environment(*options_);
    // What earlier passes wrote is found as in a pass, so that reading it is noticed.
    environment["TEXINPUTS"] += fmt::format("{}/preamble:{}:", build, build);
    const sys::ProcessResult result = sys::run(
        {"pdflatex",
         {"-ini", "-interaction=nonstopmode", "-halt-on-error", "-file-line-error", "-recorder",
          "-jobname=" + stem_, fmt::format("-output-directory={}/preamble", build), "&pdflatex",
          fmt::format("\\def\\LiterateBodyLine{{{}}}\\csname @@input\\endcsname "
                      "keep_preamble.tex \\csname @@input\\endcsname \"{}\"",
                      preamble_.body_line, options_->main_file)},
         options_->source_dir,
         environment,
         sys::TimeLimit{fmt::format("LaTeX on the preamble of {}", options_->main_file),
                        preamble_seconds}});
    const fs::path made = folder_ / (stem_ + ".fmt");
    if (result.exit_status != 0 || !fs::is_regular_file(made)) return false;
    for (const std::string& file : files()) {
      if (file.starts_with(build + "/" + stem_ + ".")) return false;
    }
    fs::rename(made, folder_ / "preamble.fmt");
    return true;
  }

  const TypesetOptions* options_;
  Preamble preamble_;
  fs::path folder_;
  std::string stem_;
};

}  // namespace

PreambleFormat keep_preamble(const TypesetOptions& options) {
  const auto preamble = preamble_of(options);
  if (!preamble) return {};
  return PreambleCache(options, *preamble).up_to_date();
}

}  // namespace literate
