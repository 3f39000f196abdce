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

std::size_t number_in(std::string_view digits) {
  std::size_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// What sim_c++ tells of the texts in a folder, by their numbers.
struct Compared {
  std::map<std::pair<std::size_t, std::size_t>, int> percent;  ///< of the first is in the second
  std::set<std::size_t> too_slow;                              ///< of which nothing is told
};

constexpr std::size_t most_kb = 32;
constexpr int seconds_of_a_text = 3;

// sim_c++ takes hours over some texts that repeat themselves, but little over another text and one
// of these. So each text is compared with all in a run of its own, and a text whose run takes too
// long hinders no other.
constexpr const char* sim_script = R"sh(
seconds=$1
shift
for text; do
  prlimit --cpu="$seconds:$((seconds + 1))" "$0" -p -e -t 1 -S "$text" / "$@"
  case $? in
    0) ;;
    152) echo "$text takes too long" ;; # ended by SIGXCPU
    *) exit 1 ;;
  esac
done)sh";

Compared told_by_sim(std::string_view output) {
  static const sys::Pattern share_form(
      R"(\s*(?:\S*/)?(\d+)\.cpp consists for (\d+) % of (?:\S*/)?(\d+)\.cpp material\s*)");
  Compared compared;
  for (const std::string_view line : sys::lines_of(output)) {
    if (const auto share = share_form.match_all_of(line)) {
      compared.percent[{number_in(share->parts[1]), number_in(share->parts[3])}] =
          static_cast<int>(number_in(share->parts[2]));
    } else if (line.ends_with(".cpp takes too long")) {
      compared.too_slow.insert(number_in(line));
    }
  }
  std::erase_if(compared.percent, [&](const auto& share) {
    const auto [i, j] = share.first;
    return compared.too_slow.contains(i) || compared.too_slow.contains(j);
  });
  return compared;
}

/// Compares all files in a folder, which are named 0.cpp, 1.cpp and so on. Throws
/// std::runtime_error if sim_c++ fails.
Compared compare(const fs::path& folder, std::size_t n_files, const fs::path& work,
                 Isolation isolation) {
  const Sandbox sandbox(isolation, work);
  const Readable readable{folder, "/own"};
  make_readable(folder);
  Job job{.command = {"/bin/sh", "-c", sim_script, sys::find_tool("sim_c++").string(),
                      fmt::format("{}", seconds_of_a_text)},
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
  return told_by_sim(sys::read_file(job.output));
}

/// The pairs of one exercise.
std::vector<LikePair> pairs_of(const std::string& exercise, const std::vector<std::string>& units,
                               const Compared& compared, int percent) {
  const auto share = [&](std::size_t i, std::size_t j) {
    const auto found = compared.percent.find({i, j});
    return found == compared.percent.end() ? 0 : found->second;
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
    const auto not_compared = [&](const std::string& unit, const std::string& why) {
      likeness.problems.push_back(
          fmt::format("{} of {} is not compared: {}", exercise.file, unit, why));
    };
    for (const Written& written : all) {
      const auto file = written.files.find(exercise.file);
      if (file == written.files.end()) continue;
      const std::string own = own_lines(file->second, known);
      if (own.size() > most_kb * 1024) {
        not_compared(written.unit,
                     fmt::format("{} kB of it are neither given nor expected, more than {} kB",
                                 own.size() / 1024, most_kb));
        continue;
      }
      if (own.find("R\"") != own.npos) {
        likeness.problems.push_back(fmt::format(
            "{} of {} is to be read by a person: sim_c++ takes a raw string, R\"(…)\", for others, "
            "which may hide what follows",
            exercise.file, written.unit));
      }
      sys::write_file_atomically(folder / fmt::format("{}.cpp", units.size()), own);
      units.push_back(written.unit);
    }
    if (units.size() < 2) continue;
    try {
      const Compared compared = compare(folder, units.size(), work, isolation);
      for (const std::size_t i : compared.too_slow) {
        not_compared(units[i],
                     fmt::format("sim_c++ takes longer than {} s for it", seconds_of_a_text));
      }
      const auto more = pairs_of(exercise.id, units, compared, percent);
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
