// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/figure.hpp"

#include <fmt/core.h>
#include <gnuplot-iostream.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <locale>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "literate/values/decimal.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

void require_identifier(const std::string& name) {
  static const sys::Pattern identifier("[A-Za-z_][A-Za-z0-9_]*");
  if (identifier.is_all_of(name)) return;
  throw std::logic_error(
      fmt::format("'{}' is no name of a variable: letters, digits and '_', no digit first", name));
}

// A gap is told from other NaN by its bits.
void require_finite_or_gap(double number, const std::string& what) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  if (std::isfinite(number) || bits == std::bit_cast<std::uint64_t>(gap)) return;
  throw std::logic_error(
      fmt::format("{} is {}: must be finite, or literate::gap where no point is", what, number));
}

void require_columns(const std::string& block, const FigureData& data) {
  if (data.columns.empty()) throw std::logic_error(fmt::format("data '{}' has no columns", block));
  const auto& [first_name, first] = data.columns.front();
  if (first.empty()) throw std::logic_error(fmt::format("data '{}' has no points", block));
  std::set<std::string> names;
  for (const auto& [name, numbers] : data.columns) {
    require_identifier(name);
    if (!names.insert(name).second) {
      throw std::logic_error(fmt::format("data '{}' has two columns '{}'", block, name));
    }
    if (numbers.size() != first.size()) {
      throw std::logic_error(fmt::format("data '{}': column '{}' has {} points and '{}' has {}",
                                         block, first_name, first.size(), name, numbers.size()));
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      require_finite_or_gap(numbers[i],
                            fmt::format("data '{}': column '{}', point {}", block, name, i + 1));
    }
  }
  if (data.row_length == 0 || first.size() % data.row_length == 0) return;
  throw std::logic_error(fmt::format("data '{}': {} points do not make rows of {}", block,
                                     first.size(), data.row_length));
}

// gnuplot takes a number without point and exponent for an integer, of which 1/2 is 0.
std::string floating_point(double number) {
  if (std::isnan(number)) return "NaN";
  const std::string text = round_trip(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

// In gnuplot's single quotes a quote is doubled and nothing else is special.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

std::string csv(const FigureData& data) {
  std::string text;
  const auto add_row = [&](auto&& cell) {
    for (std::size_t c = 0; c < data.columns.size(); ++c) {
      text += (c == 0 ? "" : ",") + cell(data.columns[c]);
    }
    text += '\n';
  };
  add_row([](const FigureData::Column& column) { return column.first; });
  const std::size_t n_points = data.columns.front().second.size();
  for (std::size_t i = 0; i < n_points; ++i) {
    if (i > 0 && data.row_length > 0 && i % data.row_length == 0) text += '\n';
    add_row([i](const FigureData::Column& column) { return round_trip(column.second[i]); });
  }
  return text;
}

void write_prelude(std::ostream& script, const std::string& name, const Figure& figure,
                   const Canvas& canvas) {
  script << "# What the program says about figure " << name << "; gnuplot " << name
         << ".gp draws it.\nset encoding utf8\n"
         << "if (!exists('height_cm')) height_cm = exists('width_cm') ? width_cm * "
         << floating_point(figure.height_cm) << " / " << floating_point(figure.width_cm) << " : "
         << floating_point(figure.height_cm) << "\n"
         << "if (!exists('width_cm')) width_cm = " << floating_point(figure.width_cm) << "\n"
         << "set terminal " << canvas.terminal << "\n"
         << "set output '" << name << canvas.ending << "'\n"
         << "set datafile separator comma\n";
  for (const auto& [block, data] : figure.data) script << block << " = '" << block << ".csv'\n";
  for (const auto& [key, number] : figure.numbers) {
    script << key << " = " << floating_point(number) << "\n";
  }
  for (const auto& [key, text] : figure.texts) script << key << " = " << quoted(text) << "\n";
  script << "load '../style.gp'\nload 'script.gp'\nunset output\n";
}

}  // namespace

void require_drawable(const Figure& figure) {
  if (!(figure.width_cm > 0) || !(figure.height_cm > 0)) {
    throw std::logic_error(
        fmt::format("a size of {} cm by {} cm is not positive", figure.width_cm, figure.height_cm));
  }
  std::set<std::string> names = {"width_cm", "height_cm"};
  const auto require_name = [&](const std::string& name) {
    require_identifier(name);
    if (!names.insert(name).second) {
      throw std::logic_error(fmt::format("the name '{}' is given twice", name));
    }
  };
  for (const auto& [block, data] : figure.data) {
    require_name(block);
    require_columns(block, data);
  }
  for (const auto& [name, number] : figure.numbers) {
    require_name(name);
    require_finite_or_gap(number, fmt::format("number '{}'", name));
  }
  for (const auto& [name, text] : figure.texts) {
    require_name(name);
    if (text.find('\n') != std::string::npos) {
      throw std::logic_error(fmt::format("text '{}' has more than one line", name));
    }
  }
}

void write_figure(const fs::path& folder, const std::string& name, const Figure& figure,
                  const Canvas& canvas) {
  for (const auto& [block, data] : figure.data) {
    sys::write_file_atomically(folder / (block + ".csv"), csv(data));
  }
  const fs::path file = folder / (name + ".gp");
  try {
    fs::create_directories(folder);
    gnuplotio::Gnuplot script(fmt::format(">{}", file.string()));
    script.imbue(std::locale::classic());
    write_prelude(script, name, figure, canvas);
    script.flush();
    if (script) return;
  } catch (const std::ios_base::failure&) {
    // The stream does not tell why, and takes half a write for a failure. So it is written once
    // more.
  } catch (const fs::filesystem_error&) {
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  write_prelude(text, name, figure, canvas);
  sys::write_file_atomically(file, text.str());
}

}  // namespace literate
