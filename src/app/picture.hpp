// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/output_format.hpp"
#include "literate/figures/figure.hpp"

namespace app {

/// The flag --plot: where to draw what a command computed.
class PlotOption {
 public:
  void add_to(CLI::App& command);

  bool is_given() const { return !file_.empty(); }

  /// Throws sys::InputError unless the file ends with .svg, .png or .pdf and its folder exists, or
  /// it is -, the terminal, and the output a table. Called before anything is computed.
  void require_drawable(const OutputOptions& output) const;

  /// Draws the figure by the script of that name, in the report's style, to the file, or in
  /// characters to standard output. The script finds the number in_terminal there. The same figure
  /// gives the same bytes. Throws sys::ToolError with gnuplot's message if it fails or is missing.
  void draw(const std::string& script, literate::Figure figure) const;

 private:
  std::string file_;
};

}  // namespace app
