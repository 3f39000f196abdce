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

/// Writes the gnuplot script of one figure and its data files to a folder.
///
/// The script begins with the cairolatex terminal and the name of the output; the rest, line ends
/// included, is streamed to it. run_gnuplot draws the figure.
class Plot {
 public:
  /// Opens folder/name.gp; throws sys::OutputError if it cannot be written.
  Plot(std::filesystem::path folder, std::string name, double width_cm, double height_cm);
  ~Plot();
  Plot(const Plot&) = delete;
  Plot& operator=(const Plot&) = delete;

  /// Adds text or a number to the script. A floating-point number gets the fewest digits that read
  /// back the same.
  template <typename T>
  Plot& operator<<(const T& part) {
    if constexpr (std::floating_point<T>) {
      write_number(static_cast<double>(part));
    } else {
      stream() << part;
    }
    return *this;
  }

  /// Writes columns of equal length to name.suffix.dat beside the script, with digits that read
  /// back the same and NaN for a gap. Returns the file's name in quotes, for a plot command: `plot
  /// << "plot " << plot.data("hertz", {x, p}) << " using 1:2\n"`. Throws std::invalid_argument for
  /// columns of different lengths or none, std::logic_error for a suffix that was used before,
  /// sys::OutputError if the file cannot be written.
  std::string data(std::string_view suffix, const std::vector<std::span<const double>>& columns);

  /// Ends the script, to which nothing can be added then; throws sys::OutputError if it could not
  /// be written.
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
