// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "literate/excerpt.hpp"
#include "literate/gnuplot.hpp"
#include "literate/table.hpp"
#include "literate/value.hpp"

namespace literate {

/// A statement about the computation that was tried, and its outcome.
struct Check {
  std::string id;
  bool passed = false;
  std::string statement;
};

/// What a computation registers for its document, and the writer of all that LaTeX needs of it.
///
/// Keys of values, flags and checks are letters, digits, '-', '_' and '.'; names of tables and
/// figures the same without '.'. Registering throws std::logic_error naming a key that is not of
/// this form or doubled.
class Document {
 public:
  void value(const std::string& key, Value value);
  /// A condition for the prose: `\ifflag{key}{yes}{no}`.
  void flag(const std::string& key, bool is_set);
  void table(const std::string& name, Table table);
  /// A figure of this size that `draw` writes the script of, when the document is written.
  void figure(const std::string& name, double width_cm, double height_cm,
              std::function<void(Plot&)> draw);
  void check(const std::string& id, bool passed, std::string statement);

  const std::map<std::string, Value>& values() const { return values_; }
  const std::map<std::string, bool>& flags() const { return flags_; }
  const std::map<std::string, Table>& tables() const { return tables_; }
  const std::map<std::string, Figure>& figures() const { return figures_; }
  /// In the order of registration.
  const std::vector<Check>& checks() const { return checks_; }
  std::vector<Check> failed_checks() const;

  /// Writes literate.sty, values.tex, tables/, figures/, excerpts/ and names.json.
  ///
  /// All is made in output_dir + ".part" and moved in place only when everything succeeded, figures
  /// included; files with the same content keep their time stamp, files no longer made are removed.
  /// On an error output_dir stays as it was: ToolError from gnuplot, OutputError for a folder that
  /// cannot be written, std::invalid_argument for a table that cannot be printed, and whatever a
  /// draw function throws.
  void write(const std::filesystem::path& output_dir,
             const std::vector<Excerpt>& excerpts = {}) const;

 private:
  std::map<std::string, Value> values_;
  std::map<std::string, bool> flags_;
  std::map<std::string, Table> tables_;
  std::map<std::string, Figure> figures_;
  std::vector<Check> checks_;
};

}  // namespace literate
