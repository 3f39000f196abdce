// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output.hpp"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

#include "command_line/exit_codes.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr const char* group = "Input and output";

const std::map<std::string, std::string>& terminals() {
  static const std::map<std::string, std::string> by_ending = {
      {"-", "dumb noenhanced size 79, 25"},
      {".svg", "svg noenhanced size 700, 450 dynamic background '#ffffff' font 'Helvetica,16'"},
      {".png", "pngcairo noenhanced size 1050, 675 font 'Helvetica,18'"},
      {".pdf", "pdfcairo noenhanced size 14 cm, 9 cm font 'Helvetica,12'"}};
  return by_ending;
}

std::string ending_of(const std::string& where) {
  return where == "-" ? where : fs::path(where).extension().string();
}

// Quotes a text for gnuplot.
std::string quoted(const std::string& text) {
  std::string quoted;
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return "'" + quoted + "'";
}

void set_up(Gnuplot& gnuplot, const Picture& picture, const std::string& terminal, bool is_text) {
  gnuplot << "set terminal " << terminal << "\n"
          << "set encoding utf8\n"
          << "set grid\n"
          << "set xlabel " << quoted(picture.x_label) << "\n"
          << "set key outside top center horizontal\n"
          << "set style line 1 linewidth 2 linecolor rgb '#1f5f99'\n"
          << "set style line 2 linewidth 2 linecolor rgb '#b5541c'\n"
          << "set style line 3 linewidth 2 linecolor rgb '#3a7d44'\n";
  if (is_text) {
    // A terminal cannot print vertical text, so the label of the y axis goes above it.
    gnuplot << "set label 1 " << quoted(picture.y_label) << " at graph 0, screen 0.95\n"
            << "set tmargin 4\nset key width 4\n";
  } else {
    gnuplot << "set ylabel " << quoted(picture.y_label) << "\n";
  }
}

void plot(Gnuplot& gnuplot, const std::vector<Curve>& curves, bool is_text) {
  int i = 0;
  for (const Curve& curve : curves) {
    ++i;
    gnuplot << (i == 1 ? "plot " : ", ") << "'-' with "
            << (curve.is_line ? fmt::format("lines linestyle {}", i)
                : is_text     ? std::string("points pointtype '*'")
                              : fmt::format("points linestyle {} pointtype 6 pointsize 0.6", i))
            << " title " << quoted(curve.title);
  }
  gnuplot << "\n";
  for (const Curve& curve : curves) gnuplot.send1d(std::make_pair(curve.x, curve.y));
}

// Rejects a picture that cannot be drawn, before anything is computed.
void require_drawable(const Flag& where) {
  if (!terminals().contains(ending_of(where.text()))) {
    where.refuse("must end with .svg, .png or .pdf, or be -");
  }
  const fs::path folder = fs::path(where.text()).parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) where.refuse("folder does not exist");
}

// Draws the picture.
void draw(const Picture& picture, const std::string& where) {
  const bool is_text = where == "-";
  std::error_code ignored;
  if (!is_text) fs::remove(where, ignored);
  std::fflush(stdout);  // gnuplot writes to the same terminal
  {
    // Default settings ignore the user's ~/.gnuplot. The dumb terminal starts with a form feed and
    // does not end its last line.
    const std::string program =
        "LC_ALL=C.UTF-8 '" + sys::find_tool("gnuplot").string() + "' --default-settings";
    Gnuplot gnuplot(is_text ? program + " | tr -d '\\f'; echo" : program);
    set_up(gnuplot, picture, terminals().at(ending_of(where)), is_text);
    if (!is_text) gnuplot << "set output " << quoted(where) << "\n";
    plot(gnuplot, picture.curves, is_text);
  }
  if (!is_text && !fs::exists(where, ignored)) {
    throw sys::ToolError(fmt::format("gnuplot could not draw {}", where));
  }
}

// Without an allocation per number, a million take a tenth of a second. Adding 0 drops the sign of
// a zero.
void append(std::string& text, double number) {
  std::array<char, 32> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number + 0.0);
  text.append(digits.data(), result.ptr);
}

void append_json(std::string& text, double number) {
  if (std::isfinite(number)) {
    append(text, number);
  } else {
    text += "null";
  }
}

void append_json(std::string& text, const std::vector<double>& numbers) {
  text += '[';
  for (const double& number : numbers) {
    if (&number != numbers.data()) text += ", ";
    append_json(text, number);
  }
  text += ']';
}

