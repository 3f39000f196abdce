// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "literate/changes/sentences.hpp"
#include "literate/document/names.hpp"
#include "literate/provenance/manifest.hpp"

namespace literate {

/// What became of something that a document registers.
enum class ChangeKind {
  added,
  gone,
  renamed,        ///< the same number under another name
  moved,          ///< it has no error, and prints another
  beyond_error,   ///< it moved by more than both errors together
  within_error,   ///< it moved by less
  other_digits,   ///< the same number printed in another way, or one without an error printed alike
  other_error,    ///< the same number with another error, and so printed in another way
  other_text,     ///< of a value or cell that is no number, and of a flag
  other_unit,     ///< a number in another unit
  other_drawing,  ///< of a figure
  other_data,     ///< of a figure that is drawn as before
  other_verdict,
  other_limit  ///< of a criterion
};

/// «moved beyond both errors», as a reader is told.
std::string name_of(ChangeKind kind);

/// A difference between two states of a document.
struct Change {
  /// Whether a reader sees it: numbers also move in digits that are not printed or drawn.
  bool is_seen() const {
    return is_printed && kind != ChangeKind::other_data && (before.empty() || before != after);
  }

  /// The name of the value that moved; empty for another thing.
  std::string name_of_value() const {
    constexpr std::string_view value = "value ";
    return what.starts_with(value) ? what.substr(value.size()) : "";
  }

  ChangeKind kind;
  std::string what;  ///< «value x», «table x, row 1, column 2», «figure x», «listing x», «claim x»
  std::string before;  ///< as it was printed, or its former name; empty for something that is new
  std::string after;   ///< empty for something that is gone
  std::vector<Sentence> printed_in;  ///< the sentences that print it
  bool is_printed = true;            ///< false of a value or cell that the document prints nowhere
};

/// Lists what differs between two manifests: verdicts, limits of criteria, values, cells of tables,
/// texts and flags, figures, in this order and then by name. Each is told once, in one class.
///
/// Two numbers agree if they differ by no more than the sum of their error bounds; without a bound
/// if they are printed the same. A name that is gone was renamed if exactly one new name has its
/// number, error and print, and no other gone name has them.
/// `sentences` are those of the later document, and of the former for what is gone. `stored` are
/// the later document's values, from which follows what \val[options]{key} prints: a sentence that
/// prints a value only as it did before is none of those that print the change.
std::vector<Change> changes_between(const Manifest& before, const Manifest& after,
                                    const std::vector<Sentence>& sentences_before,
                                    const std::vector<Sentence>& sentences_after,
                                    const std::map<std::string, StoredNumber>& stored = {});

/// Leaves the sentences in which a value that was another number prints otherwise, and tells its
/// prints with options where the others are the same. `stored` is the present value.
void tell_styles(Change& change, const StoredNumber& stored, const ManifestNumber& was);

/// The manifest with the cells of some tables by the names of their rows, «table a, row «steel»,
/// column 2»: of those in which a row stands at another place in `other`, so that a row that is put
/// before others is no change of all of them.
///
/// A row is named by the text in its first column. Tables with a number there, or with one text
/// twice, keep the numbers of their rows.
Manifest with_row_names(Manifest manifest, const Manifest& other);

/// A line for each change, and below it the places of the sentences that print it:
/// «moved beyond both errors  value x: 992.8 psi, was 994.1 psi», «    results.tex:12».
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

/// A place at which the author's words are others: a run of sentences that stand in one state only,
/// between sentences that both have.
struct Edit {
  std::vector<Sentence> before, after;
};

/// The edits from one list of sentences to another, by their longest common subsequence.
std::vector<Edit> edits_between(const std::vector<Sentence>& before,
                                const std::vector<Sentence>& after);

/// A skeleton in Markdown of the answer to the referees: each place at which the words are others,
/// with the old and the new text, after them the numbers that moved although nobody wrote a word,
/// and the inputs and tools that are others. The author fills in the rest.
std::string answer_to_referees(const std::vector<Change>& changes, const Compared& compared,
                               const std::vector<Edit>& edits);

}  // namespace literate
