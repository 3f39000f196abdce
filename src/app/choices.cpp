// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/choices.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace app {

ChoiceOption::ChoiceOption(CLI::App& command, std::string flag, std::string chosen,
                           const std::string& help, std::vector<Choice> rows)
    : flag_(std::move(flag)), text_(std::move(chosen)), rows_(std::move(rows)) {
  add_text(command, flag_, text_, names("|", "|"), help);
  for (const Choice& row : rows_) {
    for (const ChoiceFlag& own : row.flags) {
      const auto same = [&](const auto& option) { return option->flag() == own.flag; };
      if (std::ranges::any_of(options_, same)) continue;
      options_.push_back(std::make_unique<NumberOption>(command, own.flag, own.help, own.type));
    }
  }
}

std::string ChoiceOption::names(const char* between, const char* before_last) const {
  std::string names;
  for (const Choice& row : rows_) {
    if (!names.empty()) names += &row == &rows_.back() ? before_last : between;
    names += row.argument.empty() ? row.name : row.name + ":" + row.argument;
  }
  return names;
}

std::size_t ChoiceOption::row() const {
  const auto is_named = [&](const Choice& row) {
    return row.argument.empty() ? text_ == row.name : text_.starts_with(row.name + ":");
  };
  const auto found = std::ranges::find_if(rows_, is_named);
  if (found != rows_.end()) return static_cast<std::size_t>(found - rows_.begin());
  throw sys::InputError(fmt::format("{} = {}: must be {}", flag_, text_, names(", ", " or ")));
}

std::string ChoiceOption::argument() const {
  const std::size_t colon = text_.find(':');
  return colon == std::string::npos ? "" : text_.substr(colon + 1);
}

const NumberOption& ChoiceOption::option(const std::string& flag) const {
  const auto found = std::ranges::find(options_, flag, [](const auto& it) { return it->flag(); });
  if (found == options_.end()) throw std::logic_error("no row has the flag " + flag);
  return **found;
}

double ChoiceOption::number(const std::string& flag) const {
  if (const auto number = given(flag)) return *number;
  throw sys::InputError(flag + " is missing");
}

int ChoiceOption::integer(const std::string& flag, int least, int most) const {
  const auto integer = option(flag).integer();
  if (!integer) throw sys::InputError(flag + " is missing");
  if (*integer < least || *integer > most) {
    throw sys::InputError(
        fmt::format("{} = {}: must be from {} to {}", flag, *integer, least, most));
  }
  return static_cast<int>(*integer);
}

void ChoiceOption::refuse_flags_of_others() const {
  const std::vector<ChoiceFlag>& own = rows_[row()].flags;
  for (const auto& option : options_) {
    if (std::ranges::find(own, option->flag(), &ChoiceFlag::flag) == own.end()) refuse(*option);
  }
}

void ChoiceOption::refuse(const NumberOption& option) const {
  if (option.text().empty()) return;
  throw sys::InputError(fmt::format("{} has no meaning for {} {}", option.flag(), flag_, text_));
}

}  // namespace app
