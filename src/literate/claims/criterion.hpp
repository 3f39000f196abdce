// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "literate/claims/found.hpp"
#include "literate/claims/limit.hpp"
#include "literate/text/place.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// The outcome of a criterion or a claim.
enum class Verdict {
  holds,
  holds_in_part,  ///< in some of the cases, or for some of the criteria, but not all
  fails,
  undecided,  ///< the error of the quantity, or of the limit, reaches across the limit
};

/// Returns «holds», «holds in part», «fails» or «undecided».
std::string_view name_of(Verdict verdict);

/// Returns the verdict with this name. Throws std::invalid_argument for any other text.
Verdict verdict_named(std::string_view name);

/// How far a criterion is from a different outcome.
struct Margin {
  /// Distance between quantity and limit, divided by their combined error; none if both are exact.
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

}  // namespace literate
