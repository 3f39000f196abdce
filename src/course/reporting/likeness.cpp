// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/likeness.hpp"
#include "system/csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

std::string without_blanks(std::string_view line) {
  std::string text;
  std::ranges::copy_if(line, std::back_inserter(text),
                       [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
  return text;
}

/// The length of the token with which a text begins: a comment, a string or character, a word or
/// number, or one sign.
std::size_t length_of_token(std::string_view text) {
  const auto up_to = [&](std::size_t end) { return std::min(end, text.size()); };
  if (text.starts_with("//")) return up_to(text.find('\n'));
  if (text.starts_with("/*")) {
    const auto end = text.find("*/", 2);
    return end == text.npos ? 2 : end + 2;
  }
  if (text.front() == '"' || text.front() == '\'') {
    std::size_t end = 1;
    while (end < text.size() && text[end] != text.front() && text[end] != '\n') {
      end += text[end] == '\\' ? 2U : 1U;
    }
    return up_to(end + 1);
  }
  const auto is_in_word = [](char c) { return sys::is_alphanumeric(c) || c == '_'; };
  if (!is_in_word(text.front())) return 1;
  const auto end = std::ranges::find_if_not(
      text, [&](char c) { return is_in_word(c) || c == '.' || c == '\''; });
  return static_cast<std::size_t>(end - text.begin());
}

/// A text nearly as sim_c++ sees it: a character for each token, which is the same for all words
/// and numbers and for all strings, and none for comments.
std::string tokens_of(std::string_view text) {
  std::string tokens;
  while (!text.empty()) {
    const std::size_t length = length_of_token(text);
    const char c = text.front();
    const bool is_comment = length > 1 && c == '/';
    if (!is_comment && std::string_view(" \t\r\n\v\f").find(c) == std::string_view::npos) {
      tokens += sys::is_alphanumeric(c) || c == '_' ? 'a' : c;
    }
    text.remove_prefix(length);
  }
  return tokens;
}

constexpr std::size_t most_repetitions = 500;

/// Whether a text repeats itself so often that sim_c++, whose time grows with the third power of
/// the length of what is repeated, could take hours. Shorter stretches than its 24 tokens do not
/// count.
bool repeats_itself(std::string_view text) {
  constexpr std::size_t shortest = 24;
  const std::string tokens = tokens_of(text);
  for (std::size_t period = 1; period * most_repetitions < tokens.size(); ++period) {
    std::size_t n_in_a_row = 0, n_repeated = 0;
    for (std::size_t i = period; i < tokens.size(); ++i) {
      n_in_a_row = tokens[i] == tokens[i - period] ? n_in_a_row + 1 : 0;
      if (n_in_a_row >= shortest) n_repeated += n_in_a_row == shortest ? shortest : 1;
    }
    if (n_repeated > period * most_repetitions) return true;
  }
  return false;
}

/// Why what somebody wrote would hinder others from being compared; empty if it does not.
std::string hindrance_of(std::string_view own) {
  constexpr std::size_t most_kb = 32;
  if (own.size() > most_kb * 1024) {
    return fmt::format("{} kB of it are neither given nor expected, more than {} kB",
                       own.size() / 1024, most_kb);
  }
  if (!repeats_itself(own)) return "";
  return fmt::format("it repeats itself more than {} times", most_repetitions);
}

std::size_t number_in(std::string_view digits) {
  std::size_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// The percentage of the first file that is in the second, by their numbers.
using Shares = std::map<std::pair<std::size_t, std::size_t>, int>;

Shares shares_in(std::string_view output) {
  static const sys::Pattern line_form(
      R"(\s*(?:\S*/)?(\d+)\.cpp consists for (\d+) % of (?:\S*/)?(\d+)\.cpp material\s*)");
  Shares shares;
  for (const std::string_view line : sys::lines_of(output)) {
    const auto match = line_form.match_all_of(line);
    if (!match) continue;
    shares[{number_in(match->parts[1]), number_in(match->parts[3])}] =
        static_cast<int>(number_in(match->parts[2]));
  }
  return shares;
}

/// The shares of all files in a folder, which are named 0.cpp, 1.cpp and so on. Throws
/// std::runtime_error if sim_c++ fails.
Shares compare(const fs::path& folder, std::size_t n_files, const fs::path& work,
               Isolation isolation) {
  const Sandbox sandbox(isolation, work);
  const Readable readable{folder, "/own"};
  make_readable(folder);
  Job job{.command = {sys::find_tool("sim_c++").string(), "-p", "-a", "-e", "-t", "1"},
          .readable = {readable},
          .folder = sandbox.place(readable),
          .output = work / "sim.out",
          .errors = work / "sim.err",
          .seconds = 600,
          .memory_mb = 4096,
          .file_kb = 256 * 1024};
  for (std::size_t i = 0; i < n_files; ++i) job.command.push_back(fmt::format("{}.cpp", i));
  const JobEnd end = sandbox.run(job);
  if (end.ending != Ending::normal || end.status != 0) {
    const std::string said = sys::read_file(job.errors);
    std::string why = said.substr(0, said.find('\n'));
    if (end.ending == Ending::too_slow) why = fmt::format("it takes longer than {} s", job.seconds);
    if (end.ending == Ending::too_large) why = fmt::format("it takes over {} MB", job.memory_mb);
    throw std::runtime_error("sim_c++ failed: " + why);
  }
  return shares_in(sys::read_file(job.output));
}

/// The pairs of one exercise.
std::vector<LikePair> pairs_of(const std::string& exercise, const std::vector<std::string>& units,
                               const Shares& shares, int percent) {
  const auto share = [&](std::size_t i, std::size_t j) {
    const auto found = shares.find({i, j});
    return found == shares.end() ? 0 : found->second;
  };
  std::vector<LikePair> pairs;
  for (std::size_t i = 0; i < units.size(); ++i) {
    for (std::size_t j = i + 1; j < units.size(); ++j) {
      LikePair pair{exercise, units[i], units[j], share(i, j), share(j, i)};
      if (pair.percent_of_second > pair.percent_of_first) {
        std::swap(pair.first, pair.second);
        std::swap(pair.percent_of_first, pair.percent_of_second);
      }
      if (pair.percent_of_first >= percent) pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

}  // namespace

std::set<std::string> known_lines(const std::vector<Files>& all) {
  std::set<std::string> known;
  for (const Files& files : all) {
    for (const auto& [file, text] : files) {
      for (const std::string_view line : sys::lines_of(text)) known.insert(without_blanks(line));
    }
  }
  return known;
}

std::string own_lines(std::string_view text, const std::set<std::string>& known) {
  std::string own;
  for (const std::string_view line : sys::lines_of(text)) {
    if (known.contains(without_blanks(line))) continue;
    own += line;
    own += '\n';
  }
  return own;
}

Likeness likeness_of(const Assignment& assignment, const std::vector<Written>& all,
                     const std::set<std::string>& known, int percent, const fs::path& work,
                     Isolation isolation) {
  Likeness likeness;
  for (const Exercise& exercise : assignment.exercises) {
    const fs::path folder = work / exercise.id;
    std::vector<std::string> units;
    for (const Written& written : all) {
      const auto file = written.files.find(exercise.file);
      if (file == written.files.end()) continue;
      const std::string own = own_lines(file->second, known);
      const std::string hindrance = hindrance_of(own);
      if (!hindrance.empty()) {
        likeness.problems.push_back(
            fmt::format("{} of {} is not compared: {}", exercise.file, written.unit, hindrance));
        continue;
      }
      sys::write_file_atomically(folder / fmt::format("{}.cpp", units.size()), own);
      units.push_back(written.unit);
    }
    if (units.size() < 2) continue;
    try {
      const Shares shares = compare(folder, units.size(), work, isolation);
      const auto more = pairs_of(exercise.id, units, shares, percent);
      likeness.pairs.insert(likeness.pairs.end(), more.begin(), more.end());
    } catch (const sys::ToolError&) {
      throw;
    } catch (const std::runtime_error& error) {
      likeness.problems.push_back(
          fmt::format("{} is not compared: {}", exercise.file, error.what()));
    }
  }
  std::ranges::stable_sort(likeness.pairs, [](const LikePair& a, const LikePair& b) {
    return std::tie(b.percent_of_first, b.percent_of_second) <
           std::tie(a.percent_of_first, a.percent_of_second);
  });
  return likeness;
}

std::string pairs_csv(const std::vector<LikePair>& pairs) {
  std::string csv = "exercise,first,percent of the first,second,percent of the second\r\n";
  for (const LikePair& pair : pairs) {
    csv += fmt::format("{},{},{},{},{}\r\n", sys::spreadsheet_field(pair.exercise),
                       sys::spreadsheet_field(pair.first), pair.percent_of_first,
                       sys::spreadsheet_field(pair.second), pair.percent_of_second);
  }
  return csv;
}

}  // namespace course
