// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/imported_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "literate/text/unit.hpp"
#include "literate/values/decimal.hpp"
#include "system/decimal.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

using Rows = std::vector<std::vector<ImportedCell>>;

bool has_exponents(const Rows& rows, std::size_t column) {
  return std::ranges::any_of(rows, [column](const auto& row) {
    const auto* number = std::get_if<WrittenNumber>(&row[column].content);
    return number != nullptr && number->has_exponent;
  });
}

Column column_of(const ImportedColumn& column, bool writes_exponents) {
  require_unit(column.unit);  // its place is that of the file, and not this line
  if (column.is_text) return Column::text(column.heading).named(column.plain);
  const Format format = column.format.value_or(writes_exponents ? scientific(1) : fixed(0));
  Column printed = Column(column.heading, format, column.unit).named(column.plain);
  if (column.exponent != 0) printed = printed.scaled(column.exponent);
  return column.is_exact ? printed.exact() : printed;
}

bool is_integer(const ImportedColumn& column) {
  return column.format && column.format->notation() == Notation::integer;
}

/// Whether the column says how many digits its numbers have.
bool names_digits(const ImportedColumn& column) {
  return column.format && (column.format->notation() == Notation::fixed ||
                           column.format->notation() == Notation::scientific);
}

/// The heading for messages.
const std::string& said(const ImportedColumn& column) {
  return column.plain.empty() ? column.heading : column.plain;
}

/// The power of ten of the last digit that a number of this column is printed with.
int printed_place(const ImportedColumn& column, const WrittenNumber& written) {
  const int digits = column.format->digits();
  return column.format->notation() == Notation::fixed
             ? column.exponent - digits
             : rounded_to_digits(written.number, digits).place;
}

std::optional<Uncertainty> uncertainty_of(const ImportedCell& cell) {
  if (cell.errors.empty()) return std::nullopt;
  const auto has = [&](const char* name) { return cell.errors.contains(name); };
  const auto error = [&](const char* name) { return has(name) ? cell.errors.at(name) : 0; };
  if (has("below") != has("above") || (has("below") && has("abs_error"))) {
    throw ImportError(
        fmt::format("{}: a number has an abs_error, or one below and one above", cell.at));
  }
  Uncertainty uncertainty = has("below") ? Uncertainty::to_sides(error("below"), error("above"))
                                         : Uncertainty(error("abs_error"));
  uncertainty.standard = error("standard");
  return uncertainty;
}

void require_earned(const ImportedColumn& column, const ImportedCell& cell,
                    const WrittenNumber& written) {
  const auto uncertainty = uncertainty_of(cell);
  if (!uncertainty) {
    if (column.is_exact || is_integer(column)) return;
    throw ImportError(
        fmt::format("{}: {} comes without its error: give column '{}' an abs_error or a standard, "
                    "or declare it exact",
                    cell.at, written.text, said(column)));
  }
  if (!names_digits(column)) return;
  const double error = uncertainty->error();
  const int place = printed_place(column, written);
  if (std::pow(10.0, place) < error) {
    throw ImportError(
        fmt::format("{}: {} is printed to the place 1e{}, more digits than its error of "
                    "{} supports",
                    cell.at, round_trip(written.number), place, round_trip(error)));
  }
}

void require_held(const ImportedColumn& column, const ImportedCell& cell,
                  const WrittenNumber& written) {
  const bool prints_all = !column.format || is_integer(column);
  const auto uncertainty = uncertainty_of(cell);
  if (is_held(written, prints_all || !uncertainty ? 0 : uncertainty->error())) return;
  throw ImportError(
      fmt::format("{}: {} has more digits than a number holds: declare column '{}' to be of texts",
                  cell.at, written.text, said(column)));
}