// nlohmann's own dump() misses the shortest digits about once in a thousand numbers.
void append_json(std::string& text, const Json& value, const std::string& indent) {
  if (value.is_number_float()) return append_json(text, value.get<double>());
  if (!value.is_structured()) {
    text += value.dump();
    return;
  }
  if (value.is_array() && !value.empty() && value[0].is_number()) {
    return append_json(text, value.get<std::vector<double>>());
  }
  const bool is_on_one_line = !value.empty() && value.front().is_string();  // the units
  const std::string separator = is_on_one_line ? " " : "\n" + indent + "  ";
  text += value.is_object() ? '{' : '[';
  bool is_first = true;
  for (const auto& [key, element] : value.items()) {
    if (!is_first) text += ',';
    if (!is_first || !is_on_one_line) text += separator;
    if (value.is_object()) text += Json(key).dump() + ": ";
    append_json(text, element, indent + "  ");
    is_first = false;
  }
  if (!is_first && !is_on_one_line) text += "\n" + indent;
  text += value.is_object() ? '}' : ']';
}

std::size_t n_rows_of(const Table& table) {
  std::size_t n = 0;
  for (const Column& column : table) n = std::max({n, column.numbers.size(), column.cells.size()});
  return n;
}

Table table_of(const Result& result) {
  Column labels{.key = "", .heads = {""}};
  Column values{.key = "", .heads = {"elements"}, .numbers = {0}};
  Column exact{.key = "", .heads = {result.is_hertz ? "Hertz" : ""}, .numbers = {0}};
  Column differences{.key = "", .heads = {result.is_hertz ? "difference" : ""}, .numbers = {0}};
  for (const Quantity& quantity : result.quantities) {
    labels.cells.push_back(fmt::format("{} ({})", quantity.label, quantity.unit));
    values.cells.push_back(fmt::format("{:.{}g}", quantity.value, result.digits));
    exact.cells.emplace_back();
    differences.cells.emplace_back();
    if (!quantity.exact) continue;
    exact.cells.back() = fmt::format("{:.7g}", *quantity.exact);
    const double percent = 100 * std::abs(quantity.value / *quantity.exact - 1);
    constexpr double rounding = 1e-10;
    differences.cells.back() = fmt::format("{:.1g} %", percent < rounding ? 0 : percent);
  }
  return {labels, values, exact, differences};
}

std::string text_of(const Table& table) {
  std::vector<std::string> lines;
  for (const Column& column : table) {
    if (column.heads.empty()) continue;
    std::vector<std::string> cells = column.heads;
    cells.insert(cells.end(), column.cells.begin(), column.cells.end());
    lines.resize(cells.size());
    std::size_t width = 0;
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (&column != table.data()) lines[i] += "  ";
      lines[i] += column.numbers.empty() ? fmt::format("{:<{}}", cells[i], width)
                                         : fmt::format("{:>{}}", cells[i], width);
    }
  }
  std::string text;
  for (const std::string& line : lines)
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  return text;
}

// Two numbers with one key form an array.
void add(Json& json, const std::string& key, double number) {
  if (json.contains(key)) {
    json[key] = {json[key], number};
  } else {
    json[key] = number;
  }
}

Json rows_of(const Result& result) {
  Json rows = Json::array();
  for (std::size_t i = 0, n = n_rows_of(result.table); i < n; ++i) {
    rows.emplace_back();
    for (const Column& column : result.table) {
      if (!column.key.empty()) rows.back()[column.key] = column.numbers[i];
    }
    rows.back()["units"] = result.units;
  }
  return rows;
}

}  // namespace

Output::Output(CLI::App& command, const std::string& tables)
    : case_(command, "--case", "FILE", group,
            "A case file (TOML) with " + tables + "; flags override it"),
      units_(command, "--units", {"mm-N", "m-N", "in-lbf"}, group,
             "System of units of the result and of plain numbers: mm, N, MPa; m, N, Pa; in, lbf, "
             "psi [mm-N, or the case's]"),
      format_(command, "--format", {"table", "csv", "json"}, group,
              "Output format: a rounded table, or CSV or JSON with all digits [table]"),
      plot_(command, "--plot", "FILE", group,
            "Draw the result in a .svg, .png or .pdf file; - draws it in the terminal") {}

Given Output::given() const {
  Given given{std::nullopt, config::unit_system(units_.text_or("mm-N"))};
  if (plot_.text() == "-" && format() != "table") {
    plot_.refuse("needs --format table; the plot is printed below the table");
  }
  if (plot_.is_given()) require_drawable(plot_);
  if (!case_.is_given()) return given;
  given.file.emplace(case_.text());
  const config::UnitSystem& of_case = given.file->units();
  if (units_.is_given() && units_.text() != of_case.name)
    units_.refuse("the case is in " + of_case.name);
  given.units = of_case;
  return given;
}

