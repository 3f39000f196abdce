// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/changes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "config/units.hpp"
#include "literate/values/decimal.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

using Numbers = std::map<std::string, ManifestNumber>;

constexpr std::string_view of_tables = "table ";

std::string what_of(const std::string& name) {
  return name.starts_with(of_tables) ? name : "value " + name;
}

/// The name by which the prose asks for it: a cell is printed with its table.
std::string asked_for(const std::string& what) {
  return what.starts_with(of_tables) ? what.substr(0, what.find(',')) : what;
}

auto identity(const ManifestNumber& number) {
  return std::tuple(number.number, number.abs_error, number.sides, number.standard, number.printed,
                    number.unit.value_or(""));
}

/// What a reader takes for the error of a number, beside its bound, is its standard uncertainty.
bool is_within_errors(const ManifestNumber& a, const ManifestNumber& b) {
  if (agree(a, b)) return true;
  if (!a.abs_error || !b.abs_error) return false;
  return std::abs(a.number - b.number) <= bounds_between(a, b) + a.standard + b.standard;
}

/// The former names by the new ones.
std::map<std::string, std::string> renamed(const Numbers& before, const Numbers& after) {
  using Candidates = std::map<decltype(identity(ManifestNumber())), std::vector<std::string>>;
  const auto only_in = [](const Numbers& these, const Numbers& those) {
    Candidates names;
    for (const auto& [name, number] : these) {
      if (!those.contains(name) && !name.starts_with(of_tables)) {
        names[identity(number)].push_back(name);
      }
    }
    return names;
  };
  const Candidates gone = only_in(before, after), added = only_in(after, before);
  std::map<std::string, std::string> former;
  for (const auto& [number, names] : added) {
    const auto same = gone.find(number);
    if (same == gone.end() || names.size() > 1 || same->second.size() > 1) continue;
    former[names.front()] = same->second.front();
  }
  return former;
}

