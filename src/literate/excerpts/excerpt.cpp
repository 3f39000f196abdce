// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {

std::string listing_language(std::string_view file) {
  // How a name ends, and its language.
  std::istringstream languages(R"(
.cpp [20]C++  .hpp [20]C++  .cc [20]C++  .h [20]C++  .c C  .m Octave  .py Python  .jl Julia
.R R  .r R  .f [77]Fortran  .f90 [95]Fortran  .f95 [95]Fortran  .f03 [03]Fortran
.f08 [08]Fortran  .java Java  .hs Haskell  .lua [5.3]Lua  .pl Perl  .rb Ruby  .sql SQL
.awk Awk  .gp Gnuplot  .sh bash  .bash bash  .tex [LaTeX]TeX  .sty [LaTeX]TeX  .cls [LaTeX]TeX
.html HTML  .xml XML  .json JSON  .toml TOML  .cmake CMake  CMakeLists.txt CMake
Makefile [gnu]make  .mk [gnu]make
)");
  for (std::string ending, language; languages >> ending >> language;) {
    if (file.ends_with(ending)) return language;
  }
  return "";
}

namespace fs = std::filesystem;
namespace {

/// Removes the indentation that all lines share, so that the listing starts at the margin.
std::string without_common_indentation(const std::string& text) {
  std::size_t indentation = std::numeric_limits<std::size_t>::max();
  for (const std::string_view line : sys::lines_of(text)) {
    const auto first = line.find_first_not_of(' ');
    if (first != std::string_view::npos) indentation = std::min(indentation, first);
  }
  std::string result;
  for (const std::string_view line : sys::lines_of(text)) {
    result.append(line.substr(std::min(indentation, line.size()))).append("\n");
  }
  return result;
}

}  // namespace

int last_line(const Excerpt& excerpt) {
  return excerpt.first_line + static_cast<int>(std::ranges::count(excerpt.text, '\n')) - 1;
}

void write_excerpt(const fs::path& folder, const Excerpt& excerpt) {
  sys::write_file_atomically(folder / (excerpt.name + ".txt"),
                             without_common_indentation(excerpt.text));
  sys::write_file_atomically(
      folder / (excerpt.name + ".tex"),
      fmt::format("\\LiterateListing{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", excerpt.name,
                  escape_latex_path(excerpt.file), excerpt.first_line, last_line(excerpt),
                  listing_language(excerpt.file)));
}

namespace {

struct Marker {
  bool begins = false;
  std::string name;
};

/// The text of a line that is a comment in one of the languages that papers are computed in.
std::optional<std::string_view> comment_in(std::string_view line) {
  using Signs = std::pair<std::string_view, std::string_view>;  // before and after the comment
  constexpr std::array<Signs, 9> signs{{{"//", ""},
                                        {"/*", "*/"},
                                        {"#", ""},
                                        {"%", ""},
                                        {"--", ""},
                                        {"!", ""},
                                        {";", ""},
                                        {"<!--", "-->"},
                                        {"(*", "*)"}}};
  std::string_view text = sys::stripped(line);
  for (const auto& [before, after] : signs) {
    if (!text.starts_with(before)) continue;
    text.remove_prefix(before.size());
    if (!after.empty() && text.ends_with(after)) text.remove_suffix(after.size());
    return sys::stripped(text);
  }
  return {};
}

/// Walks through the lines of one file and collects its excerpts.
class Finder {
 public:
  explicit Finder(const std::string& file) : file_(file) {}

  void read(std::string_view line) {
    ++line_;
    const auto marker = marker_in(line);
    if (marker && marker->begins) {
      begin(marker->name);
    } else if (marker) {
      end(marker->name);
    } else if (open_) {
      add(line);
    }
  }

  std::vector<Excerpt> finish() {
    if (open_) fail(begin_line_, fmt::format("excerpt '{}' has no end marker", open_->name));
    return std::move(excerpts_);
  }

 private:
  [[noreturn]] void fail(int line, std::string_view message) const {
    throw sys::SourceError(fmt::format("{}:{}: {}", file_, line, message));
  }

  std::optional<Marker> marker_in(std::string_view line) const {
    const auto comment = comment_in(line);
    if (!comment) return {};
    std::string_view rest = *comment;
    for (const std::string_view verb : {"begin", "end"}) {
      const std::string words = fmt::format("{} excerpt", verb);
      if (!rest.starts_with(words)) continue;
      rest.remove_prefix(words.size());
      const std::string_view name = rest.starts_with(':') ? sys::stripped(rest.substr(1)) : "";
      if (!is_file_name(name)) {
        fail(line_, fmt::format("a marker reads '{}: name', the name of letters, digits, '-', '_'",
                                words));
      }
      return Marker{verb == "begin", std::string(name)};
    }
    return {};
  }

  void begin(const std::string& name) {
    if (open_) {
      fail(line_, fmt::format("excerpt '{}' begins inside '{}' of line {}", name, open_->name,
                              begin_line_));
    }
    const auto [known, is_new] = begin_lines_.try_emplace(name, line_);
    if (!is_new) {
      fail(line_,
           fmt::format("excerpt '{}' is marked at {}:{} already", name, file_, known->second));
    }
    open_ = Excerpt{name, file_, 0, ""};
    begin_line_ = line_;
    text_end_ = 0;
  }

