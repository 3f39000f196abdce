// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/leaks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "course/sandbox/scratch_folder.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t significant_characters = 10;
constexpr std::size_t telling_lines = 3;

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

std::string without_space(std::string_view text) {
  std::string dense(text);
  std::erase_if(dense, is_space);
  return dense;
}

std::string public_text(const Project& project) {
  std::string text;
  for (const auto& [name, content] : texts(project, Edition::handout)) {
    text += without_space(content) + '\0';
  }
  return text;
}

bool is_telling(const std::string& dense, const std::string& known) {
  return dense.size() >= significant_characters && known.find(dense) == std::string::npos;
}

bool is_word(char c) {
  return sys::is_alphanumeric(c) || c == '_' || c == '-';
}

bool has_word(std::string_view text, std::string_view word) {
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const auto end = at + word.size();
    const bool begins = at == 0 || !is_word(text[at - 1]);
    if (begins && (end == text.size() || !is_word(text[end]))) return true;
  }
  return false;
}

// Joins the groups of three digits between which typeset numbers have thin spaces.
std::string without_thin_spaces(std::string_view text) {
  static const sys::Pattern between_digits("([0-9])(?:\u2009| )(?=[0-9])");
  return between_digits.replaced_in(text, "$1");
}

/// Whether a line is an entry of a PDF's table of its own objects, "0000000017 00000 n".
bool is_entry_of_table(std::string_view line) {
  constexpr std::size_t length = 18;
  static const sys::Pattern form(R"(\d{10} \d{5} [nf])");
  return form.is_all_of(line.substr(0, length));
}

/// A PDF without the numbers that say where in the file something stands. By chance any of them has
/// the digits of an expected value.
std::string without_places(std::string_view pdf) {
  std::string rest;
  bool is_place = false;
  for (const std::string_view line : sys::lines_of(pdf)) {
    if (!is_place && !is_entry_of_table(line)) rest.append(line).append("\n");
    is_place = line.starts_with("startxref");
  }
  return rest;
}

std::string output_of(const sys::Command& command, const fs::path& file) {
  const sys::ProcessResult result = sys::run(command);
  if (result.exit_status == 0) return result.output;
  throw sys::ToolError(fmt::format("{} cannot read '{}': {}", command.program, file.string(),
                                   result.output.substr(0, result.output.find('\n'))));
}

/// The project's own headers that a source includes, "folder/name", and the sources beside them.
std::vector<std::string> included_files(const fs::path& file) {
  std::vector<std::string> included;
  const std::string text = sys::read_file(file);
  for (const std::string_view line : sys::lines_of(text)) {
    constexpr std::string_view include = "#include \"";
    if (!line.starts_with(include)) continue;
    const fs::path name = line.substr(include.size(), line.rfind('"') - include.size());
    included.push_back(name.string());
    included.push_back(fs::path(name).replace_extension(".cpp").string());
  }
  return included;
}

/// The folders of `src` from which the files include, directly or indirectly.
std::set<std::string> included_folders(const fs::path& src, const std::vector<fs::path>& files) {
  std::set<std::string> folders;
  std::set<fs::path> seen;
  std::vector<fs::path> waiting = files;
  while (!waiting.empty()) {
    const fs::path file = waiting.back();
    waiting.pop_back();
    if (!fs::is_regular_file(file) || !seen.insert(file).second) continue;
    for (const std::string& name : included_files(file)) {
      const std::string folder = fs::path(name).begin()->string();
      const bool is_shared = folder == "assignment" || folder == "course" || folder == "numerics";
      if (is_shared || !fs::is_directory(src / folder)) continue;
      folders.insert(folder);
      waiting.push_back(src / name);
    }
  }
  return folders;
}

/// Searches files and the files packed in them.
class Search {
 public:
  explicit Search(const Secrets& secrets) : secrets_(secrets) {}

  // Searches all files of a folder, which are shown as `shown` and their path.
  void folder(const fs::path& folder, const std::string& shown) {
    for (const std::string& name : sys::files_below(folder)) file(folder / name, shown + name);
  }

  void file(const fs::path& file, const std::string& shown);

  std::vector<std::string> take() && { return std::move(found_); }

 private:
  void text(std::string_view text, const std::string& shown);
  void words(std::string_view text, const std::string& shown);
  void numbers(std::string_view text, const std::string& shown);
  void pdf(const fs::path& file, const std::string& shown);
  void report(const std::string& shown, const std::string& what);

  const Secrets& secrets_;
  std::vector<std::string> found_;
  std::set<std::string> known_;
};

void Search::report(const std::string& shown, const std::string& what) {
  std::string line = fmt::format("{} holds {}", shown, what);
  if (known_.insert(line).second) found_.push_back(std::move(line));
}

void Search::text(std::string_view text, const std::string& shown) {
  words(text, shown);
  numbers(text, shown);
}

void Search::words(std::string_view text, const std::string& shown) {
  const std::string dense = without_space(text);
  for (const Secret& line : secrets_.lines) {
    if (dense.find(line.text) != std::string::npos) report(shown, line.what);
  }
  for (const Secret& word : secrets_.words) {
    if (has_word(text, word.text)) report(shown, word.what);
  }
}

