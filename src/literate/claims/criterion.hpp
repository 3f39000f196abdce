// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <source_location>
#include <string>
#include <string_view>
#include <vector>

#include "literate/claims/found.hpp"
#include "literate/claims/limit.hpp"
#include "literate/values/value.hpp"
#include "numerics/estimate.hpp"

namespace literate {

/// How far a criterion is from another outcome. One that is far in both ways decides clearly.
struct Margin {
  /// Distance of the quantity from its limit over the error of both; none if both are exact. Where
  /// it is below 1 the outcome is open.
  std::optional<double> errors;
  /// The factor ≥ 1 from the quantity to its limit, or back; of an agreement that of the difference
  /// to the tolerance. None where one of the two is not positive.
  std::optional<double> factor;

  /// The least factor in the limit, to either side, that would change the outcome, the error
  /// counted.
  std::optional<double> turning_factor;

  /// «4.1 times; 97 errors»; «exact» if there is neither.
  std::string text() const;
};

/// What a criterion found.
enum class Outcome {
  holds,
  holds_in_part,  ///< in some of the cases that were tried, not in all
  fails,
  undecided,  ///< the error of the quantity, or of the limit, reaches across the limit
};

/// Names an outcome: «holds», «holds in part», «fails» or «undecided».
std::string_view name_of(Outcome outcome);

/// A condition on a computed quantity that decides a claim: quantity, relation, limit.
///
/// One object prints the quantity, prints the limit and decides, so that what the reader sees is
/// what was tested. The quantity's error counts: its bound, with as many standard uncertainties as
/// Limit::counting() says. If number ± error, or limit ± its error, lies on both sides of the
/// limit, the criterion is undecided. Every factory throws std::invalid_argument with its caller's
/// line for a quantity without a finite number or of whose error nobody told (Value::measured), for
/// a standard uncertainty where the limit does not say how many count, for an empty name, and where
/// the outcome is another one against the limit before it was rounded.
class Criterion {
 public:
  using Location = std::source_location;

  /// quantity ≤ limit.
  static Criterion at_most(std::string name, Value quantity, Limit limit,
                           Location location = Location::current());

  /// quantity ≥ limit.
  static Criterion at_least(std::string name, Value quantity, Limit limit,
                            Location location = Location::current());

  /// |computed − stated| ≤ tolerance, in the quantities' unit. The error of the difference is the
  /// sum of both bounds; what both are uncertain by from one source cancels. A tolerance of 0 asks
  /// for equality, such as of counts. Here and below, quantities of two units are refused.
  static Criterion agrees(std::string name, Value computed, Value stated, Limit tolerance,
                          Location location = Location::current());

  /// |computed/stated − 1| ≤ tolerance; `stated` must not be zero, nor its interval hold zero.
  static Criterion agrees_relatively(std::string name, Value computed, Value stated,
                                     Limit tolerance, Location location = Location::current());

  /// |computed − stated| ≥ limit: the two differ, by no less than the limit; 0 asks that they
  /// differ at all, by more than what is not known of both.
  static Criterion differs(std::string name, Value computed, Value stated, Limit limit,
                           Location location = Location::current());

  /// One criterion a case, where `cases` names them, such as «points». Holds if all do, fails if
  /// none does, and else holds in part. All must have the same condition and reason; what is
  /// printed is how many hold, and the worst case, or the nearest to its limit if all fail.
  static Criterion in_each(std::string name, std::string cases, const std::vector<Criterion>& each);

  Outcome outcome() const { return outcome_; }

  /// What the quantity is called, such as «largest misfit».
  const std::string& name() const { return name_; }

  /// The quantity that was tested, such as «0.074 %», or what it is at most if that is less than
  /// its error; of an agreement also how far it is from what is stated. What is printed lies on the
  /// same side of the limit as what was tested.
  const Phrase& found() const { return found_; }

  /// The relation and the limit as they were tested, such as «at most 0.1 %».
  const Phrase& condition() const { return condition_; }

  /// The same in short, for a ledger: «≤ 0.1 %», «≥ 10»; of an agreement how far the quantity may
  /// be from what is stated, «≤ 0.1 %», or «= 5» where the two must be equal.
  const Phrase& limit() const { return limit_phrase_; }

  /// Name and quantity for a message: «largest misfit: 0.074 %».
  std::string computed() const;

  /// The kind of the limit and its reason.
  std::string reason() const;
  LimitKind limit_kind() const { return limit_.kind(); }
  const std::string& limit_reason() const { return limit_.reason(); }
  double limit_number() const { return limit_.number(); }

  /// How far it is from another outcome; of several cases how far the printed one is from its
  /// limit, and by which factor that must move to give all of them another outcome.
  const Margin& margin() const { return margin_; }

  /// What is missing for a decision; empty unless undecided.
  const std::string& missing() const { return missing_; }

  /// The quantity that was tested.
  const Value& quantity() const { return quantity_; }

 private:
  Criterion(std::string name, Value quantity, Limit limit);
  Criterion(Side side, std::string name, Value quantity, Limit limit, Location location);
  void decide(const numerics::Estimate& tested, bool is_upper_limit, const Value& like,
              const std::string& place);

  std::string name_;
  Value quantity_;
  Limit limit_;
  Phrase found_;         // the quantity, and for an agreement how far it is from what is stated
  Phrase condition_;     // relation and limit
  Phrase limit_phrase_;  // the same in short
  std::string missing_;
  Margin margin_;
  double excess_ = 0;  // how far the quantity is beyond the limit; negative within it
  Outcome outcome_ = Outcome::undecided;
};

}  // namespace literate
