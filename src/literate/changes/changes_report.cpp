// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/changes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>

#include "literate/page/html_text.hpp"
#include "system/csv.hpp"

namespace literate {
namespace {

/// «992.8 psi, was 994.1 psi», as far as there is something to say.
std::string difference(const Change& change) {
  if (change.kind == ChangeKind::renamed) return "was " + change.before;
  if (change.before.empty()) return change.after;
  if (change.after.empty()) return "was " + change.before;
  return fmt::format("{}, was {}", change.after, change.before);
}

std::string quoted(const std::vector<Sentence>& sentences) {
  std::string text;
  for (const Sentence& sentence : sentences) text += "> " + sentence.latex + "\n";
  return text;
}

/// «; printed in a.tex:12, b.tex:3».
std::string places_of(const Change& change) {
  std::string text;
  for (const Sentence& sentence : change.printed_in) {
    text += text.empty()
                ? change.kind == ChangeKind::gone ? "; was printed in the former " : "; printed in "
                : ", ";
    text += place_of(sentence);
  }
  return text;
}

/// «other verdict, refuted, was confirmed».
std::string told(const Change& change) {
  const std::string said = difference(change);
  return name_of(change.kind) + (said.empty() ? "" : ", ") + said;
}

/// What is told together: a claim with its criteria, and the cells of a table.
std::string group_of(const Change& change) {
  const bool is_claim = change.what.starts_with("claim ");
  return change.what.substr(0, change.what.find(is_claim ? ": " : ", row "));
}

/// A list of the changes that a reader sees. Of a table with many it has their number.
std::string results_together(const std::vector<Change>& changes) {
  constexpr std::size_t most_cells = 4;
  std::vector<std::string> order;
  std::map<std::string, std::vector<const Change*>> groups;
  for (const Change& change : changes) {
    if (!change.is_seen()) continue;
    std::vector<const Change*>& group = groups[group_of(change)];
    if (group.empty()) order.push_back(group_of(change));
    group.push_back(&change);
  }
  std::string text;
  for (const std::string& name : order) {
    const std::vector<const Change*>& group = groups.at(name);
    const Change& first = *group.front();
    if (name.starts_with("claim ")) {
      const std::string verdict = first.what == name ? ": " + told(first) : "";
      text += fmt::format("- {}{}{}\n", name, verdict, places_of(first));
      for (const Change* change : group) {
        if (change->what == name) continue;
        text += fmt::format("  - {}: {}\n", change->what.substr(name.size() + 2), told(*change));
      }
    } else if (group.size() > most_cells) {
      text += fmt::format("- {}: {} cells are others{}\n", name, group.size(), places_of(first));
    } else {
      for (const Change* change : group) {
        text += fmt::format("- {}: {}{}\n", change->what, told(*change), places_of(*change));
      }
    }
  }
  return text;
}

}  // namespace

std::string changes_text(const std::vector<Change>& changes) {
  std::string text;
  int n_unseen = 0, n_figures = 0;
  for (const Change& change : changes) {
    if (!change.is_seen()) {
      ++(change.kind == ChangeKind::other_data ? n_figures : n_unseen);
      continue;
    }
    const std::string said = difference(change);
    text += fmt::format("{:<24}  {}{}{}\n", name_of(change.kind), change.what,
                        said.empty() ? "" : ": ", said);
    for (const Sentence& sentence : change.printed_in) {
      text += fmt::format("{:<24}    {}\n", "", place_of(sentence));
    }
  }
  if (n_unseen > 0) {
    text +=
        fmt::format("{} {} or {} moved, which nothing printed shows: changes.csv has {}\n",
                    n_unseen, n_unseen == 1 ? "number" : "numbers",
                    n_unseen == 1 ? "its error" : "their errors", n_unseen == 1 ? "it" : "them");
  }
  if (n_figures > 0) {
    text += fmt::format(
        "{} {} drawn as before from other data or by another script: changes.csv has {}\n",
        n_figures, n_figures == 1 ? "figure is" : "figures are", n_figures == 1 ? "it" : "them");
  }
  return text;
}

std::string changes_csv(const std::vector<Change>& changes) {
  std::string csv = sys::csv_line({"class", "what", "before", "after", "file", "line"});
  const auto add = [&](const Change& change, const std::string& file, const std::string& line) {
    csv +=
        sys::csv_line({name_of(change.kind), change.what, change.before, change.after, file, line});
  };
  for (const Change& change : changes) {
    if (change.printed_in.empty()) add(change, "", "");
    for (const Sentence& sentence : change.printed_in) {
      add(change, path_of(sentence), std::to_string(sentence.first_line));
    }
  }
  return csv;
}

std::string changes_html(const std::vector<Change>& changes, const Compared& compared) {
  std::string rows;
  for (const Change& change : changes) {
    std::string places;
    for (const Sentence& sentence : change.printed_in) {
      places += fmt::format("{}<code>{}</code> {}", places.empty() ? "" : "<br>",
                            escape_html(place_of(sentence)), escape_html(sentence.latex));
    }
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        name_of(change.kind), escape_html(change.what), escape_html(change.before),
                        escape_html(change.after), places);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>What changed</title>\n"
      "<style>body{{font:16px/1.5 sans-serif;margin:1rem}}table{{border-collapse:collapse}}"
      "th,td{{text-align:left;vertical-align:top;padding:.3rem .6rem;border-bottom:1px solid #999}}"
      "div{{overflow-x:auto}}</style>\n</head>\n<body>\n<h1>What changed</h1>\n"
      "<p>Before: {}. After: {}.</p>\n"
      "<p>A number moved beyond both errors if it moved by more than the former and the present "
      "one together, within both if by less. Other digits only are the same number printed in "
      "another way, or one without an "
      "error that moved in digits that are not printed. Other data only belong to a figure that is "
      "drawn as before, from other data or by another script.</p>\n"
      "<div tabindex=\"0\" role=\"region\" aria-label=\"Changes\">\n"
      "<table>\n<thead><tr><th scope=\"col\">Class</th><th scope=\"col\">What</th>"
      "<th scope=\"col\">Before</th><th scope=\"col\">After</th>"
      "<th scope=\"col\">Printed in</th></tr></thead>\n<tbody>\n{}</tbody>\n</table>\n</div>\n"
      "</body>\n</html>\n",
      escape_html(compared.before), escape_html(compared.after), rows);
}

