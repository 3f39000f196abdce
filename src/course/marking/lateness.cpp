// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/lateness.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "course/assignment/student.hpp"
#include "system/error.hpp"
#include "system/pattern.hpp"

namespace course {
namespace {

sys::SourceError no_time(const std::string& text) {
  return sys::SourceError(
      fmt::format("'{}' is no time; write it as 2027-01-15T23:59:00+01:00", shown_name(text)));
}

}  // namespace

Time parse_time(const std::string& text) {
  using std::chrono::hours;
  using std::chrono::minutes;
  using std::chrono::seconds;
  static const sys::Pattern form(
      R"((\d{4})-(\d\d)-(\d\d)[Tt ](\d\d):(\d\d):(\d\d)(?:\.\d{1,9})?(?:[Zz]|([+-])(\d\d):(\d\d)))");
  const auto match = form.match_all_of(text);
  if (!match) throw no_time(text);
  const std::vector<std::string_view>& part = match->parts;
  const auto number = [&](std::size_t i) {
    return part[i].empty() ? 0 : std::stoi(std::string(part[i]));
  };
  const std::chrono::year_month_day day{std::chrono::year{number(1)},
                                        std::chrono::month{static_cast<unsigned>(number(2))},
                                        std::chrono::day{static_cast<unsigned>(number(3))}};
  // 60 is a leap second.
  if (!day.ok() || number(4) > 23 || number(5) > 59 || number(6) > 60 || number(8) > 23 ||
      number(9) > 59) {
    throw no_time(text);
  }
  const auto offset = hours(number(8)) + minutes(number(9));
  const Time local =
      std::chrono::sys_days{day} + hours(number(4)) + minutes(number(5)) + seconds(number(6));
  return part[7] == "-" ? local + offset : local - offset;
}

Lateness lateness(const Assignment& assignment, const std::optional<Time>& submitted,
                  const std::optional<int>& slip_days) {
  const LatePolicy& policy = assignment.late;
  const Time last = assignment.deadline + std::chrono::minutes(policy.grace_minutes);
  if (!submitted || *submitted <= last) return {};
  Lateness late;
  late.days = static_cast<int>(std::chrono::ceil<std::chrono::days>(*submitted - last).count());
  const int left = std::min(policy.slip_days, slip_days.value_or(policy.slip_days));
  late.slip_days = std::min(late.days, left);
  const int counted = late.days - late.slip_days;
  late.is_refused = policy.until ? *submitted > *policy.until : counted > policy.days;
  if (late.is_refused) late.slip_days = 0;
  late.percent = late.is_refused ? 100 : std::min(100.0, counted * policy.percent_per_day);
  return late;
}

}  // namespace course
