// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/prose.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "config/units.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/text/characters.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

// The significant digits of a number that may be typed: «of order 2», «40 elements».
constexpr int most_digits = 2;

/// A unit after a number, in text, in a \mathrm or as the second argument of \qty. Of $\mu$Pa the
/// prefix is blank here.
const sys::Pattern& unit() {
  static const sys::Pattern pattern(
      R"re(^(\s|~|\\[,;: ]|[{}]|-|\$\s+\$)*)re"
      R"re((\\%|per ?cent\b|((µ|μ)[A-Za-z]*|°[CF]?|[mkMG]?Pa|[mkM]?N|[numcdk]?m|[mk]?g|[npm]?s|[kMGT]?Hz|dB|[kMG]B)re"
      R"re(|[mkM]?J|[mkMG]W|[kMGT]?Wh|[mkM]V|mA|m?Ah|[kMG]?Ω|[np]F|m[HT]|Np|lbf|lb|psi|ksi)re"
      R"re(|min|h|ft|rad|mrad|K|[kMG]?eV|m?bar|m?mol|ml|pounds?|inch(es)?|feet|degrees?)re"
      R"re(|(milli|centi|kilo)?met(re|er)s?|seconds?|minutes?|hours?|days?|weeks?|years?|newtons?|pascals?)(?![A-Za-z])))re");
  return pattern;
}

/// Whether a tie or a thin space and a name that UDUNITS knows follow: who sets them means a unit.
bool is_tied_to_unit(std::string_view text) {
  static const sys::Pattern name("^(?:~|\\\\,)\\s*([A-Za-zµΩ]+)(?![A-Za-z])");
  const auto found = name.find_in(text);
  return found && config::is_unit(std::string(found->parts[1]));
}

/// «in» is a unit only after a tie or a thin space, or at the end of a clause.
const sys::Pattern& inches() {
  static const sys::Pattern pattern(R"re(^((~|\\,)in\b|\s+in\s*[.,;)]))re");
  return pattern;
}

/// A number at the start of a text, with whole part, decimals and power of ten as groups; digits in
/// parentheses are its uncertainty. Three digits behind a blank belong to it, as in 12 500. Of
/// $12\times 10^{3}$ the sign is blank here.
const sys::Pattern& numeral() {
  static const sys::Pattern pattern(
      R"re(^(\d+:\d\d:\d\d|\d{1,3}(?:(?:\{,\}|\\,|[,~ ])\d{3}(?!\d))+|\d+)((?:\.|\{\.\})\d+)?(?:\(\d+\))?([eE][+-]?\d+|(?:\s+10)?\^(?:\{[+-]?\d+\}|\d))?)re");
  return pattern;
}

int significant_digits(std::string_view whole, std::string_view decimals) {
  std::string digits;
  std::ranges::copy_if(whole, std::back_inserter(digits), is_digit);
  std::ranges::copy_if(decimals, std::back_inserter(digits), is_digit);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  if (decimals.empty()) digits.erase(digits.find_last_not_of('0') + 1);
  return static_cast<int>(digits.size());
}

/// What stands before a number and after it, as far as a sentence may reach.
struct Surroundings {
  std::string before;
  std::string after;
  TexMode mode;
};

bool begins_with_unit(std::string_view text) {
  return unit().is_in(text) || inches().is_in(text) || is_tied_to_unit(text);
}

