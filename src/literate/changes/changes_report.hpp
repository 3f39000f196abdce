// SPDX-License-Identifier: GPL-3.0-or-later
// The differences between two states of a document, for readers and for other programs.
#pragma once

#include <string>
#include <vector>

#include "literate/changes/changes.hpp"

namespace literate {

/// A line for each change, and below it the places of the sentences that print it:
/// «moved beyond its error  value x: 992.8 psi, was 994.1 psi», «    results.tex:12».
std::string changes_text(const std::vector<Change>& changes);

/// A row for each change and sentence: class, what, before, after, file, line.
std::string changes_csv(const std::vector<Change>& changes);

/// The two states.
struct Compared {
  std::string before, after;         ///< what they are called
  std::vector<std::string> reasons;  ///< each tool or input that differs, a line each
  bool has_words = true;             ///< whether the former text is known
  bool has_results = true;           ///< whether the former results are
};

/// A page with one table.
std::string changes_html(const std::vector<Change>& changes, const Compared& compared);

/// A skeleton in Markdown of the answer to the referees: each place at which the words are others,
/// with the old and the new text, after them the numbers that moved although nobody wrote a word,
/// and the inputs and tools that are others. The author fills in the rest.
std::string answer_to_referees(const std::vector<Change>& changes, const Compared& compared,
                               const std::vector<Sentence>& sentences_before,
                               const std::vector<Sentence>& sentences_after);

}  // namespace literate
