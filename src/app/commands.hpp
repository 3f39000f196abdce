// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of `halfspace`, and what all of them share: how they are added, and how they
// print.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/result.hpp"
#include "command_line/options.hpp"
#include "config/units.hpp"
#include "parameters/case.hpp"

namespace app {
using namespace command_line;  // the commands are made of its parts

/// Adds a subcommand whose flags are an Options, and which runs with them.
template <class Options>
void add_command(CLI::App& program, const std::string& name, const std::string& description,
                 ExitCode& exit_code, ExitCode (*run)(const Options&)) {
  command_line::add_command(program, name, description, exit_code, [run](CLI::App& command) {
    return [run, options = std::make_shared<Options>(command)] { return run(*options); };
  });
}

/// Each adds a subcommand with its flags to the program; parsing the command line runs the chosen
/// one, which stores its answer in `exit_code`.
void add_displacement_command(CLI::App& program, ExitCode& exit_code);
void add_block_command(CLI::App& program, ExitCode& exit_code);
void add_contact_command(CLI::App& program, ExitCode& exit_code);
void add_point_contact_command(CLI::App& program, ExitCode& exit_code);
void add_stress_command(CLI::App& program, ExitCode& exit_code);

/// All subcommands, in the order in which the help lists them.
inline const std::vector<AddCommand> all_commands{add_displacement_command, add_block_command,
                                                  add_contact_command, add_point_contact_command,
                                                  add_stress_command};

/// The case of --case; nothing if none was given.
std::optional<parameters::Case> case_of(const std::string& file);

/// Throws sys::InputError naming the flag unless the file's folder exists. Called before the
/// computation, so that a wrong name is found at once and not at its end.
void require_folder_of(const std::string& flag, const std::string& file);

/// The i-th of n places from `begin` to `end`, evenly spaced, for a picture.
double place(int i, int n, double begin, double end);

/// A function at n such places, in a column for these and one for its values.
literate::FigureData curve(const std::string& of_places, const std::string& of_values, int n,
                           double begin, double end, const std::function<double(double)>& value);

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
  ExitCode print(const Result& result) const;

 private:
  void require_drawable() const;
  void draw(const std::string& script, literate::Figure figure) const;

  std::string format_ = "table";
  std::string units_, plot_;
};

}  // namespace app