bool has_unit(const Surroundings& around) {
  static const sys::Pattern quantity("\x02[\\s{]*-?$");
  static const sys::Pattern end_of_math(R"(^[\s}]*\$)");
  // 5\%, 12$'$, 90^\circ, 3\,\Omega, 3 $\Omega$, but not 2\Omega
  static const sys::Pattern sign(
      "^[\\s}]*(\\$\\s*''?\\s*\\$|\\\\%|((\\s|~|\\\\[,;: ]|[{}$])*\\^[\\s{]*|(\\s|~|\\\\[,;: "
      "]|[{}$])+)\x04)");
  static const sys::Pattern upright("^(\\s|~|\\\\[,;: ]|[{}$])*\x01\\s*\\{");
  static const sys::Pattern per_unit("^/(s|min|h|d|cm|mm|km|kg|mol)(?![A-Za-z])");
  if (quantity.is_in(around.before) || sign.is_in(around.after)) return true;
  if (around.mode == TexMode::text && around.after.starts_with(Prose::unit_sign)) return true;
  if (const auto letters = upright.find_in(around.after)) {
    return begins_with_unit(letters->rest) || letters->rest.starts_with("in}");
  }
  if (around.mode == TexMode::text) {
    return begins_with_unit(around.after) || per_unit.is_in(around.after);
  }
  if (around.after.starts_with('\'')) return true;  // minutes of arc
  const auto end = end_of_math.find_in(around.after);
  return end && begins_with_unit(end->rest);
}

/// Whether a number is a year in parentheses, after a month or beside a citation, or the place in a
/// cited source.
bool is_reference(const std::string& number, const Surroundings& around) {
  static const sys::Pattern year("(1[5-9]|20)\\d\\d");
  static const sys::Pattern month(
      "(January|February|March|April|May|June|July|August|September|October"
      "|November|December)[\\s~]*$");
  if (year.is_all_of(number)) {
    if (around.before.ends_with('(') && around.after.starts_with(')')) return true;
    if (month.is_in(around.before)) return true;
    static const sys::Pattern citation("^[\\s~]*\x03");
    static const sys::Pattern citation_of("\x03[\\s~]+(of|in)[\\s~]+$");
    if (citation.is_in(around.after) || citation_of.is_in(around.before)) return true;
  }
  static const sys::Pattern part(
      "([Pp]ages?|pp?\\.|[Cc]hapter|[Ss]ection|[Ee]quations?|[Ee]qs?\\.|[Ff]igures?|[Ff]igs?\\."
      "|[Tt]ables?)[\\s~]+$");
  static const sys::Pattern of_citation("^[\\s~]+(of|in)[\\s~]+\x03");
  if (part.is_in(around.before) && of_citation.is_in(around.after)) return true;
  // \cite{x}, pp. 3–5, or eq. (4.45); no repetition within the repetition, which could take for
  // ever
  static const sys::Pattern behind_citation(
      "\x03\\s*,(?:[\\s~\\d.,()–-]|[a-z]\\)|and|or|[Pp]ages?|pp?\\.|[Cc]hap(?:ter|\\.)"
      "|[Ss]ec(?:tions?|s?\\.)|[Ee]q(?:uations?|s?\\.)|[Ff]ig(?:ures?|s?\\.)"
      "|[Tt]ab(?:les?|\\.)|[Nn]o\\.|[Vv]ol\\.)*$");
  static const sys::Pattern before_citation(
      "^[a-z]?\\)(\\s+and\\s+\\(\\d+(\\.\\d+)?[a-z]?\\))?[\\s~]+of[\\s~]+\x03");
  static const sys::Pattern second_of_two("\\(\\d+(\\.\\d+)?[a-z]?\\)\\s+and\\s+\\($");
  return (behind_citation.is_in(around.before) && !has_unit(around)) ||
         ((around.before.ends_with('(') || second_of_two.is_in(around.before)) &&
          before_citation.is_in(around.after));
}

struct Marker {
  bool is_there = false;
  bool has_reason = false;
};

/// Finds «% constant: reason» at the end of a line; `sign` begins a comment.
Marker marker_in(std::string_view line, char sign) {
  static const sys::Pattern pattern(R"re(^[%#]\s*constant\b:?\s*(\S?))re");
  constexpr std::size_t reach = 240;  // a matcher that recurses must not see a line of any length
  for (auto at = line.find(sign); at != line.npos; at = line.find(sign, at + 1)) {
    if (at > 0 && line[at - 1] == '\\') continue;
    if (const auto match = pattern.find_in(line.substr(at, reach))) {
      return {true, !match->parts[1].empty()};
    }
  }
  return {};
}

