// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <filesystem>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// The gnuplot script of one figure and its data files, written to one folder.
///
/// The script starts with the cairolatex terminal and the output line; stream the rest to it, with
/// line ends. Nothing is drawn until run_gnuplot.
class Plot {
 public:
  /// Opens folder/name.gp; throws sys::OutputError if it cannot be written.
  Plot(std::filesystem::path folder, std::string name, double width_cm, double height_cm);
  ~Plot();
  Plot(const Plot&) = delete;
  Plot& operator=(const Plot&) = delete;

  /// Adds text or a number to the script; a floating-point number with the fewest digits that
  /// read back the same.
  template <typename T>
  Plot& operator<<(const T& part) {
    if constexpr (std::floating_point<T>) {
      write_number(static_cast<double>(part));
    } else {
      stream() << part;
    }
    return *this;
  }

  /// Writes columns of equal length to name.suffix.dat beside the script, numbers that read back
  /// the same, NaN for a gap, and returns its file name in quotes for a plot command:
  /// `plot << "plot " << plot.data("hertz", {x, p}) << " using 1:2\n"`. Throws
  /// std::invalid_argument for no or unequal columns, std::logic_error for a suffix used before,
  /// sys::OutputError if the file cannot be written.
  std::string data(std::string_view suffix, const std::vector<std::span<const double>>& columns);

  const std::string& name() const { return name_; }

  /// Ends the script; throws sys::OutputError if it could not be written. Nothing may follow.
  void close();

 private:
  struct Script;  // keeps gnuplot-iostream, which takes seconds to compile, out of this header
  std::ostream& stream();
  void write_number(double number);

  std::filesystem::path folder_;
  std::string name_;
  std::unique_ptr<Script> script_;
};

}  // namespace literate
