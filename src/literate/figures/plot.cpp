// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/plot.hpp"

#include <fmt/core.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <locale>
#include <stdexcept>
#include <utility>

#include "literate/text/name.hpp"
#include "literate/values/decimal.hpp"
#include "system/error.hpp"

namespace literate {
namespace {

/// A number that is written so that it reads back the same. Of a double, gnuplot-iostream would
/// write six digits, as the global locale has them.
struct RoundTrip {
  double number;
};

std::ostream& operator<<(std::ostream& stream, RoundTrip value) {
  return stream << round_trip(value.number);
}

std::vector<std::vector<RoundTrip>> round_trip_columns(
    const std::vector<std::span<const double>>& columns) {
  std::vector<std::vector<RoundTrip>> result;
  for (const auto& column : columns) {
    if (column.size() != columns.front().size()) {
      throw std::invalid_argument(fmt::format("columns to plot have {} and {} rows",
                                              columns.front().size(), column.size()));
    }
    auto& numbers = result.emplace_back();
    for (const double number : column) numbers.push_back({number});
  }
  return result;
}

}  // namespace

struct Plot::Script {
  explicit Script(const std::filesystem::path& file) : gnuplot(fmt::format(">{}", file.string())) {
    gnuplot.imbue(std::locale::classic());
  }
  gnuplotio::Gnuplot gnuplot;
};

Plot::Plot(std::filesystem::path folder, std::string name, double width_cm, double height_cm)
    : folder_(std::move(folder)), name_(std::move(name)) {
  const std::filesystem::path file = folder_ / (name_ + ".gp");
  try {
    script_ = std::make_unique<Script>(file);
  } catch (const std::ios_base::failure&) {
    throw sys::OutputError(fmt::format("cannot write '{}'", file.string()));
  }
  *this << "set encoding utf8\n"
        << "set terminal cairolatex pdf size " << width_cm << "cm," << height_cm << "cm\n"
        << "set output '" << name_ << ".tex'\n";
}

Plot::~Plot() = default;

std::string Plot::data(std::string_view suffix,
                       const std::vector<std::span<const double>>& columns) {
  require_file_name(suffix);
  if (columns.empty()) throw std::invalid_argument("no columns to plot");
  const std::string file_name = fmt::format("{}.{}.dat", name_, suffix);
  const std::filesystem::path file = folder_ / file_name;
  if (std::filesystem::exists(file)) {
    throw std::logic_error(fmt::format("data '{}' of figure '{}' is doubled", suffix, name_));
  }
  script_->gnuplot.file1d_colmajor(round_trip_columns(columns), file.string());
  if (!std::filesystem::exists(file)) {
    throw sys::OutputError(fmt::format("cannot write '{}'", file.string()));
  }
  return fmt::format("'{}'", file_name);
}

void Plot::close() {
  *this << "unset output\n";
  stream().flush();
  if (!stream()) throw sys::OutputError(fmt::format("cannot write '{}.gp'", name_));
  script_.reset();
}

std::ostream& Plot::stream() {
  if (!script_) throw std::logic_error(fmt::format("figure '{}' is closed", name_));
  return script_->gnuplot;
}

void Plot::write_number(double number) {
  stream() << round_trip(number);
}

}  // namespace literate
