// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/latex_log.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "literate/text/characters.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

/// Puts the label before the name of a file of the document; leaves other names as they are.
std::string labelled(std::string_view file, std::string_view label) {
  if (file.starts_with("./")) file.remove_prefix(2);
  if (file.starts_with('/') || file.starts_with("../")) return std::string(file);
  return fmt::format("{}/{}", label, file);
}

/// Whether a log line reads «file:line: message» (and not «LaTeX Warning: …» or the like).
bool is_error(std::string_view line) {
  for (auto colon = line.find(':'); colon != std::string_view::npos;
       colon = line.find(':', colon + 1)) {
    const auto end = std::find_if_not(line.begin() + static_cast<std::ptrdiff_t>(colon) + 1,
                                      line.end(), is_digit);
    const auto n_digits = static_cast<std::size_t>(end - line.begin()) - colon - 1;
    if (colon > 0 && n_digits > 0 && end != line.end() && *end == ':') return true;
  }
  return false;
}

/// Whether a log line is an error that names no file: «! message», «!pdfTeX error: …».
bool is_bare_error(std::string_view line) {
  return line.starts_with("! ") || line.starts_with("!pdfTeX error") ||
         line.starts_with("!LuaTeX error");
}

/// What TeX had just read when it stopped, from a log line «<recently read> \foo»; empty for
/// another line. It is the command at fault where that stands in a macro or in a figure, and so not
/// at the end of the line «l.12 …».
std::string_view just_read(std::string_view line) {
  const auto end = line.find("> ");
  if (!line.starts_with('<') || line.starts_with("<*>") || end == line.npos) return {};
  return sys::stripped(line.substr(end + 2));
}

/// Whether a log line reads «file:line: Emergency stop.»
bool is_emergency_stop(std::string_view line) {
  return is_error(line) && line.ends_with(": Emergency stop.");
}

/// Follows which file LaTeX is reading, by the parentheses in its log.
class OpenFiles {
 public:
  void read(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '(') files_.push_back(file_at(line.substr(i + 1)));
      if (first_.empty() && !files_.empty()) first_ = files_.back();
      if (line[i] == ')' && !files_.empty()) files_.pop_back();
    }
  }

  /// The innermost open file; empty if unknown.
  std::string_view current() const {
    const auto named = std::find_if(files_.rbegin(), files_.rend(),
                                    [](const std::string& file) { return !file.empty(); });
    return named == files_.rend() ? std::string_view{} : *named;
  }

  /// The innermost open file of the document's own folder; empty if there is none.
  std::string_view current_own() const {
    const auto named = std::find_if(files_.rbegin(), files_.rend(),
                                    [](const std::string& file) { return file.starts_with("./"); });
    return named == files_.rend() ? std::string_view{} : *named;
  }

  /// The document itself, whose name stays known when it is closed.
  std::string_view first() const { return first_; }

 private:
  static std::string file_at(std::string_view text) {
    if (text.starts_with('"')) return std::string(text.substr(1, text.find('"', 1) - 1));
    const std::string_view word = text.substr(0, text.find_first_of(" ()[]{}<>\t"));
    const bool is_file = word.starts_with("./") || word.starts_with("../") || word.starts_with('/');
    return is_file ? std::string(word) : "";
  }

  std::vector<std::string> files_;
  std::string first_;
};

/// Knows the text of an overfull or underfull box, which follows up to an empty line: neither its
/// parentheses stand for files, nor «23T09:52:39Z» in it for the place of an error.
class BoxContents {
 public:
  bool hold(std::string_view line) {
    if (are_open_ && !line.empty()) return true;
    const bool is_box = line.starts_with("Overfull \\") || line.starts_with("Underfull \\");
    are_open_ = is_box && !line.ends_with("[]");  // which is all that a page has
    return false;
  }
  bool are_open() const { return are_open_; }

 private:
  bool are_open_ = false;
};

std::string_view digits_at(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, is_digit);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

/// The line number at the end of most warnings, and of a paragraph the last one as well; empty if
/// there is none.
std::pair<std::string_view, std::string_view> line_numbers_in(std::string_view message) {
  for (const std::string_view words : {"input line ", "at lines ", "at line "}) {
    const auto at = message.rfind(words);
    if (at == std::string_view::npos) continue;
    const std::string_view rest = message.substr(at + words.size());
    const std::string_view first = digits_at(rest);
    if (!rest.substr(first.size()).starts_with("--")) return {first, first};
    return {first, digits_at(rest.substr(first.size() + 2))};
  }
  return {};
}

/// Whether a line reports a box that is overfull by more than can be seen, which is 0.1 pt. Around
/// the page it may be a blank, which shows nothing: elsarticle ends the foot of each first page
/// with one, which is 1.9 pt wide in Times, 2.2 pt in Computer Modern, and less than 3 pt at 12 pt.
bool is_overfull(std::string_view line) {
  if (!line.starts_with("Overfull \\")) return false;
  const auto open = line.find('(');
  if (open == std::string_view::npos) return false;
  double points = 0;
  std::from_chars(line.data() + open + 1, line.data() + line.size(), points);
  const bool is_around_page = line.find("while \\output is active") != std::string_view::npos;
  return points > (is_around_page ? 3 : 0.1);
}

