// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/manifest_comparison.hpp"

#include <fmt/core.h>

#include <cmath>
#include <set>

namespace literate {
namespace {

/// Calls `differs(key, theirs, ours)` for each key whose entries are not the same; the pointer to
/// an entry that is missing is null.
template <typename Entries, typename IsSame, typename Differs>
void for_each_difference(const Entries& theirs, const Entries& ours, IsSame is_same,
                         Differs differs) {
  std::set<std::string> keys;
  for (const auto& entry : theirs) keys.insert(entry.first);
  for (const auto& entry : ours) keys.insert(entry.first);
  for (const std::string& key : keys) {
    const auto a = theirs.find(key);
    const auto b = ours.find(key);
    const auto* their_entry = a == theirs.end() ? nullptr : &a->second;
    const auto* our_entry = b == ours.end() ? nullptr : &b->second;
    if (their_entry == nullptr || our_entry == nullptr || !is_same(*their_entry, *our_entry)) {
      differs(key, their_entry, our_entry);
    }
  }
}

std::string text_or_none(const std::string* text) {
  return text == nullptr ? "none" : *text;
}

std::string printed_or_none(const ManifestNumber* number) {
  return number == nullptr ? "none" : fmt::format("{} ({})", number->number, number->printed);
}

bool is_within_errors(const ManifestNumber& a, const ManifestNumber& b) {
  if (!a.abs_error || !b.abs_error) return a.printed == b.printed;
  return std::abs(a.number - b.number) <= *a.abs_error + *b.abs_error;
}

}  // namespace

ManifestComparison compare(const Manifest& theirs, const Manifest& ours) {
  ManifestComparison result;
  const auto equal = [](const std::string& a, const std::string& b) { return a == b; };

  for_each_difference(
      theirs.outputs, ours.outputs, equal,
      [&](const std::string& file, auto*, auto*) { result.changed_outputs.push_back(file); });
  for (const auto& [part, facts] : ours.facts) {
    const auto their_part = theirs.facts.find(part);
    for_each_difference(their_part == theirs.facts.end() ? Manifest::Texts{} : their_part->second,
                        facts, equal,
                        [&](const std::string& name, const std::string* a, const std::string* b) {
                          result.reasons.push_back(fmt::format("{}: {} there, {} here", name,
                                                               text_or_none(a), text_or_none(b)));
                        });
  }
  for_each_difference(theirs.inputs, ours.inputs, equal,
                      [&](const std::string& file, auto* a, auto* b) {
                        result.reasons.push_back(fmt::format("{}: {}", file,
                                                             a == nullptr   ? "only here"
                                                             : b == nullptr ? "only there"
                                                                            : "another content"));
                      });
  for_each_difference(
      theirs.numbers, ours.numbers, is_within_errors,
      [&](const std::string& key, const ManifestNumber* a, const ManifestNumber* b) {
        result.moved.push_back(
            fmt::format("{}: {} there, {} here", key, printed_or_none(a), printed_or_none(b)));
      });
  for_each_difference(theirs.verdicts, ours.verdicts, equal,
                      [&](const std::string& name, const std::string* a, const std::string* b) {
                        result.moved.push_back(fmt::format("{}: {} there, {} here", name,
                                                           text_or_none(a), text_or_none(b)));
                      });
  return result;
}

}  // namespace literate
