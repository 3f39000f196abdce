// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_format.hpp"

#include "command_line/options.hpp"

namespace app {

void OutputOptions::add_to(CLI::App& command) {
  command_line::add_choice(command, "--format", format_, {"table", "csv", "json"}, "How to print");
  command_line::add_text(
      command, "--units", units_, "NAME",
      "Units of the numbers given, for the headings of a table: in-lbf (default), mm-N or m-N");
}

OutputFormat OutputOptions::format() const {
  if (format_ == "csv") return OutputFormat::csv;
  return format_ == "json" ? OutputFormat::json : OutputFormat::table;
}

config::UnitSystem OutputOptions::units(const std::optional<parameters::Case>& from_file) const {
  if (from_file && !units_.empty() && units_ != from_file->units.name) {
    throw sys::InputError("--units " + units_ + ": the case is in " + from_file->units.name);
  }
  if (from_file) return from_file->units;
  return units_.empty() ? config::unit_systems().front() : config::unit_system(units_);
}

}  // namespace app