std::vector<Edit> edits_between(const std::vector<Sentence>& before,
                                const std::vector<Sentence>& after) {
  // length[i][j] is that of the longest common subsequence of before[i…] and after[j…].
  std::vector<std::vector<std::size_t>> length(before.size() + 1,
                                               std::vector<std::size_t>(after.size() + 1, 0));
  for (std::size_t i = before.size(); i-- > 0;) {
    for (std::size_t j = after.size(); j-- > 0;) {
      length[i][j] = before[i].latex == after[j].latex
                         ? length[i + 1][j + 1] + 1
                         : std::max(length[i + 1][j], length[i][j + 1]);
    }
  }
  std::vector<Edit> edits;
  Edit edit;
  const auto finish = [&] {
    if (!edit.before.empty() || !edit.after.empty()) edits.push_back(std::move(edit));
    edit = {};
  };
  std::size_t i = 0, j = 0;
  while (i < before.size() || j < after.size()) {
    if (i < before.size() && j < after.size() && before[i].latex == after[j].latex) {
      finish();
      ++i, ++j;
    } else if (j == after.size() || (i < before.size() && length[i + 1][j] >= length[i][j + 1])) {
      edit.before.push_back(before[i++]);
    } else {
      edit.after.push_back(after[j++]);
    }
  }
  finish();
  return edits;
}

std::string answer_to_referees(const std::vector<Change>& changes, const Compared& compared,
                               const std::vector<Edit>& edits) {
  std::string text = fmt::format("# Answer to the referees\n\nBefore: {}. Now: {}.\n",
                                 compared.before, compared.after);
  text += compared.has_words
              ? fmt::format("Places at which the author's words are others: {}.\n", edits.size())
              : "The former words are not known.\n";
  text += compared.has_results
              ? fmt::format(
                    "Results that a reader sees and that are others: {}; changes.csv has each.\n",
                    std::ranges::count_if(changes, &Change::is_seen))
              : "The results could not be compared.\n";
  for (const Edit& edit : edits) {
    const Sentence& first = edit.after.empty() ? edit.before.front() : edit.after.front();
    text += fmt::format("\n## {}{}{}\n\n", first.heading, first.heading.empty() ? "" : ", ",
                        place_of(first) + (edit.after.empty() ? " of the former version" : ""));
    if (!edit.before.empty()) text += "Before:\n\n" + quoted(edit.before) + "\n";
    if (!edit.after.empty()) text += "Now:\n\n" + quoted(edit.after) + "\n";
    text += "Why:\n";
  }
  const std::string results = results_together(changes);
  if (!results.empty()) text += "\n## Results that are others\n\n" + results;
  if (!compared.reasons.empty())
    text += "\n## Inputs and tools that are others (there: before, here: now)\n\n";
  for (const std::string& reason : compared.reasons) text += "- " + reason + "\n";
  return text;
}

}  // namespace literate
