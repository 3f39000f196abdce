// SPDX-License-Identifier: GPL-3.0-or-later
// What a command has found. The text for people, CSV and JSON follow from it. A number may be
// infinite, or have no limit and so be NaN: CSV then has inf or nan, and JSON null.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {

using Json = nlohmann::ordered_json;

/// A column of a table: numbers, or texts.
struct Column {
  std::string key;                      ///< in CSV and JSON; empty if only people see it
  std::vector<std::string> heads = {};  ///< lines above it for people; none if they do not see it
  std::vector<double> numbers = {};
  std::vector<std::string> cells = {};  ///< what people read; a column of texts has only these
};

using Table = std::vector<Column>;

/// One number of a result, with that of the closed form beside it, if there is one.
struct Quantity {
  std::string key;  ///< in JSON, where two numbers of one key are an array
  std::string label;
  std::string unit;
  double value;
  std::optional<double> exact = std::nullopt;
};

/// What JSON has of a table: an array for each column, an array of rows and nothing else, or
/// nothing at all.
enum class InJson { columns, rows, nothing };

struct Result {
  std::vector<Quantity> quantities = {};
  int digits = 7;         ///< significant ones of the quantities, for people
  bool is_hertz = false;  ///< whether the closed forms are Hertz's
  Json details = {};      ///< what else JSON has
  Table table = {};       ///< the CSV, and for people the columns with heads
  InJson table_in_json = InJson::columns;
  Json units = {};                      ///< in JSON: of keys, or of kinds of keys
  std::vector<std::string> notes = {};  ///< lines below what people read
  std::vector<std::string> warnings = {};
};

/// A column that people read too, aligned, with as many decimals as give `largest` this many
/// significant digits. If that is large or small, all numbers are divided by a power of ten that
/// stands before the unit. Infinite is "infinite", NaN "no limit".
Column aligned_column(const std::string& key, const std::vector<std::string>& heads,
                      const std::string& unit, std::vector<double> numbers, double largest,
                      int digits);

/// The greatest magnitude among the finite numbers.
double greatest(const std::vector<double>& numbers);

/// A column of places, with six digits of each at most.
Column column_of_places(const std::string& key, const std::string& unit,
                        std::vector<double> numbers);

/// Significant digits of a number with this relative error, from 3 to `most`.
int earned_digits(double rel_error, int most);

/// Throws sys::InputError naming a number that has overflowed.
void require_finite(const std::string& what, double number);

/// Quantities beside their closed forms, table, and notes, in 80 columns.
std::string text_of(const Result& result);

/// A header and one line per row, numbers with the shortest digits that read back.
std::string csv_of(const Table& table);

/// Quantities, closed forms, details, columns and units under their keys, with such digits too.
std::string json_of(const Result& result);

/// The numbers at the nodes, for a column.
std::vector<double> to_vector(const Eigen::VectorXd& numbers);

}  // namespace app
