// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "literate/claims/criterion.hpp"
#include "literate/figures/figure.hpp"
#include "literate/tables/table.hpp"
#include "literate/text/place.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// The progress of a long computation. Any thread may read it.
struct Progress {
  std::atomic<long> done = 0, total = 0;
};

/// Collects what a computation registers.
///
/// Keys of values, flags, checks and claims consist of letters, digits, '-', '_' and '.', and begin
/// with a letter or a digit. Names of tables and figures have no '.'. Each key is registered once,
/// and the document remembers the line of code that registered it. Registering throws Error, with
/// that line, for an invalid key, for a key that is already registered, and for anything that
/// cannot be printed.
class Document {
 public:
  /// Registers a value: `\val{key}`.
  void value(const std::string& key, const Value& value,
             const Place& place = std::source_location::current());

  /// Registers a condition for the prose: `\ifflag{key}{yes}{no}`.
  void flag(const std::string& key, bool is_set,
            const Place& place = std::source_location::current());

  /// Registers a table by its name: `\tab{name}`.
  void table(Table table, const Place& place = std::source_location::current());

  /// Registers the data of a figure: `\fig{name}`.
  void figure(const std::string& name, Figure figure,
              const Place& place = std::source_location::current());

  /// Registers a condition that must hold before the computation can be trusted: either all
  /// criteria hold, or `passed` is true. The statement is LaTeX.
  void check(const std::string& id, const std::vector<Criterion>& criteria, std::string statement,
             const Place& place = std::source_location::current());
  void check(const std::string& id, bool passed, std::string statement,
             const Place& place = std::source_location::current());

  /// Registers a claim: `\claim{id}`. The prose gives its sentence, `\statement{id}{…}`. A claim
  /// needs a route and at least one criterion.
  void claim(const std::string& id, Claim claim,
             const Place& place = std::source_location::current());

  /// Appends everything registered in `part`, so that several threads, or a script
  /// (literate/results/read_document), can compute parts of a document.
  void append(Document part);

  /// Reports that `done` of `total` steps of a long computation are complete. A terminal shows the
  /// counts beside the elapsed seconds. Any thread may call this.
  void progress(long done, long total);

  /// Everything registered, by name. Checks and claims are in the order of registration; the first
  /// claim is claim 1.
  const std::map<std::string, Value>& values() const { return values_; }
  const std::map<std::string, bool>& flags() const { return flags_; }
  const std::map<std::string, Table>& tables() const { return tables_; }
  const std::map<std::string, Figure>& figures() const { return figures_; }
  const std::vector<std::pair<std::string, Check>>& checks() const { return checks_; }
  const std::vector<std::pair<std::string, Claim>>& claims() const { return claims_; }

  /// The line that registered a name; `kind` is value, flag, table, figure, check or claim.
  const std::string& place_of(const std::string& kind, const std::string& name) const;

  /// A line «place: …» for each failed check and each claim with an unexpected verdict.
  std::vector<std::string> faults() const;

  /// The counts of progress(). They stay valid when the document is moved.
  std::shared_ptr<const Progress> progress_so_far() const { return progress_; }

 private:
  void remember(const std::string& kind, const std::string& name, const Place& place);
  /// Runs `make`, and adds place, kind and name to its error.
  template <typename Make>
  static auto checked(const std::string& kind, const std::string& name, const Place& place,
                      Make&& make);

  std::map<std::string, Value> values_;
  std::map<std::string, bool> flags_;
  std::map<std::string, Table> tables_;
  std::map<std::string, Figure> figures_;
  std::vector<std::pair<std::string, Check>> checks_;
  std::vector<std::pair<std::string, Claim>> claims_;
  std::map<std::pair<std::string, std::string>, std::string> places_;  // by kind and name
  std::shared_ptr<Progress> progress_ = std::make_shared<Progress>();
};

}  // namespace literate
