// SPDX-License-Identifier: GPL-3.0-or-later
// Common to all commands: the case, the system of units, and the output of the result.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/flags.hpp"
#include "app/result.hpp"
#include "config/units.hpp"
#include "parameters/case.hpp"

namespace app {

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
