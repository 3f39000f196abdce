// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "config/units.hpp"
#include "parameters/case.hpp"

namespace CLI {
class App;
}

namespace app {

enum class OutputFormat { table, csv, json };

/// How a command prints: --format, and --units for the headings where no case file says them.
class OutputOptions {
 public:
  void add_to(CLI::App& command);

  OutputFormat format() const;

  /// The case's units, or those of --units, or the paper's. Throws UnitError for an unknown name.
  config::UnitSystem units(const std::optional<parameters::Case>& from_file) const;

 private:
  std::string format_ = "table";
  std::string units_;
};

}  // namespace app
