// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

/// Whether a text can be a key, as in `\val{…}`, or the name of a file.
bool is_key(std::string_view text, bool may_have_dots) {
  const auto is_allowed = [=](char c) {
    return sys::is_alphanumeric(c) || c == '-' || c == '_' || (c == '.' && may_have_dots);
  };
  return !text.empty() && sys::is_alphanumeric(text.front()) &&
         std::ranges::all_of(text, is_allowed);
}

}  // namespace

void Document::remember(const std::string& kind, const std::string& name, const Place& place) {
  const bool is_file = kind == "table" || kind == "figure";
  if (!is_key(name, !is_file)) {
    fail_at(place, fmt::format("{} '{}': a name consists of letters, digits, '-' and '_'{}, and "
                               "begins with a letter or a digit",
                               kind, name, is_file ? "" : " and '.'"));
  }
  const auto [entry, is_new] = places_.try_emplace({kind, name}, place.text);
  if (!is_new) {
    fail_at(place,
            fmt::format("{} '{}' is registered twice, first at {}", kind, name, entry->second));
  }
}

template <typename Make>
auto Document::checked(const std::string& kind, const std::string& name, const Place& place,
                       Make&& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    fail_at(place, fmt::format("{} '{}': {}", kind, name, error.what()));
  }
}

void Document::value(const std::string& key, const Value& value, const Place& place) {
  checked("value", key, place, [&] { value.require_valid(); });
  remember("value", key, place);
  values_.emplace(key, value);
}

void Document::flag(const std::string& key, bool is_set, const Place& place) {
  remember("flag", key, place);
  flags_.emplace(key, is_set);
}

void Document::table(Table table, const Place& place) {
  const std::string name = table.name();
  remember("table", name, place);
  tables_.emplace(name, std::move(table));
}

void Document::figure(const std::string& name, Figure figure, const Place& place) {
  checked("figure", name, place, [&] { require_drawable(figure); });
  remember("figure", name, place);
  figures_.emplace(name, std::move(figure));
}

void Document::check(const std::string& id, const std::vector<Criterion>& criteria,
                     std::string statement, const Place& place) {
  if (criteria.empty()) fail_at(place, fmt::format("check '{}' has no criterion", id));
  check(id, verdict_of(criteria) == Verdict::holds, std::move(statement), place);
  checks_.back().second.criteria = criteria;
}

void Document::check(const std::string& id, bool passed, std::string statement,
                     const Place& place) {
  statement = checked("check", id, place, [&] { return author_latex(statement); });
  remember("check", id, place);
  checks_.emplace_back(id, Check{std::move(statement), passed});
}

void Document::claim(const std::string& id, Claim claim, const Place& place) {
  claim.route = checked("claim", id, place, [&] { return author_latex(claim.route); });
  if (claim.route.empty()) fail_at(place, fmt::format("claim '{}' has no route", id));
  if (claim.criteria.empty()) fail_at(place, fmt::format("claim '{}' has no criterion", id));
  remember("claim", id, place);
  claims_.emplace_back(id, std::move(claim));
}

void Document::append(Document part) {
  for (const auto& [kind_and_name, place] : part.places_) {
    remember(kind_and_name.first, kind_and_name.second, Place(place));
  }
  values_.merge(part.values_);
  flags_.merge(part.flags_);
  tables_.merge(part.tables_);
  figures_.merge(part.figures_);
  std::ranges::move(part.checks_, std::back_inserter(checks_));
  std::ranges::move(part.claims_, std::back_inserter(claims_));
}

void Document::progress(long done, long total) {
  progress_->done = done;
  progress_->total = total;
}

const std::string& Document::place_of(const std::string& kind, const std::string& name) const {
  return places_.at({kind, name});
}

std::vector<std::string> Document::faults() const {
  std::vector<std::string> faults;
  for (const auto& [id, check] : checks_) {
    if (check.passed) continue;
    faults.push_back(fmt::format("{}: check '{}' failed: {}{}{}", place_of("check", id), id,
                                 check.statement, check.criteria.empty() ? "" : "; ",
                                 text_of(check.criteria)));
  }
  for (const auto& [id, claim] : claims_) {
    if (claim.verdict() == claim.expected) continue;
    faults.push_back(fmt::format("{}: claim '{}': {}, expected {}; {}", place_of("claim", id), id,
                                 name_of(claim.verdict()), name_of(claim.expected),
                                 text_of(claim.criteria)));
  }
  return faults;
}

}  // namespace literate