/// A number in the prose that ought to be computed, and the byte at which it begins.
struct Typed {
  std::size_t at = 0;
  std::string number;
};

/// Whether a digit continues a word or a longer number, as in MEAE-4960.
bool continues(const std::string& text, std::size_t at) {
  if (at == 0) return false;
  const char before = text[at - 1];
  if (is_letter(before) || is_digit(before) || before == '.' || before == '_') return true;
  return before == '-' && at > 1 && is_letter(text[at - 2]);
}

std::vector<Typed> typed_in(const Prose& prose) {
  constexpr std::size_t reach = 240;  // no sentence needs to be known further from the number
  std::vector<Typed> found;
  for (std::size_t at = 0; at < prose.text.size(); ++at) {
    if (!is_digit(prose.text[at]) || continues(prose.text, at)) continue;
    const std::size_t begin = at < reach ? 0 : at - reach;
    const std::string rest = prose.text.substr(at, reach);
    const auto match = numeral().find_in(rest);
    if (!match) continue;
    const std::string_view exponent = match->parts[3];
    const std::string number = fmt::format("{}{}{}", match->parts[1], match->parts[2],
                                           exponent.starts_with(' ') ? "" : exponent);
    const Surroundings around{prose.text.substr(begin, at - begin), std::string(match->rest),
                              prose.modes[at]};
    const bool is_long = significant_digits(match->parts[1], match->parts[2]) > most_digits;
    const bool is_result = has_unit(around) || (is_long && around.mode != TexMode::display_math);
    if (is_result && !is_reference(number, around)) found.push_back({at, number});
    at += match->parts[0].size() - 1;
  }
  return found;
}

/// Tells what was typed, but for lines that are marked, and marks without a reason or a cause.
std::vector<std::string> findings_in(std::string_view text, const std::string& file,
                                     const std::vector<Typed>& typed, char sign) {
  auto next = typed.begin();
  std::vector<std::string> findings;
  int line_number = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    ++line_number;
    const auto begin = static_cast<std::size_t>(line.data() - text.data());
    const Marker marker = marker_in(line, sign);
    const auto report = [&](std::size_t column, const std::string& message) {
      findings.push_back(fmt::format("{}:{}:{}: {}", file, line_number, column, message));
    };
    const auto first = next;
    for (; next != typed.end() && next->at < begin + line.size(); ++next) {
      if (marker.is_there) continue;
      report(sys::n_characters(text.substr(begin, next->at - begin)) + 1,
             fmt::format("{} is typed: take it from the computation, or, if it is no result, end "
                         "the line with '{} constant: reason'",
                         next->number, sign));
    }
    if (marker.is_there && !marker.has_reason) report(1, "a constant is marked without a reason");
    if (marker.is_there && first == next) report(1, "a constant is marked where none is typed");
  }
  return findings;
}

/// The length of the text between quotation marks at the start of a line of gnuplot, with them.
std::size_t quoted_length(std::string_view line) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && line.front() == '"') {
      ++i;
    } else if (line[i] == line.front()) {
      return i + 1;
    }
  }
  return line.size();
}

/// The numbers in the texts of a line of gnuplot, at their places in the line, and data that stand
/// in the script.
std::vector<Typed> typed_in_script(std::string_view line) {
  static const sys::Pattern block(R"re(^\s*(\$\w+)\s*<<)re");
  std::vector<Typed> found;
  if (block.is_in(line)) found.push_back({line.find('$'), "a block of data"});
  for (std::size_t at = 0; at < line.size() && line[at] != '#'; ++at) {
    if (line[at] != '\'' && line[at] != '"') continue;
    const std::string_view text = line.substr(at, quoted_length(line.substr(at)));
    const bool is_color = text.size() > 1 && text[1] == '#';
    if (text == "'-'" || text == "\"-\"") found.push_back({at, "a block of data"});
    if (!is_color) {
      for (const Typed& typed : typed_in(prose_of(text)))
        found.push_back({at + typed.at, typed.number});
    }
    at += text.size() - 1;
  }
  return found;
}

