// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/statistics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "course/marking/solution_trial.hpp"
#include "system/csv.hpp"

namespace course {
namespace {

using Values = std::vector<double>;  ///< one of each graded student

double mean_of(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Σ (a − mean a)(b − mean b).
double product_of_deviations(const Values& a, const Values& b) {
  const double mean_a = mean_of(a);
  const double mean_b = mean_of(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - mean_a) * (b[i] - mean_b);
  return sum;
}

/// Points are given in hundredths, so values that differ by less are the same but for rounding.
bool are_all_the_same(const Values& values) {
  const auto [least, most] = std::ranges::minmax(values);
  return are_same_points(least, most);
}

std::optional<double> correlation(const Values& a, const Values& b) {
  if (are_all_the_same(a) || are_all_the_same(b)) return std::nullopt;
  return product_of_deviations(a, b) /
         std::sqrt(product_of_deviations(a, a) * product_of_deviations(b, b));
}

double median_of(Values values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::vector<const Mark*> graded(const ClassMarks& marks) {
  std::vector<const Mark*> graded;
  for (const StudentMark& student : marks.students) {
    if (student.mark) graded.push_back(&*student.mark);
  }
  return graded;
}

Values points_of(const std::vector<const Mark*>& marks, const std::string& check) {
  Values points;
  for (const Mark* mark : marks) points.push_back(mark->checks.at(check));
  return points;
}

/// The points of all checks, without those of the report.
double points_of_checks(const Mark& mark) {
  double sum = 0;
  for (const auto& [check, points] : mark.checks) sum += points;
  return sum;
}

ItemStatistics item_of(const std::string& exercise, const CheckEntry& check, const Values& points,
                       const Values& sums) {
  ItemStatistics item{.exercise = exercise, .check = check, .discrimination = {}};
  item.facility = mean_of(points) / check.points;
  Values others;
  for (std::size_t i = 0; i < points.size(); ++i) {
    others.push_back(sums[i] - points[i]);
    if (are_same_points(points[i], check.points)) ++item.n_full;
    if (are_same_points(points[i], 0)) ++item.n_none;
  }
  item.discrimination = correlation(points, others);
  return item;
}

std::optional<double> reliability_of(const std::vector<Values>& items, const Values& sums) {
  if (items.size() < 2 || are_all_the_same(sums)) return std::nullopt;
  double sum = 0;
  for (const Values& item : items) sum += product_of_deviations(item, item);
  const auto k = static_cast<double>(items.size());
  return k / (k - 1) * (1 - sum / product_of_deviations(sums, sums));
}

std::string number_or_nothing(const std::optional<double>& number) {
  return number ? fmt::format("{:.3f}", *number) : "";
}

}  // namespace

ClassStatistics statistics_of(const Assignment& assignment, const ClassMarks& marks) {
  constexpr std::size_t n_bins = 10;
  ClassStatistics statistics;
  statistics.histogram.resize(n_bins);
  const std::vector<const Mark*> known = graded(marks);
  statistics.n_graded = known.size();
  if (known.empty()) return statistics;
  Values all;
  Values sums;
  for (const Mark* mark : known) {
    all.push_back(mark->mark);
    sums.push_back(points_of_checks(*mark));
    const auto bin = static_cast<std::size_t>(std::max(0.0, mark->mark / marks.most) * n_bins);
    ++statistics.histogram[std::min(bin, n_bins - 1)];
  }
  statistics.mean = mean_of(all);
  if (all.size() > 1) {
    statistics.standard_deviation =
        std::sqrt(product_of_deviations(all, all) / static_cast<double>(all.size() - 1));
  }
  statistics.least = std::ranges::min(all);
  statistics.median = median_of(all);
  statistics.most = std::ranges::max(all);
  std::vector<Values> items;
  for (const Exercise& exercise : assignment.exercises) {
    for (const CheckEntry& check : exercise.checks) {
      items.push_back(points_of(known, check.id));
      statistics.items.push_back(item_of(exercise.id, check, items.back(), sums));
    }
  }
  statistics.reliability = reliability_of(items, sums);
  return statistics;
}

std::string items_csv(const ClassStatistics& statistics) {
  std::string csv =
      "check,exercise,visibility,points,students,facility,discrimination,all,none\r\n";
  for (const ItemStatistics& item : statistics.items) {
    csv += fmt::format("{},{},{},{},{},{:.3f},{},{},{}\r\n", sys::spreadsheet_field(item.check.id),
                       sys::spreadsheet_field(item.exercise),
                       item.check.visibility == Visibility::visible ? "public" : "hidden",
                       item.check.points, statistics.n_graded, item.facility,
                       number_or_nothing(item.discrimination), item.n_full, item.n_none);
  }
  return csv;
}

}  // namespace course
