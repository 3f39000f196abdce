// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/reread.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "literate/changes/changes.hpp"
#include "literate/changes/history.hpp"
#include "literate/prose/document_files.hpp"
#include "system/csv.hpp"
#include "system/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// The commit that last changed the words of a sentence; one that is not made yet if they are new.
Commit last_commit(const Sentence& sentence, const std::vector<Commit>& of_lines) {
  Commit last;
  for (int line = sentence.first_line; line <= sentence.last_line; ++line) {
    if (line < 1 || static_cast<std::size_t>(line) > of_lines.size()) return {};
    const Commit& commit = of_lines[static_cast<std::size_t>(line) - 1];
    if (!commit.is_made()) return commit;
    if (last.id.empty() || commit.committed > last.committed) last = commit;
  }
  return last;
}

/// The files of a document as they were: sentences and the commits of lines, at a commit or, where
/// that is empty, as they are in the folder.
class Past {
 public:
  Past(fs::path document, std::map<std::string, bool> flags)
      : document_(std::move(document)),
        flags_(std::move(flags)),
        own_(own_commands_of(document_)) {}

  /// The commit that last changed the words of a sentence that stands there now: one that breaks
  /// its lines elsewhere, or changes what stands beside it, does not.
  Commit that_wrote(const Sentence& sentence) {
    Sentence at = sentence;
    Commit commit = last_commit(at, lines(at.file, ""));
    while (!commit.is_first) {
      const std::string before = commit.is_made() ? commit.id + "^" : "HEAD";
      const std::vector<Sentence>& former = sentences(at.file, before);
      const auto same = std::ranges::find(former, at.latex, &Sentence::latex);
      if (same == former.end()) break;
      const Commit earlier = last_commit(*same, lines(at.file, before));
      if (!earlier.is_made()) break;
      at = *same;
      commit = earlier;
    }
    return commit;
  }

  bool has_results(const std::string& commit) {
    const auto [entry, is_new] = has_results_.try_emplace(commit);
    if (is_new) {
      entry->second = git(document_, {"cat-file", "-e", commit + ":./results.json"}).has_value();
    }
    return entry->second;
  }

  bool stands(const Sentence& sentence, const std::string& commit) {
    const std::vector<Sentence>& all = sentences(sentence.file, commit);
    return std::ranges::find(all, sentence.latex, &Sentence::latex) != all.end();
  }

 private:
  const std::vector<Commit>& lines(const std::string& file, const std::string& commit) {
    const auto [entry, is_new] = lines_.try_emplace({file, commit});
    if (is_new) {
      std::vector<std::string> blame{"blame", "-w", "-M", "--porcelain"};
      if (!commit.empty()) blame.push_back(commit);
      blame.insert(blame.end(), {"--", file});
      entry->second = commits_of_lines(git(document_, blame).value_or(""));
    }
    return entry->second;
  }

  const std::vector<Sentence>& sentences(const std::string& file, const std::string& commit) {
    const auto [entry, is_new] = sentences_.try_emplace({file, commit});
    if (is_new) {
      const auto text = git(document_, {"show", commit + ":./" + file});
      if (text) entry->second = sentences_in(*text, file, flags_, own_);
    }
    return entry->second;
  }

  fs::path document_;
  std::map<std::string, bool> flags_;
  OwnCommands own_;
  std::map<std::string, bool> has_results_;
  std::map<std::pair<std::string, std::string>, std::vector<Commit>> lines_;
  std::map<std::pair<std::string, std::string>, std::vector<Sentence>> sentences_;
};

/// The results at a commit, or why they are not known.
struct Former {
  std::optional<Manifest> results = {};
  std::string unknown = {};
};

Former results_at(const Commit& commit, const fs::path& document, const std::string& project,
                  const fs::path& case_file) {
  if (commit.is_first) return {.unknown = "the history that there is begins with it"};
  try {
    const auto text = git(document, {"show", commit.id + ":./results.json"});
    if (!text) return {.unknown = "it has no results.json"};
    // Words that a rebase put upon other results were not read beside them.
    const auto recorded =
        git(document, {"log", "-1", "--format=%ct", commit.id, "--", "results.json"});
    const auto when = sys::parsed<std::int64_t>(sys::stripped(recorded.value_or("")));
    if (commit.authored < commit.committed && (!when || *when > commit.authored)) {
      return {.unknown = "it was rewritten, and its results may be newer than its words"};
    }
    const Manifest record = manifest_of(*text, commit.id + ":results.json", project);
    const auto of_case = record.inputs.find("case");
    const auto its_case = case_at(commit.id, document, case_file);
    if (of_case != record.inputs.end() && its_case &&
        sys::sha256_of_text(*its_case) != of_case->second) {
      return {.unknown = "its results.json is of another case"};
    }
    return {.results = printed_results(record)};
  } catch (const sys::OutputError& error) {
    return {.unknown = error.what()};
  }
}

std::string digest_of_words(const Sentence& sentence) {
  return sys::sha256_of_text(sentence.latex).substr(0, 12);
}

/// The lines of read.csv, without the reader.
std::set<std::vector<std::string>> ticks_in(const fs::path& file) {
  std::set<std::vector<std::string>> ticks;
  if (!fs::exists(file)) return ticks;
  for (const sys::CsvRow& row : sys::parse_csv(sys::read_file(file), file.filename().string())) {
    if (row.size() != 4 || row[3].text.empty()) {
      throw sys::SourceError(row[0].place + ": a line is «sentence,what,printed,reader»");
    }
    ticks.insert({row[0].text, row[1].text, row[2].text});
  }
  return ticks;
}

