// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "course/assignment/check.hpp"

namespace course {

/// Numbers that a handout must not hold, neither printed nor as the bytes of a double.
class SecretNumbers {
 public:
  /// Leaves out numbers that anybody could write, which have less than five significant digits
  /// when they are printed with six, such as 0.25 and 12000.
  explicit SecretNumbers(const std::vector<double>& numbers);

  /// The numbers in a text that have at least six significant digits and agree with a secret
  /// number in these, of which eight count at most. The place of the decimal point does not matter,
  /// since the number may be in another unit.
  std::vector<std::string> printed_in(std::string_view text) const;

  /// Whether the eight bytes of a secret number stand anywhere in `bytes`.
  bool stored_in(std::string_view bytes) const;

  bool empty() const { return patterns_.empty(); }

 private:
  bool is_secret(const std::string& printed, double number) const;

  std::set<std::string, std::less<>> digits_;  // of six to eight digits, cut and rounded
  std::vector<std::uint64_t> patterns_;        // sorted
};

/// Records what the checks ask the instructor's program and what it answers. These answers are
/// the values that a handout must not hold.
class ExpectedValues {
 public:
  /// The same checks, which now record in this object; it must outlive them.
  Checks listening(const Checks& checks);

  /// The answers, each once, without those that were also an input.
  std::vector<double> values() const;

 private:
  mutable std::mutex mutex_;
  std::set<double> inputs_, answers_;
};

}  // namespace course
