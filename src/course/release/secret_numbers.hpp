// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Numbers that must not be found, printed or as a double's bytes.
class SecretNumbers {
 public:
  /// Leaves out numbers that everybody could write: those of less than five significant digits
  /// when printed with six, such as 0.25 and 12000.
  explicit SecretNumbers(const std::vector<double>& numbers);

  /// The numbers of a text, with six significant digits or more, that agree with a secret one in
  /// the digits that both have, up to eight; where the decimal point stands does not matter, as
  /// in another unit.
  std::vector<std::string> printed_in(std::string_view text) const;

  /// Whether the eight bytes of a secret number stand anywhere.
  bool stored_in(std::string_view bytes) const;

  bool empty() const { return patterns_.empty(); }

 private:
  bool is_secret(const std::string& digits) const;

  std::set<std::string, std::less<>> digits_;  // of six to eight digits, cut and rounded
  std::vector<std::uint64_t> patterns_;        // sorted
};

}  // namespace course
