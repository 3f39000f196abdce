// SPDX-License-Identifier: GPL-3.0-or-later
// Which sentences must be read again, since what they print is another than when they were written.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "literate/document/names.hpp"
#include "literate/provenance/manifest.hpp"

namespace literate {

/// The results that sentences print or depend on, values, flags, verdicts and limits, as a manifest
/// without the rest.
Manifest printed_results(Manifest manifest);

/// What is known of the sentences of a document.
struct Reread {
  std::vector<std::string> sentences = {};  ///< to be read again, a line for each number or verdict
  std::vector<std::string> unknown = {};    ///< why others are not known, a line for each reason
  bool has_history = true;                  ///< false without git, and in a shallow clone
};

/// Holds each sentence that prints a value or cites a claim against the results of the commit that
/// last changed its words, as git blame tells it. It must be read again if a value has moved beyond
/// its error since then, so that its print is another, or if a text, a flag or a verdict is.
///
/// The results of a commit are in its results.json beside the prose, which is printed_results() by
/// manifest_json. They are not known if it is not there, if the record is of another case than the
/// commit's `case_file`, if the commit is the first one that there is, since the words may be
/// older, or if a rebase put it upon results that are newer than its words. Words that are older
/// than the first record, and stand beside it, are held against that one, and named as not known.
/// Words that are not committed yet are new.
///
/// A line «sentence,what,printed,reader» of read.csv beside the prose ticks it off, as long as
/// neither the sentence nor what it prints changes; each line of the list tells its own. Throws
/// sys::SourceError for a read.csv that is none.
///
/// `stored` are the present values. A sentence of which a record does not have all that it prints
/// is held against the last record too.
Reread sentences_to_reread(const std::filesystem::path& document, const Manifest& now,
                           const std::filesystem::path& case_file,
                           const std::map<std::string, StoredNumber>& stored = {});

}  // namespace literate
