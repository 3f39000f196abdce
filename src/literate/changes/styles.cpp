// SPDX-License-Identifier: GPL-3.0-or-later
// What \val and \rawval with options print of a value that changed.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <exception>
#include <set>
#include <string>
#include <string_view>

#include "literate/changes/changes.hpp"
#include "literate/prose/restyle.hpp"
#include "literate/values/decimal.hpp"

namespace literate {
namespace {

/// The former number, stored as the present one is.
StoredNumber stored_like(StoredNumber stored, const ManifestNumber& number) {
  stored.number = number.number;
  stored.unit = number.unit.value_or(stored.unit);
  if (stored.uncertainty) {
    stored.uncertainty->bound = number.abs_error.value_or(0);
    stored.uncertainty->sides = number.sides;
    stored.uncertainty->standard = number.standard;
    stored.uncertainty->neglected = 0;  // a manifest has it with the bound
  }
  return stored;
}

/// What \val[options] or \rawval[options] prints; all digits where the error does not support what
/// is asked for.
std::string restyled_print(const StoredNumber& stored, std::string_view options) {
  constexpr std::string_view raw = "rawval ";
  try {
    if (options.starts_with(raw)) {
      return bare_digits(restyled_number(stored, options.substr(raw.size())));
    }
    return restyled(stored, options).printed();
  } catch (const std::exception&) {
    return fmt::format("{:.12g}", stored.number);
  }
}

}  // namespace

void tell_styles(Change& change, const StoredNumber& stored, const ManifestNumber& was) {
  const bool is_plain_other = change.before != change.after;
  std::set<std::string> before, after;
  std::erase_if(change.printed_in, [&](const Sentence& sentence) {
    bool is_other = false;
    for (const std::string& options : sentence.styles.at(change.what)) {
      if (options.empty()) {
        is_other = is_other || is_plain_other;
        continue;
      }
      const std::string then = restyled_print(stored_like(stored, was), options);
      const std::string now = restyled_print(stored, options);
      if (then == now) continue;
      is_other = true;
      before.insert(then);
      after.insert(now);
    }
    return !is_other;
  });
  if (is_plain_other || before.empty()) return;
  change.before = fmt::format("{}", fmt::join(before, ", "));
  change.after = fmt::format("{}", fmt::join(after, ", "));
}

}  // namespace literate
