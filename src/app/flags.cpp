// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <span>
#include <sstream>
#include <string_view>

#include "config/units.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace app {
namespace {

// A number and its unit, as written.
struct Written {
  double number;
  std::string unit;  // empty for none
};

// A unit begins with a letter or, like µm, with a byte beyond ASCII.
bool begins_unit(std::string_view text) {
  return sys::is_letter(text.front()) || static_cast<unsigned char>(text.front()) >= 0x80;
}

Written parse(const std::string& what, std::string_view text) {
  const std::string_view stripped = sys::stripped(text);
  const char* begin = stripped.data();
  const char* const end = begin + stripped.size();
  if (stripped.starts_with('+') && !stripped.starts_with("+-")) ++begin;
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error == std::errc::result_out_of_range) {
    throw sys::InputError(fmt::format("{}: \"{}\" is beyond the range of a double", what, text));
  }
  const std::string unit(sys::stripped({stop, static_cast<std::size_t>(end - stop)}));
  if (error != std::errc() || (!unit.empty() && !begins_unit(unit))) {
    throw sys::InputError(fmt::format("{}: \"{}\" is not a number", what, stripped));
  }
  if (!std::isfinite(number)) {
    throw sys::InputError(fmt::format("{} = {}: must be a finite number", what, stripped));
  }
  return {number, unit};
}

double converted(const Flag& flag, const Written& written, const std::string& unit) {
  if (written.unit.empty()) return written.number;
  if (unit == "1") flag.refuse("must be a plain number");
  try {
    return config::converted(written.number, written.unit, unit);
  } catch (const config::UnitError& error) {
    throw sys::InputError(fmt::format("{}: {}", flag.name(), error.what()));
  }
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

std::vector<double> range(const Flag& flag, double begin, double end, double step) {
  constexpr double most = 1e6, rounding = 1e-9;
  const double n_steps = (end - begin) / step;
  if (!(n_steps >= 0)) flag.refuse("STEP of BEGIN:END:STEP must lead from BEGIN to END");
  if (!(n_steps < most)) flag.refuse(fmt::format("a range has at most {} points", most));
  return evenly_spaced(begin, step, static_cast<int>(n_steps + rounding) + 1);
}

struct Line {
  std::size_t number;  // in the file, from 1
  std::string_view text;
};

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  std::size_t number = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    ++number;
    const std::string_view stripped = sys::stripped(line);
    if (!stripped.empty() && !stripped.starts_with('#')) lines.push_back({number, line});
  }
  return lines;
}

std::string text_of(const std::string& file) {
  if (std::filesystem::is_directory(file)) throw sys::InputError(file + ": is a folder");
  std::string text = sys::read_file(file);
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // written by spreadsheets
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

std::vector<double> numbers_of(const std::string& file, const Line& line) {
  std::vector<double> numbers;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.text.find(',', begin);
    const std::string number(sys::stripped(line.text.substr(begin, comma - begin)));
    const std::string place = fmt::format("{}:{}:{}", file, line.number, begin + 1);
    if (number.empty()) throw sys::InputError(place + ": a number is missing");
    numbers.push_back(parse_number(place, number));
    if (comma == std::string_view::npos) return numbers;
    begin = comma + 1;
  }
}

}  // namespace

std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 80 - help_column;
  std::istringstream words(text);
  std::string all, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() >= width) {
      all += line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return all + line;
}

Flag::Flag(CLI::App& command, const std::string& names, const std::string& type,
           const std::string& group, const std::string& help)
    : name_(names.substr(0, names.find(','))) {
  // CLI11 would take the flag that follows "--x=", or a flag without a value, for the value.
  const CLI::Validator is_value(
      [](const std::string& text) {
        return text.empty() || text.starts_with("--") ? "the value is missing" : "";
      },
      "");
  command.add_option(names, text_, wrapped(help))->type_name(type)->group(group)->check(is_value);
}

Choice::Choice(CLI::App& command, const std::string& name, const std::vector<std::string>& choices,
               const std::string& group, const std::string& help)
    : Flag(command, name, fmt::format("{}", fmt::join(choices, "|")), group, help) {
  command.get_option(name)->check(CLI::IsMember(choices).description(""));
}

void Flag::refuse(const std::string& reason) const {
  throw sys::InputError(fmt::format("{} = {}: {}", name_, text_, reason));
}

std::optional<double> Flag::quantity(const std::string& unit) const {
  if (!is_given()) return std::nullopt;
  return converted(*this, parse(name_, text_), unit);
}

std::optional<double> Flag::positive(const std::string& unit) const {
  const auto number = quantity(unit);
  if (number && !(*number > 0)) refuse("must be greater than 0");
  return number;
}

std::vector<double> Flag::quantities(const std::string& unit) const {
  if (!is_given()) return {};
  std::vector<std::vector<Written>> elements;
  for (const std::string_view element : split(text_, ',')) {
    elements.emplace_back();
    for (const std::string_view part : split(element, ':')) {
      if (sys::stripped(part).empty()) refuse("a number is missing");
      elements.back().push_back(parse(name_, part));
    }
    const std::size_t n = elements.back().size();
    if (n != 1 && n != 3) refuse("a range must be BEGIN:END:STEP");
  }
  const std::string last_unit = elements.back().back().unit;
  std::vector<double> numbers;
  for (std::vector<Written>& element : elements) {
    std::vector<double> parts;
    for (Written& written : element) {
      if (written.unit.empty()) written.unit = last_unit;
      parts.push_back(converted(*this, written, unit));
    }
    if (parts.size() == 3) parts = range(*this, parts[0], parts[1], parts[2]);
    numbers.insert(numbers.end(), parts.begin(), parts.end());
  }
  return numbers;
}

