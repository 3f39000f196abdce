// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <source_location>
#include <string>
#include <utility>
#include <vector>

#include "literate/document/registered.hpp"
#include "literate/excerpts/excerpt.hpp"

namespace literate {

/// Collects what a computation registers, and writes all files that LaTeX needs of it.
///
/// A key of a value, flag, check or claim consists of letters, digits, '-', '_' and '.'; a name of
/// a table or figure must not have a '.'. Each is registered once, and the document remembers the
/// line of code that did it. Registering throws std::logic_error for a key of another form, and for
/// a key that is registered already, with both places.
class Document {
 public:
  using Location = std::source_location;

  /// Registers a value. Throws std::invalid_argument for a number that is not finite.
  void value(const std::string& key, Value value, Location location = Location::current());

  /// Registers a condition for the prose: `\ifflag{key}{yes}{no}`.
  void flag(const std::string& key, bool is_set, Location location = Location::current());

  /// Registers a table by its name. Throws std::invalid_argument for a mark without its note, or a
  /// note without its mark.
  void table(Table table, Location location = Location::current());

  /// Registers what a figure's script reads: its size, data, numbers and texts. Throws
  /// std::logic_error for what no script could read, as require_drawable.
  void figure(const std::string& name, Figure figure, Location location = Location::current());

  /// Registers something that must hold for the computation to be trusted: what its criteria say,
  /// of which none may be undecided, or a fact that is no number.
  void check(const std::string& id, const std::vector<Criterion>& criteria, std::string statement,
             Location location = Location::current());
  void check(const std::string& id, bool passed, std::string statement,
             Location location = Location::current());

  /// Registers a statement with its verdict: `\claim{id}`. Its sentence stands in the
  /// prose: `\statement{id}{…}`. Throws std::logic_error without a route or a criterion.
  void claim(const std::string& id, Claim claim, Location location = Location::current());

  /// Registers what comes from another program's file, with the place in that file.
  void value(const std::string& key, Value value, const SourcePlace& place);
  void table(Table table, const SourcePlace& place);

  /// Keeps a file that values came from: it is written to imports/, listed with its SHA-256 and
  /// attached to the PDF. Throws std::logic_error as Attachments::add does.
  void attach(const AttachedFile& file) { registered_.attachments.add(file); }
  void attach(const Attachments& files) { registered_.attachments.add(files); }
  const Attachments& attachments() const { return registered_.attachments; }

  /// Tells which case all this was computed from, by its file's name, for `\papercase`, and by the
  /// SHA-256 of the bytes that were read.
  void computed_from(const std::string& case_name, const std::string& case_sha256) {
    registered_.case_name = case_name;
    registered_.case_sha256 = case_sha256;
  }

  /// Tells which planted faults turn the claims, for the ledger.
  void severity(std::optional<Severity> severity) { registered_.severity = std::move(severity); }

  /// Adds all that another document registered, after what this one has, so that parts of a
  /// document can be computed at the same time. Throws std::logic_error if both registered the same
  /// key.
  void append(Document part);

  const Registered& registered() const { return registered_; }
  const std::map<std::string, Value>& values() const { return registered_.values; }
  /// A value or table that is registered already. Throws std::invalid_argument for another name.
  const Value& value(const std::string& key, Location location = Location::current()) const;
  const Table& table(const std::string& name, Location location = Location::current()) const;

  const std::map<std::string, bool>& flags() const { return registered_.flags; }
  const std::map<std::string, Table>& tables() const { return registered_.tables; }
  const std::map<std::string, Figure>& figures() const { return registered_.figures; }
  /// The checks in the order of registration.
  const std::vector<Check>& checks() const { return registered_.checks; }
  std::vector<Check> failed_checks() const { return literate::failed_checks(registered_); }

  /// The claims with their ids, in the order of registration: the first is claim 1.
  const std::vector<std::pair<std::string, Claim>>& claims() const { return registered_.claims; }

  /// What keeps the document from being trusted, as literate::faults tells it.
  std::vector<std::string> faults() const { return literate::faults(registered_); }

  /// Where each figure was registered, for draw_figures.
  std::map<std::string, std::string> figure_places() const {
    return literate::figure_places(registered_);
  }

  /// Writes literate.sty, values.tex, claims.tex, claims.csv, index.tex, values.csv, sources.csv,
  /// provenance.tex, tables/, excerpts/, imports/, names.json, and into figures/ what draw_figures
  /// draws from.
  ///
  /// All files are written to output_dir + ".part" and moved to output_dir only after everything
  /// succeeded. Files whose content is the same keep their time stamp, and files of the previous
  /// run that were not written again are removed. On an error output_dir stays as it was. Throws
  /// sys::OutputError for a folder that cannot be written.
  void write(const std::filesystem::path& output_dir,
             const std::vector<Excerpt>& excerpts = {}) const;

 private:
  void remember(const std::string& kind, const std::string& name, const SourcePlace& place);

  Registered registered_;
};

}  // namespace literate