/// The number in another unit; none if it has no number there.
std::optional<ManifestNumber> in_unit(ManifestNumber number, const std::string& unit) {
  try {
    const double former = number.number, factor = config::converted(1, *number.unit, unit);
    number.number = config::converted(former, *number.unit, unit);
    if (number.abs_error) number.abs_error = factor * *number.abs_error;
    number.standard *= factor;
    number.sides.reset();
    number.unit = unit;
    return number;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::string digits_in(const std::string& printed) {
  std::string digits;
  std::ranges::copy_if(printed, std::back_inserter(digits), sys::is_digit);
  return digits;
}

std::optional<ChangeKind> moved(const ManifestNumber& before, const ManifestNumber& after) {
  if (have_other_units(before, after)) {
    const auto converted = in_unit(before, *after.unit);
    constexpr double rounding = 1e-12;  // of the conversion
    if (!converted ||
        std::abs(converted->number - after.number) <= rounding * std::abs(after.number) ||
        is_within_errors(*converted, after)) {
      return ChangeKind::other_unit;
    }
    return before.abs_error && after.abs_error ? ChangeKind::beyond_error : ChangeKind::moved;
  }
  if (before.number == after.number) {
    const bool has_same_error = std::tie(before.abs_error, before.sides, before.standard) ==
                                std::tie(after.abs_error, after.sides, after.standard);
    if (before.printed == after.printed) {
      return has_same_error ? std::nullopt : std::optional(ChangeKind::other_error);
    }
    // A kind of uncertainty may have another name.
    if (has_same_error && digits_in(before.printed) == digits_in(after.printed)) {
      return ChangeKind::other_text;
    }
    return has_same_error ? ChangeKind::other_digits : ChangeKind::other_error;
  }
  // Of a number that stands as it is nobody knows an error within which it could have moved.
  const bool has_errors = before.abs_error && after.abs_error;
  if (!has_errors && before.printed == after.printed) return ChangeKind::other_digits;
  if (!has_errors) return ChangeKind::moved;
  return is_within_errors(before, after) ? ChangeKind::within_error : ChangeKind::beyond_error;
}

/// As the index prints it, with two digits and a bound rounded up.
std::string error_of(const ManifestNumber& number) {
  const auto up = [](double bound) {
    return bound > 0 ? fmt::format("{:.2g}", number_of(rounded_up_to_digits(bound, 2))) : "0";
  };
  if (number.sides) {
    return fmt::format("{} below, {} above", up(number.sides->first), up(number.sides->second));
  }
  const std::string bound = up(number.abs_error.value_or(0));
  return number.standard > 0 ? fmt::format("{:.2g} ± {}", number.standard, bound) : bound;
}

/// An error is told where it alone is another, if it is printed: by an index of values, which has
/// no cells of tables.
std::vector<Change> of_numbers(const Numbers& before, const Numbers& after, bool has_index) {
  const auto former = renamed(before, after);
  std::set<std::string> taken;
  std::vector<Change> changes;
  for (const auto& [name, number] : after) {
    if (const auto earlier = former.find(name); earlier != former.end()) {
      taken.insert(earlier->second);
      changes.push_back({ChangeKind::renamed, what_of(name), earlier->second, name, {}});
      continue;
    }
    const auto earlier = before.find(name);
    if (earlier == before.end()) {
      changes.push_back({ChangeKind::added, what_of(name), "", number.printed, {}});
    } else if (const auto kind = moved(earlier->second, number)) {
      const bool is_cell = name.starts_with(of_tables);
      const bool tells_unit = is_cell && have_other_units(earlier->second, number);
      const bool tells_error = has_index && !is_cell && earlier->second.printed == number.printed &&
                               error_of(earlier->second) != error_of(number);
      const auto told = [&](const ManifestNumber& one) {
        if (tells_error) return fmt::format("{} (error {})", one.printed, error_of(one));
        return tells_unit ? one.printed + " " + *one.unit : one.printed;
      };
      changes.push_back({*kind, what_of(name), told(earlier->second), told(number), {}});
    }
  }
  for (const auto& [name, number] : before) {
    if (after.contains(name) || taken.contains(name)) continue;
    changes.push_back({ChangeKind::gone, what_of(name), number.printed, "", {}});
  }
  return changes;
}

/// Of texts by name, such as verdicts.
std::vector<Change> of_texts(const Manifest::Texts& before, const Manifest::Texts& after,
                             ChangeKind other) {
  std::vector<Change> changes;
  for (const auto& [name, text] : after) {
    const auto earlier = before.find(name);
    if (earlier == before.end()) {
      changes.push_back({ChangeKind::added, name, "", text, {}});
    } else if (earlier->second != text) {
      changes.push_back({other, name, earlier->second, text, {}});
    }
  }
  for (const auto& [name, text] : before) {
    if (!after.contains(name)) changes.push_back({ChangeKind::gone, name, text, "", {}});
  }
  return changes;
}

/// What stands for digests, which tell a reader nothing.
std::vector<Change> without_digests(std::vector<Change> changes) {
  for (Change& change : changes) change.before = change.after = "";
  return changes;
}

/// Of the program's words. Those of what is new or gone are told with it.
std::vector<Change> of_words(const Manifest::Texts& before, const Manifest::Texts& after) {
  std::vector<Change> changes = of_texts(before, after, ChangeKind::other_text);
  std::erase_if(changes, [](const Change& one) { return one.kind != ChangeKind::other_text; });
  // That no fault was planted in this state of the code is said once.
  const auto is_unknown = [](const Change& one) { return one.after == "faults not known"; };
  if (std::ranges::count_if(changes, is_unknown) > 1) {
    std::erase_if(changes, is_unknown);
    changes.push_back(
        {ChangeKind::other_text, "planted faults of all claims", "known", "not known", {}});
  }
  return changes;
}

/// The changes of numbers and of texts: what was a number and is a text, or the reverse, is told
/// once.
std::vector<Change> together(const std::vector<Change>& of_numbers,
                             const std::vector<Change>& of_texts) {
  std::map<std::string, Change> by_name;
  for (const auto* changes : {&of_numbers, &of_texts}) {
    for (const Change& change : *changes) {
      const auto [place, is_first] = by_name.emplace(change.what, change);
      if (is_first) continue;
      // It is gone as the one, and so has no text after, and new as the other.
      Change& told = place->second;
      told.kind = ChangeKind::other_text;
      told.before += change.before;
      told.after += change.after;
    }
  }
  std::vector<Change> all;
  for (const auto& [what, change] : by_name) all.push_back(change);
  return all;
}

constexpr std::string_view of_listings = "listing ";

std::vector<Change> of_excerpts(const Manifest& before, const Manifest& after) {
  const auto digests = [](const Manifest& manifest) {
    constexpr std::string_view folder = "generated/excerpts/", ending = ".txt";
    Manifest::Texts listings;
    for (const auto& [file, digest] : manifest.outputs) {
      if (!file.starts_with(folder) || !file.ends_with(ending)) continue;
      const std::size_t length = file.size() - folder.size() - ending.size();
      listings[std::string(of_listings) + file.substr(folder.size(), length)] = digest;
    }
    return listings;
  };
  return without_digests(of_texts(digests(before), digests(after), ChangeKind::other_text));
}

/// The digests of what is drawn and of what it is drawn from, «figure x».
struct Figures {
  Manifest::Texts drawings, data;
};

Figures figures_in(const Manifest& manifest) {
  constexpr std::string_view folder = "generated/figures/";
  Figures figures;
  for (const auto& [file, digest] : manifest.outputs) {
    if (!file.starts_with(folder)) continue;
    const std::string rest = file.substr(folder.size());
    const auto end = rest.find('/');
    if (end == std::string::npos) continue;
    const std::string name = rest.substr(0, end), part = rest.substr(end + 1);
    const bool is_drawing = part == name + ".pdf" || part == name + ".tex";
    (is_drawing ? figures.drawings : figures.data)["figure " + name] += digest;
  }
  return figures;
}

std::vector<Change> of_figures(const Figures& before, const Figures& after) {
  std::vector<Change> changes =
      of_texts(before.drawings, after.drawings, ChangeKind::other_drawing);
  const auto is_drawn_alike = [&](const Change& change) {
    return change.kind == ChangeKind::other_data &&
           std::ranges::find(changes, change.what, &Change::what) == changes.end();
  };
  const std::vector<Change> data = of_texts(before.data, after.data, ChangeKind::other_data);
  std::vector<Change> alike;
  std::ranges::copy_if(data, std::back_inserter(alike), is_drawn_alike);
  changes.insert(changes.end(), alike.begin(), alike.end());
  return without_digests(std::move(changes));
}

/// As `sort -V` sorts: row 2 before row 10; values before cells.
std::vector<Change> sorted(std::vector<Change> changes) {
  std::ranges::stable_sort(changes, [](const Change& a, const Change& b) {
    const bool is_cell = a.what.starts_with(of_tables);
    if (is_cell != b.what.starts_with(of_tables)) return !is_cell;
    return strverscmp(a.what.c_str(), b.what.c_str()) < 0;
  });
  return changes;
}

}  // namespace

std::string name_of(ChangeKind kind) {
  constexpr std::array<const char*, 14> names{"new",
                                              "gone",
                                              "renamed",
                                              "moved",
                                              "moved beyond both errors",
                                              "moved within both errors",
                                              "other digits only",
                                              "another error",
                                              "another text",
                                              "in another unit",
                                              "another drawing",
                                              "other data only",
                                              "other verdict",
                                              "other limit"};
  return names.at(static_cast<std::size_t>(kind));
}

std::vector<Change> changes_between(const Manifest& former, const Manifest& later,
                                    const std::vector<Sentence>& sentences_before,
                                    const std::vector<Sentence>& sentences_after,
                                    const std::map<std::string, StoredNumber>& stored) {
  const Manifest before = with_row_names(former, later), after = with_row_names(later, former);
  // What a manifest of an earlier version does not tell is not new.
  const auto comparable = [&](const Manifest::Texts& then, const Manifest::Texts& now) {
    return before.is_of_earlier_version && then.empty() ? Manifest::Texts() : now;
  };
  const Manifest::Texts limits = comparable(before.limits, after.limits);
  const Manifest::Texts texts = comparable(before.texts, after.texts);
  const Manifest::Texts outcomes = comparable(before.outcomes, after.outcomes);
  const bool has_index =
      sentences_after.empty() || std::ranges::any_of(sentences_after, [](const Sentence& sentence) {
        return sentence.latex.find("\\valueindex") != sentence.latex.npos;
      });
  std::vector<Change> all;
  for (auto&& more :
       {of_texts(before.verdicts, after.verdicts, ChangeKind::other_verdict),
        of_texts(before.outcomes, outcomes, ChangeKind::other_verdict),
        of_texts(before.limits, limits, ChangeKind::other_limit),
        together(of_numbers(before.numbers, after.numbers, has_index),
                 of_texts(before.texts, texts, ChangeKind::other_text)),
        of_words(before.words, after.words), of_figures(figures_in(before), figures_in(after)),
        of_excerpts(before, after)}) {
    const std::vector<Change> in_order = sorted(more);
    all.insert(all.end(), in_order.begin(), in_order.end());
  }
  for (Change& change : all) {
    // No sentence prints where the uncertainty of a value comes from; an index does.
    if (change.what.ends_with(": sources of uncertainty")) {
      change.is_printed = has_index;
      continue;
    }
    const std::string name = asked_for(change.what.substr(0, change.what.find(": ")));
    const auto& sentences = change.kind == ChangeKind::gone ? sentences_before : sentences_after;
    const bool is_verdict = change.what.starts_with("claim ") && change.what == name;
    for (const Sentence& sentence : sentences) {
      const auto counts = sentence.names.lower_bound(std::string(counts_claims));
      const bool has_count = counts != sentence.names.end() && counts->starts_with(counts_claims);
      if (sentence.names.contains(name) || (is_verdict && has_count)) {
        change.printed_in.push_back(sentence);
      }
    }
    const std::string value = change.name_of_value();
    const bool is_in_index = has_index && !value.empty();
    const bool needs_sentence = !value.empty() || name.starts_with(of_tables);
    change.is_printed =
        sentences.empty() || !needs_sentence || is_in_index || !change.printed_in.empty();
    const auto was = before.numbers.find(value);
    const auto is = stored.find(value);
    if (was != before.numbers.end() && is != stored.end()) {
      tell_styles(change, is->second, was->second);
    }
  }
  // Another document may print this listing.
  std::erase_if(all, [](const Change& change) {
    return change.what.starts_with(of_listings) && change.printed_in.empty();
  });
  return all;
}

}  // namespace literate