bool is_defect(std::string_view line) {
  const auto has = [line](std::string_view words) { return line.find(words) != line.npos; };
  if (line.starts_with("Missing character: ") || is_overfull(line)) return true;
  if (!has("Warning: ")) return false;
  if (has("Reference `") || has("Citation `") || has("Citation '")) return has("undefined");
  if (has("Float too large for page")) return true;
  if (has("invalid in math mode"))
    return true;  // which prints nothing, or a letter without its accent
  return has("multiply defined") && has("Label `");
}

}  // namespace

std::vector<std::string> latex_errors(std::string_view log, std::string_view source_label) {
  std::vector<std::string> errors;
  bool wants_place = false;
  std::string_view context;
  BoxContents boxes;
  for (const std::string_view line : sys::lines_of(log)) {
    if (boxes.hold(line)) continue;
    const bool is_end = line.find("==> Fatal error occurred") != std::string_view::npos;
    if (line.starts_with("l.") && wants_place) {
      if (!sys::stripped(line).ends_with(just_read(context))) {
        errors.back().append("\n  ").append(sys::stripped(context));
      }
      errors.back().append("\n  ").append(line);
      wants_place = false;
    } else if (wants_place && errors.back().starts_with("! ") && is_emergency_stop(line)) {
      // TeX tells where it stopped only after what stopped it, such as a file that is not there.
      const std::string place =
          labelled(line.substr(0, line.find(": Emergency stop") + 2), source_label);
      errors.back().replace(0, 2, place);
    } else if (wants_place && errors.back() == "! Emergency stop." && line.starts_with("<*> ")) {
      // TeX has read the main file to its end and asks what comes now.
      errors.back() = "the document ends without \\end{document}";
      wants_place = false;
    } else if (wants_place && !just_read(line).empty()) {
      context = line;
    } else if (is_error(line) && !is_end) {
      errors.push_back(labelled(line, source_label));
      wants_place = true;
      context = {};
    } else if (is_bare_error(line) && !is_end) {
      errors.emplace_back(line);
      wants_place = true;
      context = {};
    }
  }
  return errors;
}

/// What TeX says behind «\end occurred inside a group» of one that nobody closed, as «### simple
/// group (level 1) entered at line 3 ({)»; empty for any other line. TeX does not tell the file.
std::string open_group_in(std::string_view line) {
  constexpr std::string_view words = " entered at line ";
  const auto at = line.find(words);
  if (!line.starts_with("### ") || at == line.npos) return "";
  const std::string_view number = digits_at(line.substr(at + words.size()));
  const std::string_view opened = line.substr(at + words.size() + number.size());
  return fmt::format(
      "the group that begins in line {} of this file, or of one that it reads, is not closed{}",
      number, opened);
}

std::vector<std::string> latex_defects(std::string_view log, std::string_view source_label) {
  std::vector<std::string> defects;
  OpenFiles files;
  BoxContents boxes;
  for (const std::string_view line : sys::lines_of(log)) {
    if (boxes.hold(line)) continue;
    if (const std::string group = open_group_in(line); !group.empty()) {
      defects.push_back(labelled(files.first(), source_label) + ": " + group);
    } else if (is_defect(line)) {
      auto [number, last] = line_numbers_in(line);
      std::string_view message = line, in = files.current();
      if (number.size() != last.size() ? number.size() > last.size() : number > last) {
        // A paragraph that began in another file: in the document, which now reads what was made
        // for it, or in a file that was read meanwhile.
        if (in.starts_with("./") || files.current_own().empty()) {
          number = last;
        } else {
          in = files.current_own();
          message.remove_suffix(last.size() + 2);
        }
      }
      const std::string file = in.empty() ? "" : labelled(in, source_label) + ":";
      defects.push_back(fmt::format("{}{}{}{}", file, number, number.empty() ? "" : ":",
                                    file.empty() && number.empty() ? "" : " ") +
                        std::string(message));
    } else if (!boxes.are_open()) {
      files.read(line);
    }
  }
  return defects;
}

std::string rerun_request(std::string_view log) {
  // «Rerun checks for auxiliary files» is only what a package is called.
  for (const std::string_view line : sys::lines_of(log)) {
    for (const std::string_view words : {"Rerun to get", "Rerun LaTeX", "rerun LaTeX"}) {
      if (line.find(words) != line.npos) return std::string(line);
    }
  }
  return {};
}

std::vector<std::string> bibtex_errors(std::string_view log, std::string_view source_label) {
  static const sys::Pattern place("^([^\n]*)---line (\\d+) of file ([^\n]+)$");
  std::vector<std::string> errors;
  std::string_view before;
  for (const std::string_view line : sys::lines_of(log)) {
    if (const auto found = place.find_in(line)) {
      const auto& parts = found->parts;
      const std::string_view message = parts[1].empty() ? before : parts[1];
      // A line of a file that LaTeX wrote tells its reader nothing.
      errors.push_back(parts[3].ends_with(".aux")
                           ? fmt::format("BibTeX: {}", message)
                           : fmt::format("{}:{}: BibTeX: {}", labelled(parts[3], source_label),
                                         parts[2], message));
    }
    before = line;
  }
  return errors;
}

bool is_overfull_box(std::string_view defect) {
  return defect.find("Overfull \\") != std::string_view::npos;
}

}  // namespace literate
