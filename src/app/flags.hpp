// SPDX-License-Identifier: GPL-3.0-or-later
// Commands and their flags: numbers with or without a unit, lists and ranges, names, CSV files.
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// The column at which descriptions begin in the help.
constexpr std::size_t help_column = 27;

/// Wraps a description in the help before column 80.
std::string wrapped(const std::string& text);

/// A flag with a value. CLI11 stores the text and lists the help; numbers are parsed here, because
/// CLI11's parsing depends on the locale.
class Flag {
 public:
  /// `names` is "--x", or several separated by commas; messages use the first. `type` names the
  /// value in the help, and `group` is the heading of the flag there.
  Flag(CLI::App& command, const std::string& names, const std::string& type,
       const std::string& group, const std::string& help);
  Flag(const Flag&) = delete;
  Flag& operator=(const Flag&) = delete;

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  bool is_given() const { return !text_.empty(); }

  /// The text, or `other` without the flag.
  std::string text_or(const std::string& other) const { return is_given() ? text_ : other; }

  /// The quantity in this unit, if it was given: 210GPa, "210 GPa", or a plain number, which is
  /// already in the unit. Unit "1" takes plain numbers only. Throws sys::InputError for anything
  /// but a finite number, and for a unit of a different dimension.
  std::optional<double> quantity(const std::string& unit) const;

  /// The same, but rejects numbers that are not greater than 0.
  std::optional<double> positive(const std::string& unit) const;

  /// A list 0,0.5,1mm of quantities and of ranges BEGIN:END:STEP, which include both ends. A unit
  /// after the last number applies to all numbers without one. Empty if the flag was not given.
  std::vector<double> quantities(const std::string& unit) const;

  /// A whole number, such as 1e6, if it was given. Rejects numbers outside [least, most].
  std::optional<long> count(long least, long most) const;

  /// Throws sys::InputError: "--load = -5: must be greater than 0".
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  std::string name_;
  std::string text_;
};

/// A flag whose value must be one of these names. The help lists them as its type.
class Choice : public Flag {
 public:
  Choice(CLI::App& command, const std::string& name, const std::vector<std::string>& choices,
         const std::string& group, const std::string& help);
};

/// A required quantity: from its flag, else from the case.
struct Needed {
  const Flag& flag;
  std::string unit;
  std::optional<double> from_case = std::nullopt;
};

/// These quantities, all greater than 0. Throws sys::InputError listing all missing ones.
std::vector<double> read(const std::vector<Needed>& all);

/// Throws sys::InputError listing all of the flags that are missing.
void require_given(const std::vector<const Flag*>& flags);

/// Throws sys::InputError "--radius1 has no meaning for --profile file:gap.csv" if one of the flags
/// was given.
void refuse_given(const std::vector<const Flag*>& flags, const std::string& choice);

/// Parses the whole text as a number, independently of the locale. Throws sys::InputError with
/// `what` and the text if it is not a finite number.
double parse_number(const std::string& what, const std::string& text);

/// Six significant digits at most, for limits in messages: 29.999999999999993 is 30.
std::string rounded(double number);

/// n numbers first, first + step, …, rounded to 15 digits so that three steps of 0.1 are 0.3.
std::vector<double> evenly_spaced(double first, double step, int n);

/// A member of a case, or nothing if there is no case.
template <class Case, class Member>
std::optional<Member> of_case(const std::optional<Case>& from_case, Member Case::*member) {
  return from_case ? std::optional((*from_case).*member) : std::nullopt;
}

// Measured profiles, loads and surfaces in CSV files. Empty lines and lines that begin with # are
// ignored. Both functions throw sys::InputError with the file and the position of the error.

/// A function sampled at rising x.
struct CurvePoints {
  std::vector<double> x, y;
};

/// Reads two columns with a heading such as "x,gap": at least `fewest` points, with rising x.
CurvePoints read_curve(const std::string& file, const std::string& heading, std::size_t fewest);

/// Reads a grid of at least 4 by 4 numbers without a heading: grid(i, j) is number i of line j.
Eigen::ArrayXXd read_grid(const std::string& file);

/// Adds a command, whose flags are the members of Options. Its help begins with the description,
/// which also appears in the list of commands, and ends with `more`, as it is.
template <class Options>
void add_command(CLI::App& program, const std::string& name, const std::string& description,
                 const std::string& more, void (*run)(const Options&)) {
  CLI::App* command = program.add_subcommand(name, wrapped(description))->group("Commands");
  command->footer(more);
  const std::shared_ptr<Options> options(new Options{*command});
  command->callback([run, options] { run(*options); });
}

void add_displacement_command(CLI::App& program);
void add_contact_command(CLI::App& program);
void add_point_contact_command(CLI::App& program);
void add_stress_command(CLI::App& program);
void add_block_command(CLI::App& program);

}  // namespace app