Cell number_cell(const ImportedColumn& column, const ImportedCell& cell,
                 const WrittenNumber& written) {
  if (column.is_text) {
    throw ImportError(fmt::format("{}: {} is a number in the column of texts '{}'", cell.at,
                                  round_trip(written.number), said(column)));
  }
  if (!std::isfinite(written.number)) {
    throw ImportError(fmt::format("{}: the number is not finite", cell.at));
  }
  if (is_integer(column) && std::trunc(written.number) != written.number) {
    throw ImportError(fmt::format("{}: {} is not a whole number, as column '{}' holds", cell.at,
                                  round_trip(written.number), said(column)));
  }
  require_earned(column, cell, written);
  require_held(column, cell, written);
  if (!column.format) {
    return Cell::quoted(written.number, written.place, uncertainty_of(cell));
  }
  if (const auto uncertainty = uncertainty_of(cell)) return {written.number, *uncertainty};
  return written.number;
}

Cell cell_of(const ImportedColumn& column, const ImportedCell& cell) {
  if (const auto* number = std::get_if<WrittenNumber>(&cell.content)) {
    return number_cell(column, cell, *number);
  }
  const auto* text = std::get_if<std::string>(&cell.content);
  if (text == nullptr) return {};
  if (!column.is_text) {
    throw ImportError(fmt::format("{}: '{}' is not a number, as column '{}' holds", cell.at, *text,
                                  said(column)));
  }
  return {*text};
}

}  // namespace

std::optional<WrittenNumber> written_number(std::string_view text) {
  const auto decimal = sys::parse_decimal(text);
  if (!decimal) return std::nullopt;
  if (text.starts_with('+')) text.remove_prefix(1);
  return WrittenNumber{.number = number_of(*decimal),
                       .place = decimal->place,
                       .has_exponent = text.find_first_of("eE") != text.npos,
                       .text = std::string(text)};
}

bool is_held(const WrittenNumber& written, double error) {
  const double size = std::abs(written.number);
  if (error >= std::nextafter(size, std::numeric_limits<double>::infinity()) - size && error > 0) {
    return true;
  }
  return rounded_to_place(written.number, written.place).digits ==
         sys::parse_decimal(written.text)->digits;
}

Table table_of(const std::string& name, const std::vector<ImportedColumn>& columns,
               const Rows& rows, const std::string& at) {
  if (columns.empty()) throw ImportError(at + ": a table needs a column");
  std::string place = at;
  try {
    std::vector<Column> printed;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      place = columns[i].at.empty() ? at : columns[i].at;
      printed.push_back(column_of(columns[i], has_exponents(rows, i)));
    }
    place = at;
    Table table(name, printed);
    for (const auto& row : rows) {
      std::vector<Cell> cells;
      for (std::size_t i = 0; i < row.size(); ++i) cells.push_back(cell_of(columns[i], row[i]));
      table.add_row(std::move(cells));
    }
    return table;
  } catch (const std::invalid_argument& error) {
    throw ImportError(fmt::format("{}: {}", place, error.what()));
  }
}

namespace fs = std::filesystem;
namespace {

std::string name_below(const fs::path& root, const fs::path& file) {
  const fs::path whole = fs::weakly_canonical(file);
  std::string name = sys::name_below(fs::weakly_canonical(root), whole)
                         .value_or(whole.filename().generic_string());
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+.,=/-";
  if (name.find_first_not_of(allowed) != name.npos) {
    throw ImportError(fmt::format(
        "{}: the name must be letters, digits and _ + . , = / -, to be attached to the document",
        file.string()));
  }
  return name;
}

}  // namespace

std::string read_numbers(const fs::path& file) {
  try {
    return sys::read_file(file);
  } catch (const sys::OutputError&) {
    throw ImportError(fmt::format("{}: the file cannot be read", file.string()));
  }
}

NumbersAndScript with_script(const fs::path& file, std::string text, const fs::path& script,
                             const fs::path& root) {
  std::string script_text;
  try {
    script_text = sys::read_file(script);
  } catch (const sys::OutputError&) {
    throw ImportError(
        fmt::format("{}: its script '{}' cannot be read", file.string(), script.string()));
  }
  return {{name_below(root, file), std::move(text), "numbers of another program"},
          {name_below(root, script), std::move(script_text), "script of such numbers"}};
}

}  // namespace literate
