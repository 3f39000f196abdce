// SPDX-License-Identifier: GPL-3.0-or-later
// Case files that were damaged at random, the same ones in every run: each is accepted, or refused
// by one line that says where.
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "config/table.hpp"
#include "paper/paper.hpp"
#include "paper/printed_data.hpp"
#include "random_inputs.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(damaged_case_test)

namespace {

using Lines = std::vector<std::string>;

const std::string source_dir = HALFSPACE_SOURCE_DIR;

Lines lines_of(const std::string& file) {
  std::istringstream text(sys::read_file(source_dir + "/" + file));
  Lines lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// Damages a case where it matters: a number, a unit, a key, a string, a line, a table or a byte.
class Vandal {
 public:
  explicit Vandal(std::uint64_t seed) : random_(seed) {}

  std::string damage(Lines lines) {
    switch (below(10)) {
      case 0:
        lines.erase(at(lines));
        break;
      case 1:
        lines.insert(at(lines), *at(lines));
        break;
      case 2:
        std::swap(*at(lines), *at(lines));
        break;
      case 3:
        replace(*line_with(lines, unit), unit, pick(units));
        break;
      case 4:
        replace(*line_with(lines, quoted), quoted, pick(strings));
        break;
      case 5:
        replace(*line_with(lines, key), key, pick(keys));
        break;
      case 6:
        return with_damaged_bytes(joined(lines));
      default:
        replace(*line_with(lines, number), number, pick(numbers));
    }
    return joined(lines);
  }

 private:
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(random_.uniform(0, static_cast<double>(n)));
  }
  const std::string& pick(const Lines& choices) { return choices[below(choices.size())]; }
  Lines::iterator at(Lines& lines) {
    return lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size()));
  }

  // A random line that holds the pattern.
  Lines::iterator line_with(Lines& lines, const std::regex& pattern) {
    Lines::iterator line = at(lines);
    while (!std::regex_search(*line, pattern)) line = at(lines);
    return line;
  }

  // Replaces one of the places where the pattern is found.
  void replace(std::string& line, const std::regex& pattern, const std::string& by) {
    const auto begin = std::sregex_iterator(line.begin(), line.end(), pattern);
    const auto n = static_cast<std::size_t>(std::distance(begin, std::sregex_iterator()));
    const std::smatch found = *std::next(begin, static_cast<std::ptrdiff_t>(below(n)));
    line = found.prefix().str() + by + found.suffix().str();
  }

  std::string with_damaged_bytes(std::string text) {
    const std::size_t position = below(text.size());
    switch (below(4)) {
      case 0:
        return text.substr(0, position);
      case 1:
        return text.erase(position, 1 + below(40));
      case 2:
        return text.insert(position, pick(bytes));
      default:
        text[position] = static_cast<char>(below(256));
        return text;
    }
  }

  RandomInputs random_;
  const std::regex number{R"([-+]?\d+(\.\d*)?([eE][-+]?\d+)?)"};
  const std::regex unit{R"(unit = "[^"]*")"};
  const std::regex quoted{R"("[^"]*")"};
  const std::regex key{R"([A-Za-z_][A-Za-z_0-9]*)"};
  const Lines numbers{"0",     "-1",     "-0.0",   "0.5",      "nan",   "-inf",
                      "1e400", "1e-400", "1e60",   "1e-60",    "1e300", "9223372036854775807",
                      "7",     "1e7",    "0.0200", "99999999", "1e-9",  "9223372036854775808",
                      "true",  "[1, 2]", "{}",     "\"1\"",    "1_0",   "2026-11-22",
                      "1.",    "0x10",   "1e-3",   "4e9",      "''",    "3.000000000001"};
  const Lines units{
      "unit = \"m\"",      "unit = \"psi\"",        "unit = \"\"",     "unit = 1",
      "unit = \"in @ 1\"", "unit = \"lg(re 1 m)\"", "unit = \"-in\"",  "unit = \"furlong\"",
      "unit = \"km\"",     "unit = \"\\u0007\"",    "unit = \"0 in\"", "unit = \"1e300 m\"",
      "unot = \"in\"",     "unit = \"lbf/in\"",     "unit = \"°\"",    "unit = \"in\\nin\""};
  const Lines strings{"\"\"",    "\"plane\"", "\"a\\nb\"",   "\"😀\"",          "\"clamped\"",
                      "\"-\"",   "\"1e\"",    "\"0\"",       "\"1e99999999\"", "\"-0\"",
                      "\"m-N\"", "\"nan\"",   "\"\\u0000\"", "\"1e-60\"",      "\"1e+\"",
                      "7",       "'''\n'''",  "\"+\""};
  const Lines keys{"value", "\"a\\nb\"", "load", "\"\"", "step", "x.y", "material", "😀", "count"};
  const Lines bytes{"\xFF", std::string(1, '\0'),  "[", "\"", "=", "\r", "\x1b[31m",
                    "{{{{", std::string(2000, '[')};
};

struct Verdict {
  bool is_accepted = false;
  std::string message = {};
};

Verdict verdict_on(const std::filesystem::path& file) {
  try {
    const parameters::Case c = parameters::read_case(file);
    paper::require_reportable(c);
    paper::read_printed(c);
    for (const double x : c.half_space.points) BOOST_TEST(std::isfinite(x));
    return {.is_accepted = true};
  } catch (const sys::InputError& e) {
    return {.message = e.what()};
  }
}

// One line: the file, line and column, then printable text that a library did not word.
void check_message(const std::string& text, const std::string& file, const std::string& message) {
  BOOST_TEST(message.starts_with(file + ":"), message);
  const std::regex place("^:\\d+:\\d+: [^ ].*");
  BOOST_TEST(std::regex_match(message.substr(file.size()), place), message);
  for (const char c : message) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0)
      BOOST_ERROR("control character: " + message);
  }
  for (const char* internal : {"::", "vector", "basic_string", "stod", "from_chars", "optional"}) {
    BOOST_TEST(message.find(internal) == std::string::npos, message);
  }
  if (text.find("nan") == std::string::npos) {
    BOOST_TEST(!std::regex_search(message, std::regex("\\bnan\\b")), message);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_damaged_case_is_accepted_or_refused_in_one_line_that_says_where) {
  const TemporaryFolder folder;
  constexpr int n_cases = 600;
  int n_refused = 0;
  for (const char* original : {"report/ruggiero2001.toml", "tests/end_to_end/steel_mm.toml"}) {
    const Lines lines = lines_of(original);
    Vandal vandal(20010423);
    for (int i = 0; i < n_cases / 2; ++i) {
      const std::string text = vandal.damage(lines);
      const std::filesystem::path file = folder.write("case.toml", text);
      BOOST_TEST_CONTEXT(original << ", damaged for the " << i << "th time") {
        const Verdict verdict = verdict_on(file);
        if (verdict.is_accepted) continue;
        ++n_refused;
        check_message(text, file.string(), verdict.message);
        BOOST_TEST_MESSAGE(verdict.message);
      }
    }
  }

  // Damage that is never noticed, or always, would test nothing.
  BOOST_TEST(n_refused > n_cases / 2);
  BOOST_TEST(n_refused < n_cases * 9 / 10);
}

BOOST_AUTO_TEST_SUITE_END()
