// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line/number_text.hpp"

#include <fmt/core.h>
#include <CLI/StringTools.hpp>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <system_error>

namespace command_line {

double parse_number(const std::string& what, const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (text.starts_with('+') && !text.starts_with("+-")) ++begin;
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error == std::errc::result_out_of_range) {
    throw sys::InputError(fmt::format("{}: \"{}\" is beyond the range of a double", what, text));
  }
  if (error != std::errc() || stop != end) {
    throw sys::InputError(fmt::format("{}: \"{}\" is not a number", what, text));
  }
  if (!std::isfinite(number)) {
    throw sys::InputError(fmt::format("{} = {}: must be a finite number", what, text));
  }
  return number;
}

std::vector<double> parse_numbers(const std::string& what, const std::string& text) {
  std::vector<double> numbers;
  for (std::string element : CLI::detail::split(text, ',')) {
    numbers.push_back(parse_number(what, CLI::detail::trim(element)));
  }
  if (text.empty() || text.back() == ',') throw sys::InputError(what + ": a number is missing");
  return numbers;
}

std::vector<double> read_numbers(const std::string& file) {
  std::ifstream opened;
  if (file != "-") opened.open(file);
  std::istream& stream = file == "-" ? std::cin : opened;
  if (!stream) throw sys::InputError(file + ": cannot be read");
  std::vector<double> numbers;
  std::string line;
  for (int n = 1; std::getline(stream, line); ++n) {
    CLI::detail::trim(line);
    if (line.empty() || line.front() == '#') continue;
    numbers.push_back(parse_number(fmt::format("{}:{}", file == "-" ? "<stdin>" : file, n), line));
  }
  if (stream.bad()) throw sys::InputError(file + ": cannot be read");
  if (numbers.empty()) throw sys::InputError(file + ": holds no number");
  return numbers;
}

double finite_result(const std::string& what, double result) {
  if (std::isfinite(result)) return result;
  throw sys::InputError(what +
                        ": not a finite number; the parameters are beyond the range of a double");
}

std::string shortest(double number) {
  return fmt::format("{}", number);
}

}  // namespace command_line
