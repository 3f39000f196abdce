// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a command, printed as a table, CSV or JSON, and its picture; the flags of all
// commands. A number may be infinite, or NaN where it has no limit; CSV prints inf or nan, JSON
// null.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/flags.hpp"
#include "config/units.hpp"
#include "parameters/case.hpp"

namespace app {

using Json = nlohmann::ordered_json;

/// A column of a table: numbers or texts.
struct Column {
  std::string key;                      ///< in CSV and JSON; empty for a column of the text only
  std::vector<std::string> heads = {};  ///< heading lines in the text; empty if not in the text
  std::vector<double> numbers = {};
  std::vector<std::string> cells = {};  ///< in the text; a column of texts has only these
};

using Table = std::vector<Column>;

/// One number of a result, with its closed form if there is one.
struct Quantity {
  std::string key;  ///< in JSON, where two numbers with one key form an array
  std::string label;
  std::string unit;
  double value;
  std::optional<double> exact = std::nullopt;
};

struct Result {
  std::vector<Quantity> quantities = {};
  int digits = 7;                       ///< significant digits of the quantities in the text
  bool is_hertz = false;                ///< whether the closed forms are Hertz's
  Json details = {};                    ///< further entries of the JSON
  Table table = {};                     ///< the CSV; the text has its columns with heads
  Json units = {};                      ///< in JSON: unit of each key or kind of key
  std::vector<std::string> notes = {};  ///< lines below the text
  std::vector<std::string> warnings = {};
};

/// A column aligned for the text, with as many decimals as give `largest` this many significant
/// digits. If `largest` is very large or small, all numbers are divided by a power of ten that
/// precedes the unit. Infinity prints as "infinite", NaN as "no limit".
Column aligned_column(const std::string& key, const std::vector<std::string>& heads,
                      const std::string& unit, std::vector<double> numbers, double largest,
                      int digits);

/// The greatest magnitude among the finite numbers.
double greatest(const std::vector<double>& numbers);

/// A column of coordinates, with at most six digits each.
Column column_of_places(const std::string& key, const std::string& unit,
                        std::vector<double> numbers);

/// The significant digits that this relative error supports, from 3 to `most`.
int earned_digits(double rel_error, int most);

/// The text: quantities beside their closed forms, table and notes, in 80 columns.
std::string text_of(const Result& result);

/// A header and one line per row; numbers have the fewest digits that read back exactly.
std::string csv_of(const Table& table);

/// Quantities, closed forms, details, columns and units under their keys. A result with nothing but
/// a table is an array of its rows. Numbers are those of csv_of.
std::string json_of(const Result& result);

/// Copies the numbers at the nodes, for a column.
std::vector<double> to_vector(const Eigen::VectorXd& numbers);

/// A curve of a picture. Both columns have the same length; NaN breaks the curve.
struct Curve {
  std::string title;
  bool is_line;  ///< a line, or else points
  std::vector<double> x, y;
};

/// Curves and the labels of the axes, with their units.
struct Picture {
  std::string x_label, y_label;
  std::vector<Curve> curves;
};

/// A line through the values of a function at 401 points from begin to end.
Curve line(const std::string& title, double begin, double end,
           const std::function<double(double)>& value);

/// The case and the units in which the numbers of a command line are read.
struct Given {
  std::optional<parameters::CaseFile> file;
  config::UnitSystem units;
};

/// The flags --case, --units, --format and --plot.
class Output {
 public:
  /// `tables` lists, for the help, the tables of a case that the command reads.
  Output(CLI::App& command, const std::string& tables);

  /// Reads the case file, if there is one, and the system of units: the case's, else that of
  /// --units, else mm-N. Throws sys::InputError for an error in any of the four flags, before
  /// anything is computed.
  Given given() const;

  /// "table", "csv" or "json".
  std::string format() const { return format_.text_or("table"); }

  /// Prints warnings on standard error and the result in the requested format, then draws the
  /// picture. Throws sys::ToolError if gnuplot fails or is missing.
  void print(const Result& result, const std::function<Picture()>& picture) const;

 private:
  Flag case_;
  Choice units_, format_;
  Flag plot_;
};

}  // namespace app
