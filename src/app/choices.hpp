// SPDX-License-Identifier: GPL-3.0-or-later
// A flag such as --profile or --shape that names a row of a table, and the flags of the rows. Help
// and messages follow from the table.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"

namespace app {
using namespace command_line;

/// A flag that some rows have and others do not.
struct ChoiceFlag {
  std::string flag;  ///< such as "--slope"
  std::string help;
  std::string type = "NUMBER";
};

/// What a row is named by: "wedge", or "file:PATH" with an argument.
struct Choice {
  std::string name;
  std::string argument = {};  ///< what follows the colon, as the help calls it; empty for nothing
  std::vector<ChoiceFlag> flags = {};
};

/// The rows of a table whose rows have a Choice and more.
template <class Row>
std::vector<Choice> choices_of(const std::vector<Row>& table) {
  return {table.begin(), table.end()};
}

/// The flag that names a row, and the flags of all rows, each of which is added once.
class ChoiceOption {
 public:
  /// Adds them to a command; `chosen` is what is named if the flag is left out.
  ChoiceOption(CLI::App& command, std::string flag, std::string chosen, const std::string& help,
               std::vector<Choice> rows);
  ChoiceOption(const ChoiceOption&) = delete;
  ChoiceOption& operator=(const ChoiceOption&) = delete;

  /// What was named, such as "file:gap.csv".
  const std::string& text() const { return text_; }

  /// Which row that is. Throws sys::InputError, which lists the names, for none of them.
  std::size_t row() const;

  /// What follows the colon; empty where nothing does.
  std::string argument() const;

  /// The number of a row's flag, if it was given. Throws sys::InputError if it is no number.
  std::optional<double> given(const std::string& flag) const { return option(flag).number(); }

  /// As given(), but throws sys::InputError if it is missing.
  double number(const std::string& flag) const;

  /// Throws sys::InputError if it is missing, is no whole number or is not from least to most.
  int integer(const std::string& flag, int least, int most) const;

  /// What was given to a row's flag, empty if nothing was.
  const std::string& text_of(const std::string& flag) const { return option(flag).text(); }

  /// Throws sys::InputError for a flag that was given and that the row named does not have, since
  /// it would be ignored.
  void refuse_flags_of_others() const;

  /// The same for a flag that is no row's, such as --radius1 for a wedge.
  void refuse(const NumberOption& option) const;

 private:
  const NumberOption& option(const std::string& flag) const;
  std::string names(const char* between, const char* before_last) const;

  std::string flag_;
  std::string text_;
  std::vector<Choice> rows_;
  std::vector<std::unique_ptr<NumberOption>> options_;
};

}  // namespace app
