// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/figure.hpp"

#include <fmt/core.h>
#include <gnuplot-iostream.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <locale>
#include <memory>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

void require_identifier(const std::string& name) {
  const bool is_identifier =
      !name.empty() && !sys::is_digit(name.front()) &&
      std::ranges::all_of(name, [](char c) { return sys::is_alphanumeric(c) || c == '_'; });
  if (is_identifier) return;
  throw std::invalid_argument(fmt::format(
      "'{}' cannot be a gnuplot variable: use letters, digits and '_', and no digit first", name));
}

// Only the bits of a NaN distinguish a gap from the NaN of a computation.
bool is_gap(double number) {
  return std::bit_cast<std::uint64_t>(number) == std::bit_cast<std::uint64_t>(gap);
}

void require_columns(const std::string& block, const FigureData& data) {
  const auto refuse = [&block](const std::string& why) {
    throw std::invalid_argument(fmt::format("data '{}' {}", block, why));
  };
  if (data.columns.empty() || data.columns.front().second.empty()) refuse("has no points");
  const auto& [first_name, first] = data.columns.front();
  for (const auto& [name, numbers] : data.columns) {
    require_identifier(name);
    if (numbers.size() != first.size()) {
      refuse(fmt::format("has {} points in column '{}' and {} in '{}'", first.size(), first_name,
                         numbers.size(), name));
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (std::isfinite(numbers[i]) || is_gap(numbers[i])) continue;
      refuse(fmt::format("has {} as point {} of column '{}': must be finite, or literate::gap",
                         numbers[i], i + 1, name));
    }
  }
}

/// Captures the commands that `write` sends to gnuplot.
template <typename Write>
std::string sent(Write&& write) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  if (!file) throw sys::OutputError("cannot make a temporary file for the data of a figure");
  {
    gnuplotio::Gnuplot script(::fdopen(::dup(::fileno(file.get())), "w"));  // closes the copy
    script.imbue(std::locale::classic());
    write(script);
  }
  return sys::read_file(fmt::format("/proc/self/fd/{}", ::fileno(file.get())));
}

// gnuplot reads a number without point or exponent as an integer, and computes 1/2 = 0 from it.
std::string floating_point(double number) {
  const std::string text = round_trip(number);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

// A script may set a different decimal sign, and gnuplot would then read 1.25 in the data as 1. An
// integer with an exponent, 125e-2, has no decimal sign.
std::string without_sign(double number) {
  if (std::isnan(number)) return "NaN";
  constexpr int most_plain = 5;
  const Decimal digits = shortest(number);
  if (digits.place >= 0 && leading_place(digits) <= most_plain) return plain(digits);
  return fmt::format("{}{}e{}", digits.negative ? "-" : "", digits.digits, digits.place);
}

// Inside single quotes gnuplot needs only the quote itself doubled.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

}  // namespace

void require_drawable(const Figure& figure) {
  const bool has_size = figure.width_cm > 0 && figure.height_cm > 0 &&
                        std::isfinite(figure.width_cm) && std::isfinite(figure.height_cm);
  if (!has_size) {
    throw std::invalid_argument(fmt::format("its size is {} cm by {} cm: both must be positive",
                                            figure.width_cm, figure.height_cm));
  }
  for (const auto& [block, data] : figure.data) {
    require_identifier(block);
    require_columns(block, data);
  }
  for (const auto& [name, number] : figure.numbers) {
    require_identifier(name);
    if (std::isfinite(number)) continue;
    throw std::invalid_argument(fmt::format("the number '{}' is {}", name, number));
  }
  for (const auto& [name, text] : figure.texts) {
    require_identifier(name);
    require_utf8(text);
  }
}

std::string figure_prelude(const std::string& name, const Figure& figure) {
  return sent([&](std::ostream& script) {
    script << "# Data of the figure " << name << ", which gnuplot reads before its script.\n"
           << "set encoding utf8\nset decimalsign '.'\nset datafile separator comma\n"
           << "width_cm = " << floating_point(figure.width_cm) << "\n"
           << "height_cm = " << floating_point(figure.height_cm) << "\n"
           << "set terminal cairolatex pdf size width_cm cm, height_cm cm\n"
           << "set output '" << name << ".tex'\n";
    for (const auto& [block, data] : figure.data) script << block << " = '" << block << ".csv'\n";
    for (const auto& [key, number] : figure.numbers) {
      script << key << " = " << floating_point(number) << "\n";
    }
    for (const auto& [key, text] : figure.texts) script << key << " = " << quoted(text) << "\n";
  });
}

std::string figure_csv(const FigureData& data) {
  return sent([&](std::ostream& file) {
    const auto write_row = [&](auto&& cell) {
      const char* separator = "";
      for (const FigureData::Column& column : data.columns) {
        file << std::exchange(separator, ",") << cell(column);
      }
      file << '\n';
    };
    write_row([](const FigureData::Column& column) { return column.first; });
    const std::size_t n_points = data.columns.front().second.size();
    for (std::size_t i = 0; i < n_points; ++i) {
      if (i > 0 && data.row_length > 0 && i % data.row_length == 0) file << '\n';
      write_row([i](const FigureData::Column& column) { return without_sign(column.second[i]); });
    }
  });
}

}  // namespace literate