/// A line of gnuplot with blanks for its texts and its comment.
std::string without_texts(std::string_view line) {
  std::string drawn(line.substr(0, line.find('#')));
  for (std::size_t at = 0; at < drawn.size(); ++at) {
    if (drawn[at] != '\'' && drawn[at] != '"') continue;
    const std::size_t length = quoted_length(std::string_view(drawn).substr(at));
    drawn.replace(at, length, length, ' ');
    at += length - 1;
  }
  return drawn;
}

/// The numbers in what a line of a plot draws.
std::vector<Typed> typed_in_plot(std::string_view line) {
  const std::string drawn = without_texts(line);
  std::vector<Typed> found;
  for (std::size_t at = 0; at < drawn.size(); ++at) {
    if (!is_digit(drawn[at]) || continues(drawn, at)) continue;
    const auto match = numeral().find_in(std::string_view(drawn).substr(at));
    if (!match) continue;
    if (significant_digits(match->parts[1], match->parts[2]) > most_digits)
      found.push_back({at, std::string(match->parts[0])});
    at += match->parts[0].size() - 1;
  }
  return found;
}

}  // namespace

std::vector<std::string> typed_numbers(std::string_view latex, const std::string& file) {
  return findings_in(latex, file, typed_in(prose_of(latex)), '%');
}

std::vector<std::string> typed_numbers_in_script(std::string_view script, const std::string& file) {
  static const sys::Pattern plot(R"re(^\s*s?plot\b)re");
  static const sys::Pattern left_out(R"re(\bevery\b|\b1 */ *0\b|\bNaN\b)re");
  std::vector<Typed> typed;
  std::vector<std::string> hidden;
  bool goes_on = false, was_continued = false;
  int line_number = 0;
  for (const std::string_view line : sys::lines_of(script)) {
    ++line_number;
    const auto begin = static_cast<std::size_t>(line.data() - script.data());
    std::vector<Typed> found = typed_in_script(line);
    goes_on = plot.is_in(line) || (goes_on && was_continued);
    was_continued = sys::stripped(line).ends_with('\\');
    if (goes_on) {
      std::ranges::move(typed_in_plot(line), std::back_inserter(found));
      const std::string drawn = without_texts(line);
      const auto hides = left_out.find_in(drawn);
      if (hides && line.find("# outside: ") == line.npos) {
        hidden.push_back(fmt::format(
            "{}:{}: '{}' leaves points out: if it is meant, end the line with '# outside: reason'",
            file, line_number, hides->parts[0]));
      }
    }
    std::ranges::sort(found, {}, &Typed::at);
    for (const Typed& one : found) typed.push_back({begin + one.at, one.number});
  }
  std::vector<std::string> findings = findings_in(script, file, typed, '#');
  findings.insert(findings.end(), hidden.begin(), hidden.end());
  return findings;
}

std::vector<std::string> typed_numbers_in(const std::vector<NamedText>& texts) {
  std::vector<std::string> findings;
  for (const NamedText& text : texts) {
    for (const Typed& typed : typed_in(prose_of(text.latex))) {
      findings.push_back(
          fmt::format("{}: {} is typed in the {}: say it without the number, or compute it",
                      text.place, typed.number, text.what));
    }
  }
  return findings;
}

std::vector<std::string> typed_numbers_below(const std::filesystem::path& folder) {
  std::vector<std::string> findings;
  for (const DocumentFile& file : read_document(folder)) {
    std::ranges::move(typed_numbers(file.text, file.label), std::back_inserter(findings));
  }
  return findings;
}

}  // namespace literate
