// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <source_location>
#include <string>
#include <utility>
#include <vector>

#include "literate/claims/claim.hpp"
#include "literate/document/attachments.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/figures/gnuplot.hpp"
#include "literate/tables/table.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// Something that must hold for the computation to be trusted, and whether it did.
struct Check {
  std::string id;
  bool passed = false;
  std::string statement;
};

/// What a computation registers for its document, and the writer of all that LaTeX needs of it.
///
/// Keys of values, flags and checks are letters, digits, '-', '_' and '.'; names of tables and
/// figures the same without '.'. Each is registered once, at a place that the document remembers.
/// Registering throws std::logic_error naming a key that is not of this form, or one that is
/// doubled with both places.
class Document {
 public:
  using Location = std::source_location;

  void value(const std::string& key, Value value, Location location = Location::current());

  /// A condition for the prose: `\ifflag{key}{yes}{no}`.
  void flag(const std::string& key, bool is_set, Location location = Location::current());

  void table(const std::string& name, Table table, Location location = Location::current());

  /// A figure of this size that `draw` writes the script of, when the document is written.
  void figure(const std::string& name, double width_cm, double height_cm,
              std::function<void(Plot&)> draw, Location location = Location::current());

  void check(const std::string& id, bool passed, std::string statement,
             Location location = Location::current());

  /// A statement with its verdict: `\claim{id}`. Throws std::logic_error if its sentence, place,
  /// computed value, route or tolerance is empty.
  void claim(const std::string& id, Claim claim, Location location = Location::current());

  /// Registers what comes from another program's file, with the place in that file.
  void value(const std::string& key, Value value, const SourcePlace& place);
  void table(const std::string& name, Table table, const SourcePlace& place);

  /// Keeps a file that values came from: it is written to imports/, listed with its SHA-256 and
  /// attached to the PDF. Throws std::logic_error as Attachments::add does.
  void attach(const AttachedFile& file) { attachments_.add(file); }
  const Attachments& attachments() const { return attachments_; }

  /// Adds all that another document registered, behind what this one has; parts of a document can
  /// then be computed at the same time. Throws std::logic_error for what both registered.
  void append(Document part);

  const std::map<std::string, Value>& values() const { return values_; }
  const std::map<std::string, bool>& flags() const { return flags_; }
  const std::map<std::string, Table>& tables() const { return tables_; }
  const std::map<std::string, Figure>& figures() const { return figures_; }
  /// In the order of registration.
  const std::vector<Check>& checks() const { return checks_; }
  std::vector<Check> failed_checks() const;

  /// With their ids, in the order of registration: the first is claim 1.
  const std::vector<std::pair<std::string, Claim>>& claims() const { return claims_; }

  /// What keeps the document from being trusted: a line for each failed check, and for each claim
  /// whose verdict is not the expected one.
  std::vector<std::string> faults() const;

  /// Where something was registered: kind is value, flag, table, figure, check or claim.
  const SourcePlace& place(const std::string& kind, const std::string& name) const;

  /// Writes literate.sty, values.tex, claims.tex, index.tex, provenance.tex, tables/, figures/,
  /// excerpts/, imports/ and names.json.
  ///
  /// All is made in output_dir + ".part" and moved in place only when everything succeeded, figures
  /// included; files with the same content keep their time stamp, files no longer made are removed.
  /// On an error output_dir stays as it was: sys::ToolError from gnuplot, sys::OutputError for a
  /// folder that cannot be written, std::invalid_argument for a table that cannot be printed, and
  /// whatever a draw function throws.
  void write(const std::filesystem::path& output_dir,
             const std::vector<Excerpt>& excerpts = {}) const;

 private:
  void remember(const std::string& kind, const std::string& name, const SourcePlace& place);

  std::map<std::string, Value> values_;
  std::map<std::string, bool> flags_;
  std::map<std::string, Table> tables_;
  std::map<std::string, Figure> figures_;
  std::vector<Check> checks_;
  std::vector<std::pair<std::string, Claim>> claims_;
  Attachments attachments_;
  std::map<std::pair<std::string, std::string>, SourcePlace> places_;  // by kind and name
};

}  // namespace literate
