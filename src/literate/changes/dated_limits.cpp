// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/dated_limits.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "config/table.hpp"
#include "literate/changes/history.hpp"
#include "literate/prose/recorded_ages.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

/// Which records are of the same case.
class Cases {
 public:
  Cases(std::filesystem::path document, std::filesystem::path case_file)
      : document_(std::move(document)), case_file_(std::move(case_file)) {}

  bool are_the_same(const RecordedResults& a, const RecordedResults& b) {
    if (a.results.inputs.empty()) return false;
    if (a.results.inputs == b.results.inputs) return true;
    const std::string &of_a = text_of(a), &of_b = text_of(b);
    return !of_a.empty() && !of_b.empty() && config::say_the_same(of_a, of_b);
  }

 private:
  /// Empty if the case is not the one that the results are of.
  const std::string& text_of(const RecordedResults& record) {
    const auto [entry, is_new] = texts_.try_emplace(record.commit);
    std::string& text = entry->second;
    if (!is_new) return text;
    if (!record.commit.empty()) {
      text = case_at(record.commit, document_, case_file_).value_or("");
    } else if (std::filesystem::exists(case_file_)) {
      text = sys::read_file(case_file_);
    }
    const auto of_case = record.results.inputs.find("case");
    const bool is_its_own =
        of_case != record.results.inputs.end() && sys::sha256_of_text(text) == of_case->second;
    if (!is_its_own) text.clear();
    return text;
  }

  std::filesystem::path document_, case_file_;
  std::map<std::string, std::string> texts_;  // by commit
};

/// One limit through the records.
class Dated {
 public:
  Dated(const std::vector<RecordedResults>& records, Cases& cases, const std::string& claim,
        const NamedLimit& limit)
      : records_(records),
        cases_(cases),
        claim_("claim " + claim),
        what_(claim_ + ": " + limit.quantity),
        condition_(limit.condition),
        is_computed_(limit.reason.starts_with("theory:") || limit.reason.starts_with("method:")) {
    while (came_ < records.size() && limit_in(came_) != condition_) ++came_;
    while (judged_ < records.size() && !judges(judged_)) ++judged_;
  }

  /// The record with a result at another limit, if this one was chosen after it.
  std::optional<std::size_t> chosen_after() const {
    if (is_computed_ || came_ == records_.size()) return std::nullopt;
    // A verdict that is undecided shows the number, too.
    for (std::size_t i = 0; i < came_; ++i) {
      const bool has_limit = records_[i].results.limits.contains(what_);
      if (has_limit && cases_.are_the_same(records_[i], records_[came_])) return i;
    }
    return std::nullopt;
  }

  bool is_older() const {
    if (came_ == 0 || came_ >= judged_ || judged_ == records_.size()) return false;
    for (std::size_t i = came_; i < records_.size(); ++i) {
      if (limit_in(i) != condition_) return false;
    }
    return true;
  }

  const std::string& what() const { return what_; }
  const std::string& condition() const { return condition_; }
  std::string limit_in(std::size_t i) const {
    const auto found = records_[i].results.limits.find(what_);
    return found == records_[i].results.limits.end() ? "" : found->second;
  }
  const std::string& commit() const { return records_[came_].commit; }

 private:
  /// Whether the criterion has a result there: a claim of one criterion that is undecided has none.
  bool judges(std::size_t i) const {
    const Manifest& results = records_[i].results;
    if (!results.limits.contains(what_)) return false;
    const auto verdict = results.verdicts.find(claim_);
    const auto n_criteria = std::ranges::count_if(results.limits, [this](const auto& limit) {
      return limit.first.starts_with(claim_ + ": ");
    });
    return n_criteria > 1 || verdict == results.verdicts.end() || verdict->second != "undecided";
  }

  const std::vector<RecordedResults>& records_;
  Cases& cases_;
  std::string claim_, what_, condition_;
  bool is_computed_;
  std::size_t came_ = 0;    // the first record with this limit
  std::size_t judged_ = 0;  // the first with a result
};

}  // namespace

DatedLimits dated_limits(const std::filesystem::path& document, const Manifest& now,
                         const Names& names, const std::filesystem::path& case_file) {
  std::vector<RecordedResults> records = records_in(document, now.project);
  if (records.empty()) return {};
  records.push_back({.commit = "", .results = now});
  const auto at = [](const std::string& commit) {
    return commit.empty() ? "is in no committed results.json"
                          : "came into results.json at commit " + commit.substr(0, 12);
  };
  Cases cases(document, case_file);
  DatedLimits dated;
  for (const auto& [id, claim] : names.claims) {
    for (const NamedLimit& limit : claim.limits) {
      const Dated one(records, cases, id, limit);
      if (const auto first = one.chosen_after()) {
        dated.ages[one.what()] = chosen_after;
        dated.chosen_after.push_back(fmt::format(
            "{}: {}: the limit was chosen after the result: '{}' {}, and commit {} has a "
            "result at '{}'",
            claim.place, one.what(), one.condition(), at(one.commit()),
            records[*first].commit.substr(0, 12), one.limit_in(*first)));
      } else if (one.is_older()) {
        dated.ages[one.what()] = older_than_verdict;
      }
    }
  }
  return dated;
}

}  // namespace literate
