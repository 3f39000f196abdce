// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/ledger.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/csv.hpp"

namespace literate {
namespace {

/// To two digits of what it is above 1, so that the limit times this factor is beyond the turn.
double rounded_up_factor(double factor) {
  constexpr int n_digits = 12;  // what lies behind them is rounding
  const double above = number_of(rounded_to_digits(factor, n_digits)) - 1;
  return 1 + number_of(rounded_up_to_digits(number_of(rounded_to_digits(above, n_digits)), 2));
}

bool is_of(const LimitNotes::Note& note, const Criterion& criterion) {
  return note.kind == criterion.limit_kind() && note.reason == criterion.limit_reason();
}

}  // namespace

std::string letter_of_index(std::size_t i) {
  constexpr std::size_t n_letters = 26;
  const std::string last(1, static_cast<char>('a' + i % n_letters));
  return i < n_letters ? last : letter_of_index(i / n_letters - 1) + last;
}

LimitNotes::LimitNotes(const Registered& registered) {
  for (const auto& [id, claim] : registered.claims) {
    for (const Criterion& criterion : claim.criteria) {
      if (std::ranges::any_of(notes_, [&](const Note& note) { return is_of(note, criterion); })) {
        continue;
      }
      notes_.push_back(
          {letter_of_index(notes_.size()), criterion.limit_kind(), criterion.limit_reason()});
    }
  }
}

const std::string& LimitNotes::letter_of(const Criterion& criterion) const {
  const auto note =
      std::ranges::find_if(notes_, [&](const Note& one) { return is_of(one, criterion); });
  if (note == notes_.end()) throw std::out_of_range("no claim has this limit");
  return note->letter;
}

std::string severity_text(const Registered& registered, const std::string& claim) {
  const std::string text = registered.severity ? registered.severity->text_of(claim) : "not known";
  return text == "not known" ? "faults not known" : text;
}

std::string claims_tex(const Registered& registered) {
  const LimitNotes notes(registered);
  std::string text;
  for (const auto& [id, claim] : registered.claims) {
    text +=
        fmt::format("\\LiterateLedgerEntry{{{}}}\n  {{{}}}\n  {{{}}}{{{}}}{{{}}}{{{}}}{{%\n", id,
                    escape_latex(claim.route), name_of(claim.expected), name_of(claim.found()),
                    escape_latex_path(text_of(registered.places.at({"claim", id}))),
                    severity_text(registered, id));
    for (const Criterion& criterion : claim.criteria) {
      text += fmt::format("    \\LiterateCriterion{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}%\n",
                          escape_latex(criterion.name()), criterion.found().latex,
                          criterion.limit().latex, notes.letter_of(criterion),
                          criterion.margin().text(), name_of(criterion.outcome()),
                          escape_latex(criterion.missing()));
    }
    text += "  }\n";
  }
  for (const LimitNotes::Note& note : notes.notes()) {
    text += fmt::format("\\LiterateLimitNote{{{}}}{{{}}}{{{}}}\n", note.letter, name_of(note.kind),
                        escape_latex(note.reason));
  }
  if (registered.severity) {
    text += fmt::format("\\LiterateFaults{{{}}}\n", registered.severity->summary());
  }
  return text;
}

std::string claims_csv(const Registered& registered) {
  std::string text =
      "claim,verdict,expected,criterion,found,limit,kind,reason,outcome,margin_errors,"
      "margin_factor,turned_by,faults\n";
  const auto number = [](const std::optional<double>& known) {
    return known ? fmt::format("{}", *known) : std::string();
  };
  for (const auto& [id, claim] : registered.claims) {
    std::string turned_by, n_faults;
    if (registered.severity && registered.severity->n_turning.contains(id)) {
      turned_by = std::to_string(registered.severity->n_turning.at(id));
      n_faults = std::to_string(registered.severity->n_faults);
    }
    for (const Criterion& c : claim.criteria) {
      text += sys::csv_line(
          {id, std::string(name_of(claim.found())), std::string(name_of(claim.expected)), c.name(),
           c.found().plain, c.limit().plain, std::string(name_of(c.limit_kind())), c.limit_reason(),
           std::string(name_of(c.outcome())), number(c.margin().errors), number(c.margin().factor),
           turned_by, n_faults});
    }
  }
  return text;
}

std::vector<std::string> claim_notes(const Registered& registered) {
  std::vector<std::string> notes;
  std::map<std::pair<LimitKind, std::string>, std::map<double, std::string>> limits;
  std::map<std::pair<LimitKind, std::string>, std::string> first;
  for (const auto& [id, claim] : registered.claims) {
    const std::string place = text_of(registered.places.at({"claim", id}));
    if (registered.severity && registered.severity->n_turning.contains(id) &&
        registered.severity->n_turning.at(id) == 0) {
      notes.push_back(fmt::format("{}: claim {}: none of {} planted faults turns it", place, id,
                                  registered.severity->n_faults));
    }
    for (const Criterion& criterion : claim.criteria) {
      constexpr double doubled = 2;
      const LimitKind kind = criterion.limit_kind();
      if (kind == LimitKind::choice &&
          criterion.margin().turning_factor.value_or(doubled) < doubled) {
        notes.push_back(
            fmt::format("{}: claim {}: {} hangs on a choice, {}: a factor of {:.12g} in "
                        "the limit would turn it",
                        place, id, criterion.computed(), criterion.limit().plain,
                        rounded_up_factor(*criterion.margin().turning_factor)));
      }
      if (kind != LimitKind::choice && kind != LimitKind::data) continue;
      const std::pair reason{kind, criterion.limit_reason()};
      limits[reason].try_emplace(criterion.limit_number(), criterion.limit().plain);
      first.try_emplace(reason, fmt::format("{}: claim {}", place, id));
    }
  }
  for (const auto& [reason, different] : limits) {
    if (different.size() < 2) continue;
    std::vector<std::string> printed;
    for (const auto& [number, limit] : different) printed.push_back(limit);
    notes.push_back(fmt::format("{}: limits of {} for one reason differ: {}: '{}'", first[reason],
                                name_of(reason.first), fmt::join(printed, ", "), reason.second));
  }
  if (!registered.claims.empty() && !registered.severity) {
    notes.emplace_back(
        "which planted faults turn the claims is not known of this state of the code: 'make "
        "severity' finds it");
  }
  return notes;
}

}  // namespace literate
