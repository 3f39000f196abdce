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

/// What a criterion, or a claim, comes to.
enum class Verdict {
  holds,
  holds_in_part,  ///< in some of the cases, or by some of the criteria, but not by all
  fails,
  undecided,  ///< the error of the quantity, or of the limit, reaches across the limit
};

/// «holds», «holds in part», «fails» or «undecided».
std::string_view name_of(Verdict verdict);

/// The verdict of that name. Throws std::invalid_argument for any other text.
Verdict verdict_named(std::string_view name);

/// How far a criterion is from a different outcome.
struct Margin {
  /// Distance of the quantity from its limit over the error of both; none if both are exact.
  std::optional<double> errors;
  /// The factor ≥ 1 between the quantity (or the difference that was tested) and its limit; none
  /// where one of the two is not positive.
  std::optional<double> factor;

  /// «4.1 times; 97 errors», or «exact».
  std::string text() const;
};

/// A condition on a computed quantity: quantity, relation, limit.
///
/// One object prints the quantity, prints the limit and decides, and what is printed lies on the
/// same side of the limit as what was tested. If the quantity's error (its bound, with as many
/// standard uncertainties as Limit::counting says) reaches across the limit, the criterion is
/// undecided. Each factory throws Error with its caller's line for a value or a limit that is not
/// valid, for a text, for a standard uncertainty where the limit does not say how many count, and
/// for an empty name. Names are LaTeX.
class Criterion {
 public:
  /// quantity ≤ limit.
  static Criterion at_most(std::string name, const Value& quantity, const Limit& limit,
                           const Place& place = std::source_location::current());

  /// quantity ≥ limit.
  static Criterion at_least(std::string name, const Value& quantity, const Limit& limit,
                            const Place& place = std::source_location::current());

  /// |computed − stated| ≤ tolerance, all in one unit. The bounds of both add up, and so do their
  /// standard uncertainties, which is right however they are correlated. A tolerance of 0 asks for
  /// equality, such as of counts.
  static Criterion agrees(std::string name, const Value& computed, const Value& stated,
                          const Limit& tolerance,
                          const Place& place = std::source_location::current());

  /// |computed/stated − 1| ≤ tolerance; the interval of `stated` must not hold zero.
  static Criterion agrees_relatively(std::string name, const Value& computed, const Value& stated,
                                     const Limit& tolerance,
                                     const Place& place = std::source_location::current());

  /// One criterion for each case; `cases` names them (LaTeX), such as «points». Holds if all do,
  /// fails if all do, and else holds in part. All must have the same limit. What is printed is how
  /// many hold, and the worst case, or the nearest to its limit if none holds.
  static Criterion in_each(std::string name, std::string cases, const std::vector<Criterion>& each,
                           const Place& place = std::source_location::current());

  Verdict verdict() const { return verdict_; }
  const std::string& name() const { return name_; }

  /// What was tested: «0.074 %»; «0.2999, 1.0e-4 from 0.3»; «at most 3.7e-11» of what is less than
  /// its error; «10 of 11 points; worst: 26».
  const Phrase& found() const { return found_; }

  /// The relation and the limit: «≤ 0.1 %», «≥ 10», «= 5».
  const Phrase& limit_phrase() const { return limit_phrase_; }
  const Limit& limit() const { return limit_; }
  const Margin& margin() const { return margin_; }

  /// What keeps it from being decided; empty unless it is undecided.
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
  double excess_ = 0;  // how far the quantity is beyond the limit; negative within it
  Verdict verdict_ = Verdict::undecided;
};

}  // namespace literate