std::optional<long> Flag::count(long least, long most) const {
  const auto number = quantity("1");
  if (!number) return std::nullopt;
  if (*number != std::floor(*number)) refuse("must be a whole number");
  if (*number < static_cast<double>(least) || *number > static_cast<double>(most)) {
    refuse(fmt::format("must be from {} to {}", least, most));
  }
  return static_cast<long>(*number);
}

std::vector<double> read(const std::vector<Needed>& all) {
  std::vector<double> numbers;
  std::vector<const Flag*> needed_flags;
  for (const Needed& needed : all) {
    const auto given = needed.flag.positive(needed.unit);
    if (!needed.from_case) needed_flags.push_back(&needed.flag);
    numbers.push_back(given ? *given : needed.from_case.value_or(0));
  }
  require_given(needed_flags);
  return numbers;
}

void require_given(const std::vector<const Flag*>& flags) {
  std::vector<std::string> missing;
  for (const Flag* flag : flags) {
    if (!flag->is_given()) missing.push_back(flag->name());
  }
  if (missing.empty()) return;
  throw sys::InputError(fmt::format("{} {} missing", fmt::join(missing, " and "),
                                    missing.size() == 1 ? "is" : "are"));
}

void refuse_given(const std::vector<const Flag*>& flags, const std::string& choice) {
  for (const Flag* flag : flags) {
    if (flag->is_given()) throw sys::InputError(flag->name() + " has no meaning for " + choice);
  }
}

double parse_number(const std::string& what, const std::string& text) {
  const Written written = parse(what, text);
  if (written.unit.empty()) return written.number;
  throw sys::InputError(fmt::format("{}: \"{}\" is not a number", what, text));
}

std::string rounded(double number) {
  return fmt::format("{:.6g}", number);
}

std::vector<double> evenly_spaced(double first, double step, int n) {
  const double size = std::max(std::abs(first), std::abs(first + (n - 1) * step));
  std::vector<double> numbers;
  for (int i = 0; i < n; ++i) {
    const double sum = first + i * step;
    // A sum that should be zero is left with the rounding of its terms.
    constexpr double rounding = 1e-14;
    const bool is_zero = std::abs(sum) < rounding * size;
    numbers.push_back(is_zero ? 0 : parse_number("", fmt::format("{:.15g}", sum)));
  }
  return numbers;
}

CurvePoints read_curve(const std::string& file, const std::string& heading, std::size_t fewest) {
  const std::string text = text_of(file);
  const std::vector<Line> lines = lines_of(text);
  std::string found(lines.empty() ? "" : sys::stripped(lines[0].text));
  std::erase(found, ' ');
  if (found != heading) {
    throw sys::InputError(fmt::format("{}:{}: the heading must be {}", file,
                                      lines.empty() ? 1 : lines[0].number, heading));
  }
  CurvePoints points;
  for (const Line& line : std::span(lines).subspan(1)) {
    const std::vector<double> numbers = numbers_of(file, line);
    if (numbers.size() != 2) {
      throw sys::InputError(fmt::format("{}:{}: expected 2 numbers ({}), found {}", file,
                                        line.number, heading, numbers.size()));
    }
    if (!points.x.empty() && !(numbers[0] > points.x.back())) {
      throw sys::InputError(fmt::format("{}:{}: x = {}: must be greater than the x before it, {}",
                                        file, line.number, numbers[0], points.x.back()));
    }
    points.x.push_back(numbers[0]);
    points.y.push_back(numbers[1]);
  }
  if (points.x.size() < fewest) {
    throw sys::InputError(
        fmt::format("{}: expected at least {} points, found {}", file, fewest, points.x.size()));
  }
  return points;
}

Eigen::ArrayXXd read_grid(const std::string& file) {
  const std::string text = text_of(file);
  const std::vector<Line> lines = lines_of(text);
  std::vector<std::vector<double>> rows;
  for (const Line& line : lines) {
    rows.push_back(numbers_of(file, line));
    if (rows.back().size() != rows.front().size()) {
      throw sys::InputError(fmt::format("{}:{}: expected {} numbers as in line {}, found {}", file,
                                        line.number, rows[0].size(), lines[0].number,
                                        rows.back().size()));
    }
  }
  constexpr std::size_t fewest = 4;
  const std::size_t width = rows.empty() ? 0 : rows[0].size();
  if (rows.size() < fewest || width < fewest) {
    throw sys::InputError(
        fmt::format("{}: expected at least {} lines of {} numbers, found {} of {}", file, fewest,
                    fewest, rows.size(), width));
  }
  Eigen::ArrayXXd grid(width, rows.size());
  for (std::size_t j = 0; j < rows.size(); ++j) {
    grid.col(static_cast<Eigen::Index>(j)) =
        Eigen::Map<const Eigen::ArrayXd>(rows[j].data(), static_cast<Eigen::Index>(width));
  }
  return grid;
}

}  // namespace app
