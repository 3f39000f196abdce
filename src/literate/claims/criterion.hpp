// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "literate/claims/found.hpp"
#include "literate/text/place.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// Where the number of a limit comes from.
enum class LimitKind {
  theory,  ///< a formula
  data,    ///< a source, or the statement itself
  method,  ///< an estimate by the same run
  choice,  ///< the author's judgement; a reader may choose a different number
};

/// Returns theory, data, method or choice.
std::string_view name_of(LimitKind kind);

/// Returns the kind with this name. Throws std::invalid_argument for any other text.
LimitKind limit_kind_named(std::string_view name);

/// The number that decides a criterion, with the reason for it (LaTeX): {0.1, LimitKind::choice,
/// "what a plot shows"}.
///
/// The criterion tests the rounded number that it prints: with all of its digits up to six, else
/// with three. Criteria refuse a limit that is not finite or has no reason.
class Limit {
 public:
  Limit(double number, LimitKind kind, std::string reason);

  /// Returns this limit for a quantity with a standard uncertainty: `k` > 0 of them count as its
  /// error. k = 2 covers about 95 % of a normal distribution.
  Limit counting(double k) const;

  /// The number that is printed and tested.
  double number() const { return number_; }
  LimitKind kind() const { return kind_; }
  const std::string& reason() const { return reason_; }
  /// How many standard uncertainties count; none if counting() was not called.
  const std::optional<double>& n_counted() const { return n_counted_; }

  /// Throws std::invalid_argument if this limit is invalid.
  void require_valid() const;

 private:
  double number_ = 0;
  LimitKind kind_;
  std::string reason_;
  std::optional<double> n_counted_ = {};
};

/// The outcome of a criterion or a claim.
enum class Verdict {
  holds,
  holds_in_part,  ///< in some of the cases, or for some of the criteria, but not all
  fails,
  undecided,  ///< the error of the quantity reaches across the limit
};

/// Returns «holds», «holds in part», «fails» or «undecided».
std::string_view name_of(Verdict verdict);

/// Returns the verdict with this name. Throws std::invalid_argument for any other text.
Verdict verdict_named(std::string_view name);

/// How far a criterion is from a different outcome.
struct Margin {
  /// Distance between quantity and limit, divided by the quantity's error; none if it is exact.
  std::optional<double> errors;
  /// The factor ≥ 1 between the quantity (or the tested difference) and its limit; none unless both
  /// are positive.
  std::optional<double> factor;

  /// «4.1 times; 97 errors», or «exact».
  std::string text() const;
};

/// A condition on a computed quantity: quantity, relation, limit.
///
/// One object decides and prints both quantity and limit, so that the printed quantity lies on the
/// same side of the limit as the tested one. The criterion is undecided if the error of the
/// quantity reaches across the limit; this error is its bound plus Limit::counting standard
/// uncertainties. Each factory throws Error with its caller's line for an invalid value or limit, a
/// text, an empty name, and a standard uncertainty if the limit does not state how many count.
/// Names are LaTeX.
class Criterion {
 public:
  /// quantity ≤ limit.
  static Criterion at_most(std::string name, const Value& quantity, const Limit& limit,
                           const Place& place = std::source_location::current());

  /// quantity ≥ limit.
  static Criterion at_least(std::string name, const Value& quantity, const Limit& limit,
                            const Place& place = std::source_location::current());

  /// |computed − stated| ≤ tolerance, all in one unit. The bounds of both are added, and so are
  /// their standard uncertainties, which is safe for any correlation. A tolerance of 0 requires
  /// equality, for example of counts.
  static Criterion agrees(std::string name, const Value& computed, const Value& stated,
                          const Limit& tolerance,
                          const Place& place = std::source_location::current());

  /// |computed/stated − 1| ≤ tolerance; the interval of `stated` must exclude zero.
  static Criterion agrees_relatively(std::string name, const Value& computed, const Value& stated,
                                     const Limit& tolerance,
                                     const Place& place = std::source_location::current());

  /// One criterion for each case, all with the same limit; `cases` names them (LaTeX), such as
  /// «points». It holds if all hold, fails if all fail, and holds in part otherwise. It prints how
  /// many hold, and the worst case, or the nearest to its limit if none holds.
  static Criterion in_each(std::string name, std::string cases, const std::vector<Criterion>& each,
                           const Place& place = std::source_location::current());

  Verdict verdict() const { return verdict_; }
  const std::string& name() const { return name_; }

  /// The tested quantity: «0.074 %»; «0.2999, 1.0e-4 from 0.3»; «at most 3.7e-11» if it is smaller
  /// than its error; «10 of 11 points; worst: 26».
  const Phrase& found() const { return found_; }

  /// The relation and the limit: «≤ 0.1 %», «≥ 10», «= 5».
  const Phrase& limit_phrase() const { return limit_phrase_; }
  const Limit& limit() const { return limit_; }
  const Margin& margin() const { return margin_; }

  /// Why it is undecided; empty otherwise.
  const std::string& missing() const { return missing_; }

  /// «largest misfit: 0.074 % (≤ 0.1 %): holds», for messages.
  std::string text() const;

 private:
  Criterion(std::string name, Limit limit, const Place& place);
  static Criterion one_sided(std::string name, const Value& quantity, const Limit& limit, Side side,
                             const Place& place);
  void decide(const Value& tested, Side side, const Place& place);

  std::string name_;
  Limit limit_;
  Phrase found_;
  Phrase limit_phrase_;
  std::string missing_;
  Margin margin_;
  double excess_ = 0;  // distance of the quantity beyond the limit; negative within it
  Verdict verdict_ = Verdict::undecided;
};

/// Returns undecided if any criterion is undecided, holds or fails if all of them do, and holds in
/// part otherwise. There must be at least one criterion.
Verdict verdict_of(const std::vector<Criterion>& criteria);

/// How the computation tests a statement of the prose.
struct Claim {
  std::string route = {};                 ///< how the tested numbers were computed (LaTeX)
  Verdict expected = Verdict::undecided;  ///< the verdict that the prose relies on
  std::vector<Criterion> criteria = {};   ///< the tests that decide it

  Verdict verdict() const { return verdict_of(criteria); }
};

/// A condition that must hold before the computation can be trusted.
struct Check {
  std::string statement;  ///< LaTeX
  bool passed = false;
  std::vector<Criterion> criteria = {};  ///< empty for a fact that needs no number
};

/// Describes each criterion with its result and its limit, for messages.
std::string text_of(const std::vector<Criterion>& criteria);

}  // namespace literate
