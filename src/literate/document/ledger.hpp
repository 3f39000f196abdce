// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "literate/document/registered.hpp"

namespace literate {

/// a to z, then aa, ab, …: the letter of the note that is the i-th, from 0.
std::string letter_of_index(std::size_t i);

/// Why limits are what they are, a note for each kind and reason. Many limits share one, so the
/// ledger prints a letter beside the limit and explains it once. PDF and page, which know the order
/// of reading, give the letters anew in it.
class LimitNotes {
 public:
  /// The notes of all claims, in the order of registration.
  explicit LimitNotes(const Registered& registered);

  struct Note {
    std::string letter;  ///< by letter_of_index
    LimitKind kind;
    std::string reason;
  };
  const std::vector<Note>& notes() const { return notes_; }

  /// The letter of a criterion's limit. Throws std::out_of_range for one of another document.
  const std::string& letter_of(const Criterion& criterion) const;

 private:
  std::vector<Note> notes_;
};

/// How many planted faults turn a claim: «3 of 41 faults», or «faults not known».
std::string severity_text(const Registered& registered, const std::string& claim);

/// claims.tex: an entry for each claim, then the notes of the limits.
std::string claims_tex(const Registered& registered);

/// claims.csv: a row for each criterion, with claim, verdict, what was found, its limit with kind
/// and reason, outcome, margin, and how many of how many planted faults turn the claim.
std::string claims_csv(const Registered& registered);

/// What an author should know of the claims though it keeps nobody from trusting the document, a
/// line each with its place: claims that no planted fault turns; criteria whose outcome half or
/// double of a chosen limit would turn; limits of one kind with one reason that differ.
std::vector<std::string> claim_notes(const Registered& registered);

}  // namespace literate