void Output::print(const Result& result, const std::function<Picture()>& picture) const {
  const std::string text = format() == "csv"    ? csv_of(result.table)
                           : format() == "json" ? json_of(result)
                                                : text_of(result);
  for (const std::string& warning : result.warnings) {
    fmt::print(stderr, "{}: warning: {}\n", command_line::program_name(), warning);
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (plot_.is_given()) draw(picture(), plot_.text());
}

Curve line(const std::string& title, double begin, double end,
           const std::function<double(double)>& value) {
  constexpr int n = 400;
  Curve curve{title, true, {}, {}};
  for (int i = 0; i <= n; ++i) {
    curve.x.push_back(begin + (end - begin) * i / n);
    curve.y.push_back(value(curve.x.back()));
  }
  return curve;
}

Column aligned_column(const std::string& key, const std::vector<std::string>& heads,
                      const std::string& unit, std::vector<double> numbers, double largest,
                      int digits) {
  const int place = largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  constexpr int least_place = -2, greatest_place = 5;
  const bool is_scaled = place < least_place || place > greatest_place;
  const int exponent = is_scaled ? 3 * static_cast<int>(std::floor(place / 3.0)) : 0;
  const double factor = std::pow(10.0, -exponent);
  const int n_decimals = std::max(0, digits - 1 - (place - exponent));

  const std::string power = is_scaled ? fmt::format("1e{}", exponent) : "";
  const bool is_alone = is_scaled && unit == "1";
  Column column{.key = key, .heads = heads, .numbers = std::move(numbers)};
  column.heads.push_back("[" + power + (is_alone ? "" : is_scaled ? " " + unit : unit) + "]");
  for (const double number : column.numbers) {
    std::string cell = fmt::format("{:.{}f}", number * factor, n_decimals);
    if (cell.find_first_of("123456789") == std::string::npos && cell[0] == '-') cell.erase(0, 1);
    if (std::isinf(number)) cell = number < 0 ? "-infinite" : "infinite";
    if (std::isnan(number)) cell = "no limit";
    column.cells.push_back(cell);
  }
  return column;
}

double greatest(const std::vector<double>& numbers) {
  double greatest = 0;
  for (const double number : numbers) {
    if (std::isfinite(number)) greatest = std::max(greatest, std::abs(number));
  }
  return greatest;
}

Column column_of_places(const std::string& key, const std::string& unit,
                        std::vector<double> numbers) {
  Column column{.key = key, .heads = {key, "", "[" + unit + "]"}, .numbers = std::move(numbers)};
  for (const double number : column.numbers) column.cells.push_back(rounded(number));
  return column;
}

int earned_digits(double rel_error, int most) {
  constexpr double fewest = 3;
  if (!(rel_error > 0)) return most;
  return static_cast<int>(std::clamp(std::ceil(-std::log10(rel_error)), fewest, double(most)));
}

std::string text_of(const Result& result) {
  std::string text = result.quantities.empty() ? "" : text_of(table_of(result));
  text += text_of(result.table);
  for (const std::string& note : result.notes) text += note + '\n';
  return text;
}

std::string csv_of(const Table& table) {
  std::string text;
  std::vector<const Column*> columns;
  for (const Column& column : table) {
    if (column.key.empty()) continue;
    text += (columns.empty() ? "" : ",") + column.key;
    columns.push_back(&column);
  }
  text += '\n';
  constexpr std::size_t usual_cell = 22;
  const std::size_t n_rows = n_rows_of(table);
  text.reserve(text.size() + usual_cell * columns.size() * n_rows);
  for (std::size_t i = 0; i < n_rows; ++i) {
    for (const Column* column : columns) {
      if (column != columns.front()) text += ',';
      if (column->numbers.empty()) {
        text += column->cells[i];
      } else {
        append(text, column->numbers[i]);
      }
    }
    text += '\n';
  }
  return text;
}

std::string json_of(const Result& result) {
  std::string text;
  if (result.quantities.empty() && result.details.empty()) {
    append_json(text, rows_of(result), "");
    text += '\n';
    return text;
  }
  Json json, hertz;
  for (const Quantity& quantity : result.quantities) {
    add(json, quantity.key, quantity.value);
    if (quantity.exact) add(hertz, quantity.key, *quantity.exact);
  }
  if (result.is_hertz) json["hertz"] = hertz;
  json.update(result.details);
  json["units"] = result.units;
  append_json(text, json, "");
  // Columns may be long, so they bypass the tree of values.
  constexpr std::size_t usual_number = 22;
  text.resize(text.size() - 2);
  text.reserve(text.size() + usual_number * result.table.size() * n_rows_of(result.table));
  for (const Column& column : result.table) {
    text += fmt::format(",\n  \"{}\": ", column.key);
    append_json(text, column.numbers);
  }
  text += "\n}";
  text += '\n';
  return text;
}

std::vector<double> to_vector(const Eigen::VectorXd& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

}  // namespace app