  void end(const std::string& name) {
    if (!open_) fail(line_, fmt::format("excerpt '{}' ends but has no begin marker", name));
    if (open_->name != name) {
      fail(line_,
           fmt::format("excerpt '{}' ends inside '{}' of line {}", name, open_->name, begin_line_));
    }
    if (open_->text.empty()) fail(begin_line_, fmt::format("excerpt '{}' is empty", name));
    open_->text.resize(text_end_);
    excerpts_.push_back(std::move(*open_));
    open_.reset();
  }

  void add(std::string_view line) {
    const bool is_blank = sys::stripped(line).empty();
    if (is_blank && open_->text.empty()) return;
    require_printable(line);
    if (open_->text.empty()) open_->first_line = line_;
    open_->text.append(line).append("\n");
    if (!is_blank) text_end_ = open_->text.size();
  }

  void require_printable(std::string_view line) const {
    while (!line.empty()) {
      const std::string_view character = sys::first_character(line).bytes;
      line.remove_prefix(character.size());
      const auto byte = static_cast<unsigned char>(character.front());
      if (character.size() > 1 && latex_of(character).empty()) {
        fail(line_,
             fmt::format("LaTeX has no mapping for '{}' in excerpt '{}'", character, open_->name));
      }
      if (character.size() == 1 && byte != '\t' && (byte < 0x20 || byte >= 0x7F)) {
        fail(line_,
             fmt::format("byte {:#04x} in excerpt '{}' is not UTF-8 text", byte, open_->name));
      }
    }
  }

  std::string file_;
  int line_ = 0;
  int begin_line_ = 0;
  std::optional<Excerpt> open_;
  std::size_t text_end_ = 0;  // the end of the last line in the open excerpt that is not blank
  std::map<std::string, int> begin_lines_;
  std::vector<Excerpt> excerpts_;
};

bool is_text(std::string_view bytes) {
  return bytes.find('\0') == std::string_view::npos;
}

/// The files of a folder that belong to the paper, or the file itself if it is one.
std::vector<std::string> files_of(const fs::path& source_root, const std::string& folder) {
  if (fs::is_regular_file(source_root / folder)) return {folder};
  if (!fs::is_directory(source_root / folder)) {
    throw sys::SourceError(fmt::format("{}: there is no such folder to take excerpts from",
                                       (source_root / folder).generic_string()));
  }
  std::vector<std::string> files = paper_sources(source_root / folder);
  for (std::string& file : files) file = fmt::format("{}/{}", folder, file);
  return files;
}

}  // namespace

std::vector<Excerpt> excerpts_of(std::string_view text, const std::string& file) {
  if (text.find(" excerpt") == text.npos) return {};  // no line can be a marker
  Finder finder(file);
  for (const std::string_view line : sys::lines_of(text)) finder.read(line);
  return finder.finish();
}

std::vector<Excerpt> find_excerpts(const fs::path& source_root,
                                   const std::vector<std::string>& folders) {
  std::map<std::string, Excerpt> by_name;
  for (const std::string& folder : folders) {
    for (const std::string& file : files_of(source_root, folder)) {
      const std::string text = sys::read_file(source_root / file);
      if (!is_text(text)) continue;
      for (Excerpt& excerpt : excerpts_of(text, file)) {
        const auto [known, is_new] = by_name.try_emplace(excerpt.name, excerpt);
        if (!is_new) {
          throw sys::SourceError(fmt::format("{}:{}: excerpt '{}' is marked at {}:{} already",
                                             excerpt.file, excerpt.first_line - 1, excerpt.name,
                                             known->second.file, known->second.first_line - 1));
        }
      }
    }
  }
  std::vector<Excerpt> excerpts;
  for (auto& [name, excerpt] : by_name) excerpts.push_back(std::move(excerpt));
  return excerpts;
}

std::string record_of(const std::vector<Excerpt>& excerpts) {
  sys::Record record;
  for (const Excerpt& excerpt : excerpts) {
    record.push_back({sys::sha256_of_text(fmt::format("{}\n{}", excerpt.first_line, excerpt.text)),
                      fmt::format("{}: excerpt '{}'", excerpt.file, excerpt.name)});
  }
  return sys::record_text(record);
}

void require_compiled(const std::vector<Excerpt>& excerpts, std::string_view compiled) {
  const std::string record = record_of(excerpts);
  const auto now = sys::lines_of(record), then = sys::lines_of(compiled);
  const auto require_same = [](const auto& lines, const auto& others) {
    for (const std::string_view line : lines) {
      if (std::ranges::find(others, line) != others.end()) continue;
      throw sys::SourceError(fmt::format("{} is not what this program was compiled from: rebuild",
                                         line.substr(line.find("  ") + 2)));
    }
  };
  require_same(now, then);
  require_same(then, now);
}

std::vector<std::string> paper_sources(const std::filesystem::path& folder) {
  constexpr std::string_view list = "/CMakeLists.txt";
  std::vector<std::string> files = sys::files_below(folder);
  std::vector<std::string> others;
  for (const std::string& file : files) {
    if (!file.ends_with(list)) continue;
    if (sys::read_file(folder / file).find("\nliterate_add_paper(") == std::string::npos) continue;
    others.push_back(file.substr(0, file.size() - list.size() + 1));
  }
  std::erase_if(files, [&](const std::string& file) {
    return std::ranges::any_of(others, [&](const auto& other) { return file.starts_with(other); });
  });
  return files;
}

}  // namespace literate
