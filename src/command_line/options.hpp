// SPDX-License-Identifier: GPL-3.0-or-later
// Flags of a subcommand. All are read as text through these few functions: CLI11's templates are
// instantiated in one file, and numbers are parsed here and not by its locale-dependent strtod.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "command_line/exit_codes.hpp"
#include "system/error.hpp"

namespace CLI {
class App;
}

namespace command_line {

struct ProgramText {
  std::string name;  ///< begins its messages
  std::string description;
  std::string version;  ///< what --version prints
};

using AddCommand = std::function<void(CLI::App& program, ExitCode& exit_code)>;

/// Runs the subcommand that the command line names, of those that `add_commands` add, and returns
/// the exit code for the shell; a wrong command line or output that cannot be written is bad input.
int run_program(const ProgramText& text, const std::vector<AddCommand>& add_commands, int argc,
                char** argv);

/// Adds a subcommand: `set_up` gets it to add its flags to, and returns what runs when it is
/// chosen. Parsing the command line then runs it, guarded, and stores its answer in `exit_code`.
void add_command(CLI::App& program, const std::string& name, const std::string& description,
                 ExitCode& exit_code,
                 const std::function<std::function<ExitCode()>(CLI::App&)>& set_up);

/// Adds a flag that takes a text, shown in the help as `type`. As all of these flags it refuses an
/// empty text, so that a text that is empty was not given.
void add_text(CLI::App& command, const std::string& flag, std::string& text,
              const std::string& type, const std::string& help);

/// As add_text, for a flag that must be given.
void add_required_text(CLI::App& command, const std::string& flag, std::string& text,
                       const std::string& type, const std::string& help);

/// Leaves a command out of every help.
void hide(CLI::App& command);

/// Adds a flag that takes nothing: given or not.
void add_switch(CLI::App& command, const std::string& flag, bool& is_given,
                const std::string& help);

/// Adds a flag that takes one of the choices; `chosen` is the default, or empty for none.
void add_choice(CLI::App& command, const std::string& flag, std::string& chosen,
                const std::vector<std::string>& choices, const std::string& help);

/// Throws sys::InputError with this message if flags exclude or want one another.
void refuse_if(bool is_wrong, const std::string& message);

/// The number that the whole text spells, rounded once and without regard to the locale. Throws
/// sys::InputError naming `what` and the text if it is none, or not finite.
double parse_number(const std::string& what, const std::string& text);

/// The numbers of a list 0,0.005,0.01. Throws sys::InputError naming the element that is none.
std::vector<double> parse_numbers(const std::string& what, const std::string& text);

/// The numbers of a file, one a line; "-" reads standard input. Empty lines and lines that begin
/// with # are passed over. Throws sys::InputError for a file that cannot be read, for one without a
/// number, and for a line that is none (file:line).
std::vector<double> read_numbers(const std::string& file);

/// The result if it is a finite number; throws sys::InputError naming `what` otherwise.
double finite_result(const std::string& what, double result);

/// The shortest decimal digits that read back as the same double.
std::string shortest(double number);

/// A numeric flag that may be left out, such as --young 30e6.
class NumberOption {
 public:
  /// `type` is shown in the help.
  NumberOption(CLI::App& command, const std::string& flag, const std::string& help,
               const std::string& type = "NUMBER");
  NumberOption(const NumberOption&) = delete;
  NumberOption& operator=(const NumberOption&) = delete;

  /// The number given, if any; throws sys::InputError if it is none.
  std::optional<double> number() const;

  /// The number given, or else the case's; throws sys::InputError where there is neither.
  double number_or(std::optional<double> from_case) const;

  /// The whole number given, if any; throws sys::InputError if it is none.
  std::optional<long> integer() const;

  const std::string& text() const { return text_; }
  const std::string& flag() const { return flag_; }

 private:
  std::string flag_;
  std::string text_;
};

}  // namespace command_line
