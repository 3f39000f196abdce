// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "literate/claims/claim.hpp"
#include "literate/figures/figure.hpp"
#include "literate/tables/table.hpp"
#include "literate/text/place.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// How much of a long computation is done. Any thread may read it.
struct Progress {
  std::atomic<long> done = 0, total = 0;
};

/// Collects what a computation registers.
///
/// Keys of values, flags, checks and claims consist of letters, digits, '-', '_' and '.', and names
/// of tables and figures of the same without '.'; the first is a letter or a digit. Each is
/// registered once, and the document remembers the line of code that did it. Registering throws
/// Error, with that line, for a key of another form, for one that is registered already, and for
/// anything that cannot be printed.
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

  /// Registers what a figure's script reads: `\fig{name}`.
  void figure(const std::string& name, Figure figure,
              const Place& place = std::source_location::current());

  /// Registers something that must hold for the computation to be trusted: that all criteria hold,
  /// or a fact that is no number. The statement is LaTeX.
  void check(const std::string& id, const std::vector<Criterion>& criteria, std::string statement,
             const Place& place = std::source_location::current());
  void check(const std::string& id, bool passed, std::string statement,
             const Place& place = std::source_location::current());

  /// Registers a statement with its verdict: `\claim{id}`. Its sentence is in the prose:
  /// `\statement{id}{…}`. It needs a route and at least one criterion.
  void claim(const std::string& id, Claim claim,
             const Place& place = std::source_location::current());

  /// Adds all that another document registered, after what this one has, so that parts can be
  /// computed at the same time, by several threads or by a script (literate/results/read_document).
  void append(Document part);

  /// Reports that `done` of `total` steps of a long computation are done. `compute` shows it on a
  /// terminal, beside the seconds. Any thread may call this.
  void progress(long done, long total);

  /// A value or table that is registered already. Throws Error with the nearest name if it is not.
  const Value& value(const std::string& key,
                     const Place& place = std::source_location::current()) const;
  const Table& table(const std::string& name,
                     const Place& place = std::source_location::current()) const;

  /// What was registered, by name; checks and claims in the order of registration: the first claim
  /// is claim 1.
  const std::map<std::string, Value>& values() const { return values_; }
  const std::map<std::string, bool>& flags() const { return flags_; }
  const std::map<std::string, Table>& tables() const { return tables_; }
  const std::map<std::string, Figure>& figures() const { return figures_; }
  const std::vector<std::pair<std::string, Check>>& checks() const { return checks_; }
  const std::vector<std::pair<std::string, Claim>>& claims() const { return claims_; }

  /// Where something was registered; `kind` is value, flag, table, figure, check or claim.
  const std::string& place_of(const std::string& kind, const std::string& name) const;

  /// What keeps the document from being trusted: a line «place: …» for each check that failed and
  /// each claim that has a different verdict than expected.
  std::vector<std::string> faults() const;

  /// The counts of progress(), which stay valid while the document is moved.
  std::shared_ptr<const Progress> progress_so_far() const { return progress_; }
  /// «value 'x' (src/main.cpp:31)», what was registered last; empty before the first.
  const std::string& last_registered() const { return last_registered_; }

 private:
  void remember(const std::string& kind, const std::string& name, const Place& place);
  /// Runs `make` and reports what it refuses with place, kind and name.
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
  std::string last_registered_;
  std::shared_ptr<Progress> progress_ = std::make_shared<Progress>();
};

}  // namespace literate
