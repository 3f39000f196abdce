// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/result.hpp"
#include "command_line/exit_codes.hpp"
#include "config/units.hpp"
#include "parameters/case.hpp"

namespace CLI {
class App;
}

namespace app {

/// The case of --case; nothing if none was given.
std::optional<parameters::Case> case_of(const std::string& file);

/// Throws sys::InputError naming the flag unless the file's folder exists. Called before the
/// computation, so that a wrong name is found at once and not at its end.
void require_folder_of(const std::string& flag, const std::string& file);

/// How a command prints: --format, --units for the headings where no case file says them, and
/// --plot, which draws by the script of that name in the folder plots, in the report's style.
class Output {
 public:
  void add_to(CLI::App& command);

  /// The case's units, or those of --units, or the paper's. Throws sys::InputError for an unknown
  /// name. What is to be drawn is looked at too: its name must end with .svg, .png or .pdf and its
  /// folder exist, or be -, the terminal, and the output a table. Called before anything is
  /// computed.
  config::UnitSystem units(const std::optional<parameters::Case>& from_file) const;

  /// Whether a result needs its first table, which may be large, for its CSV.
  bool is_csv() const { return format_ == "csv"; }

  /// Prints the warnings on standard error and the result in its format, and draws it. The script
  /// finds the number in_terminal where it draws there. The same figure gives the same bytes.
  /// Throws sys::InputError for a number that is not finite, sys::ToolError with gnuplot's message
  /// if it fails or is missing.
  command_line::ExitCode print(const Result& result) const;

 private:
  void require_drawable() const;
  void draw(const std::string& script, literate::Figure figure) const;

  std::string format_ = "table";
  std::string units_, plot_;
};

}  // namespace app