bool is_to_be_read(const Change& change) {
  return change.kind == ChangeKind::beyond_error || change.kind == ChangeKind::moved ||
         change.kind == ChangeKind::other_unit || change.kind == ChangeKind::other_verdict ||
         change.kind == ChangeKind::other_text;
}

}  // namespace

Manifest printed_results(Manifest manifest) {
  std::erase_if(manifest.numbers,
                [](const auto& entry) { return entry.first.starts_with("table "); });
  std::erase_if(manifest.verdicts,
                [](const auto& entry) { return entry.first.starts_with("check "); });
  // What criteria found moves with every digit.
  std::erase_if(manifest.texts, [](const auto& entry) {
    return entry.first.starts_with("table ") || entry.first.starts_with("claim ");
  });
  manifest.facts = {};
  manifest.inputs = manifest.outputs = manifest.outcomes = manifest.words = {};
  return manifest;
}

Reread sentences_to_reread(const fs::path& document, const Manifest& now, const fs::path& case_file,
                           const std::map<std::string, StoredNumber>& stored) {
  Reread found;
  try {
    const auto is_shallow = git(document, {"rev-parse", "--is-shallow-repository"});
    if (!is_shallow || !git(document, {"rev-parse", "--verify", "HEAD"})) {
      return {.unknown = {"it is no git repository with a commit"}, .has_history = false};
    }
    found.has_history = is_shallow->starts_with("false");
  } catch (const sys::ToolError& error) {
    return {.unknown = {error.what()}, .has_history = false};
  }

  // The sentences by the commit that wrote them; of older ones by the first record, if they stood.
  std::map<std::string, std::pair<Commit, std::vector<Sentence>>> written, recorded;
  const std::string first_record =
      git(document, {"rev-list", "--reverse", "HEAD", "--", "results.json"}).value_or("");
  const Commit first{.id = first_record.substr(0, first_record.find('\n'))};
  Past past(document, flags_of(now));
  for (const Sentence& sentence : sentences_below(document, flags_of(now))) {
    const bool prints = std::ranges::any_of(sentence.names, [](const std::string& name) {
      return name.starts_with("value ") || name.starts_with("claim ") ||
             name.starts_with(counts_claims) || name.starts_with("flag ");
    });
    if (!prints) continue;
    const Commit commit = past.that_wrote(sentence);
    if (!commit.is_made()) continue;
    const bool is_known = past.has_results(commit.id);
    const bool is_older = found.has_history && (commit.is_first || !is_known) &&
                          !first.id.empty() && past.stands(sentence, first.id);
    auto& [of_these, sentences] = is_older ? recorded[first.id] : written[commit.id];
    of_these = is_older ? first : commit;
    sentences.push_back(sentence);
  }

  const auto ticks = ticks_in(document / "read.csv");
  const Manifest results = printed_results(now);
  std::map<std::string, std::pair<std::size_t, std::string>> unknown;  // by reason
  const auto not_known = [&](const std::string& reason, const std::vector<Sentence>& sentences,
                             const Commit& commit) {
    auto& [n_unknown, place] = unknown[reason];
    if (n_unknown == 0) {
      place = place_of(sentences.front());
      if (!commit.id.empty()) place += " of commit " + commit.id.substr(0, 12);
    }
    n_unknown += sentences.size();
  };
  // Sentences that print what a record does not have, by place, and what was told, by digest.
  std::map<std::string, Sentence> unrecorded;
  std::set<std::pair<std::string, std::string>> told;
  const auto hold = [&](const Commit& commit, const std::vector<Sentence>& sentences,
                        const char* when) {
    const Former then = results_at(commit, document, now.project, case_file);
    if (!then.results) return not_known(then.unknown, sentences, commit);
    std::vector<Sentence> of_these;
    for (const Change& change : changes_between(*then.results, results, {}, sentences, stored)) {
      if (change.kind == ChangeKind::added) {
        for (const Sentence& sentence : change.printed_in) {
          if (unrecorded.emplace(place_of(sentence), sentence).second) of_these.push_back(sentence);
        }
      }
      if (!is_to_be_read(change) || !change.is_seen()) continue;
      for (const Sentence& sentence : change.printed_in) {
        const std::string digest = digest_of_words(sentence);
        if (ticks.contains({digest, change.what, change.after})) continue;
        if (!told.emplace(digest, change.what).second) continue;
        found.sentences.push_back(fmt::format(
            "{}: read this sentence again: {} is {}, and was {} in results.json when it was {}, at "
            "{}; then "
            "change it, or write into read.csv: {}",
            place_of(sentence), change.what, change.after, change.before, when,
            commit.id.substr(0, 12),
            sys::stripped(sys::csv_line({digest, change.what, change.after, "your name"}))));
      }
    }
    if (!of_these.empty()) {
      not_known("its results.json does not have all that they print", of_these, commit);
    }
  };
  for (const auto& [id, entry] : written) hold(entry.first, entry.second, "written");
  for (const auto& [id, entry] : recorded) {
    hold(entry.first, entry.second, "first recorded");
    not_known(fmt::format("they are no younger than the first record, that of commit {}; only what "
                          "moved since is told",
                          entry.first.id.substr(0, 12)),
              entry.second, {});
  }
  std::vector<Sentence> incomplete;
  for (const auto& [place, sentence] : unrecorded) incomplete.push_back(sentence);
  if (!incomplete.empty()) hold({.id = "HEAD"}, incomplete, "last recorded");
  for (const auto& [reason, sentences] : unknown) {
    found.unknown.push_back(fmt::format("{} sentence{}, such as {}: {}", sentences.first,
                                        sentences.first == 1 ? "" : "s", sentences.second, reason));
  }
  std::ranges::sort(found.sentences);
  return found;
}

}  // namespace literate