void Search::numbers(std::string_view text, const std::string& shown) {
  for (const std::string& number : secrets_.numbers.printed_in(text)) {
    report(shown, fmt::format("the expected value {}", number));
  }
}

void Search::pdf(const fs::path& file, const std::string& shown) {
  const fs::path absolute = fs::absolute(file);
  const std::string printed = output_of(
      {.program = "pdftotext", .arguments = {"-enc", "UTF-8", absolute.string(), "-"}}, file);
  text(printed, shown);
  numbers(without_thin_spaces(printed), shown);
  const ScratchFolder attachments;
  output_of({.program = "pdfdetach",
             .arguments = {"-saveall", "-o", attachments.path().string(), absolute.string()}},
            file);
  folder(attachments.path(), shown + ": ");
}

void Search::file(const fs::path& file, const std::string& shown) {
  const std::string bytes = sys::read_file(file);
  const bool is_pdf = bytes.starts_with("%PDF");
  words(bytes, shown);
  numbers(is_pdf ? without_places(bytes) : bytes, shown);
  text(shown, shown);
  if (secrets_.numbers.stored_in(bytes)) report(shown, "an expected value as a double's bytes");
  if (is_pdf) return pdf(file, shown);
  if (bytes.starts_with("PK\x03\x04")) {
    const ScratchFolder unpacked;
    unpack_zip(file, unpacked.path());
    return folder(unpacked.path(), shown + ": ");
  }
  for (const char* kind : {".gz", ".tgz", ".xz", ".bz2", ".zst", ".7z", ".rar", ".zip"}) {
    if (shown.ends_with(kind))
      report(shown, "what cannot be searched: it is an archive of an unknown kind");
  }
}

}  // namespace

Secrets secrets_of(const Assignment& assignment, const Project& project,
                   const std::vector<fs::path>& files, const std::vector<double>& expected_values) {
  Secrets secrets;
  const std::string known = public_text(project);
  const auto add_line = [&](const fs::path& file, int line, std::string_view text) {
    const std::string dense = without_space(text);
    if (!is_telling(dense, known)) return;
    secrets.lines.push_back({fmt::format("the line {}:{}", file.string(), line), dense});
  };
  for (const auto& [name, file] : project) {
    for (const SecretLine& line : file.text.secrets) add_line(file.origin, line.line, line.text);
    for (const std::string& region : file.text.hidden_regions) {
      secrets.words.push_back({fmt::format("the name of the hidden tests \"{}\"", region), region});
    }
  }
  for (const fs::path& file : files) {
    const std::string text = sys::read_file(file);
    int number = 0;
    for (const std::string_view line : sys::lines_of(text)) add_line(file, ++number, line);
    const std::string name = file.stem().string();
    secrets.words.push_back({fmt::format("the name of {}", file.string()), name});
  }
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& check : exercise.checks) {
      if (check.visibility != Visibility::hidden) continue;
      secrets.words.push_back({fmt::format("the id of the hidden check {}", check.id), check.id});
    }
  }
  secrets.numbers = SecretNumbers(expected_values);
  return secrets;
}

std::vector<std::string> published_solutions(const Project& project) {
  const std::string known = public_text(project);
  std::vector<std::string> published;
  for (const auto& [name, file] : project) {
    std::map<int, std::pair<std::size_t, std::size_t>> lines;  // that count, and are secret
    for (const SecretLine& line : file.text.secrets) {
      const std::string dense = without_space(line.text);
      if (dense.size() < significant_characters) continue;
      auto& [n_lines, n_secret] = lines[line.region];
      ++n_lines;
      if (is_telling(dense, known)) ++n_secret;
    }
    for (const auto& [region, counts] : lines) {
      if (counts.first < telling_lines || counts.second > 0) continue;
      published.push_back(fmt::format("{}:{}: all of this region also stands in the public part",
                                      file.origin.string(), region));
    }
  }
  return published;
}

std::vector<std::string> published_references(const Assignment& assignment, const fs::path& source,
                                              const std::vector<fs::path>& files) {
  const std::set<std::string> folders = included_folders(source / "src", files);
  std::vector<std::string> published;
  for (const std::string& provided : assignment.provided) {
    const fs::path file = source / "src" / provided;
    const bool is_secret = std::ranges::any_of(files, [&](const fs::path& secret) {
      return fs::absolute(secret).lexically_normal() == fs::absolute(file).lexically_normal();
    });
    if (!is_secret && !folders.contains(fs::path(provided).begin()->string())) continue;
    published.push_back(fmt::format("{}: provided: src/{} belongs to what the hidden checks {}",
                                    (assignment.folder / "assignment.toml").string(), provided,
                                    is_secret ? "are made of" : "compare with"));
  }
  return published;
}

std::vector<std::string> leaks(const Secrets& secrets, const fs::path& place) {
  Search search(secrets);
  if (fs::is_directory(place)) {
    search.folder(place, "");
  } else {
    search.file(place, place.filename().string());
  }
  return std::move(search).take();
}

}  // namespace course
