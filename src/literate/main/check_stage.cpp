// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "literate/changes/changes.hpp"
#include "literate/changes/dated_limits.hpp"
#include "literate/changes/history.hpp"
#include "literate/changes/reread.hpp"
#include "literate/document/names.hpp"
#include "literate/figures/plotted.hpp"
#include "literate/main/stages.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/prose/prose.hpp"
#include "literate/prose/quotations.hpp"
#include "literate/prose/references.hpp"
#include "literate/prose/restyle.hpp"
#include "literate/prose/statements.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

using command_line::complain;
using command_line::ExitCode;

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) complain(line, ExitCode::failed);
}

/// What the scripts of drawn figures print that was typed, and what of their data they leave out
/// without a comment «# outside: reason».
std::vector<std::string> script_findings(const std::filesystem::path& generated, const Names& names,
                                         const std::string& label) {
  static const sys::Pattern mark(R"((?:^|\n)\s*(?:set\b[^\n#]*)?#\s*outside\b:?[ \t]*(\S?))");
  const std::filesystem::path scratch = generated.string() + ".points";
  const auto figures = generated / "figures";
  std::vector<std::string> drawn;
  for (const auto& [name, place] : names.figures) {
    if (std::filesystem::is_regular_file(figures / name / "script.gp")) drawn.push_back(name);
  }
  std::vector<std::vector<std::string>> found(drawn.size());
  std::filesystem::remove_all(scratch);
  sys::for_each_parallel(drawn.size(), 0, [&](std::size_t i) {
    const std::string script = sys::read_file(figures / drawn[i] / "script.gp");
    const std::string file = fmt::format("{}/{}.gp", label, drawn[i]);
    found[i] = typed_numbers_in_script(script, file);
    for (const std::string& block : unread_blocks(figures / drawn[i])) {
      found[i].push_back(fmt::format(
          "{}: the data '{}' are registered, and the script does not draw them", file, block));
    }
    const std::size_t n_outside =
        n_points_outside(figures / drawn[i], drawn[i], scratch / drawn[i]);
    const auto marked = mark.find_in(script);
    if (n_outside > 0 && (!marked || marked->parts[1].empty())) {
      found[i].push_back(fmt::format(
          "{}: {} of the points that are registered lie outside its ranges: widen them, or say why "
          "in a line '# outside: reason'",
          file, n_outside));
    } else if (n_outside == 0 && marked) {
      found[i].push_back(fmt::format("{}: '# outside' is said where no point is", file));
    }
  });
  std::filesystem::remove_all(scratch);
  std::vector<std::string> findings;
  for (auto& of_one : found) std::ranges::move(of_one, std::back_inserter(findings));
  const auto style = figures / "style.gp";
  if (std::filesystem::is_regular_file(style)) {
    std::ranges::move(typed_numbers_in_script(sys::read_file(style), label + "/style.gp"),
                      std::back_inserter(findings));
  }
  return findings;
}

// Holds the sentences against the results that they were written at, and limits against the first
// results that they judged, if results.json beside the prose keeps those.
ExitCode reread(const Settings& settings, const std::string& project, const Names& names,
                bool records) {
  const std::filesystem::path record = settings.document / "results.json";
  Manifest now = printed_results(results_in(settings.generated() / "names.json", project));
  now.facts["case"] = {{"name", settings.case_file.filename().string()}};
  now.inputs["case"] = names.case_sha256;
  if (!records) {
    if (!std::filesystem::exists(record)) return ExitCode::success;
    // The sentences may be of another case.
    if (read_manifest(record, project).facts != now.facts) return ExitCode::success;
  }
  const Reread found =
      sentences_to_reread(settings.document, now, settings.case_file, names.numbers);
  DatedLimits dated;
  if (found.has_history) dated = dated_limits(settings.document, now, names, settings.case_file);
  now.ages = dated.ages;
  if (records) sys::write_if_changed(record, manifest_json(now));
  const Manifest recorded = read_manifest(record, project);
  ExitCode answer = ExitCode::success;
  for (const Change& change : changes_between(recorded, now, {}, {})) {
    if (change.kind == ChangeKind::within_error || change.kind == ChangeKind::other_digits ||
        change.kind == ChangeKind::other_error) {
      continue;
    }
    const char* part = change.kind == ChangeKind::other_limit     ? "the limit of "
                       : change.kind == ChangeKind::other_verdict ? "the verdict of "
                                                                  : "";
    answer = complain(fmt::format("results.json is not of these results, {}{} is another; "
                                  "RECORD=1 writes it anew",
                                  part, change.what),
                      ExitCode::failed);
    break;
  }
  if (found.has_history && recorded.ages != now.ages) {
    answer =
        complain("results.json tells other ages of limits than git does; RECORD=1 writes it anew",
                 ExitCode::failed);
  }
  for (const std::string& limit : dated.chosen_after) {
    complain("note: " + limit, ExitCode::success);
  }
  print(found.sentences);
  if (!found.sentences.empty()) answer = ExitCode::failed;
  for (const std::string& why : found.unknown) {
    complain("note: whether sentences must be read again is not known: " + why, ExitCode::success);
  }
  if (found.has_history) return answer;
  return complain(
      "what was known when a sentence was written, or a limit chosen, is not known: there is no "
      "git history, or a part of one ('git fetch --unshallow' brings the rest)",
      ExitCode::bad_input);
}

// Inputs of the paper that git ignores, where it knows others: no commit has them, and a checkout
// is called clean without them.
std::vector<std::string> ignored_inputs(const Settings& settings, const std::string& project) {
  const std::filesystem::path made = settings.output / "manifest.json";
  if (!std::filesystem::exists(made)) return {};
  std::vector<std::string> tracked{"ls-files", "--"},
      ignored{"ls-files", "--others", "--ignored", "--exclude-standard", "--"};
  for (const auto& [file, digest] : read_manifest(made, project).inputs) {
    tracked.push_back(file);
    ignored.push_back(file);
  }
  std::vector<std::string> findings;
  try {
    if (git(settings.root, tracked).value_or("").empty()) return {};
    const std::string files = git(settings.root, ignored).value_or("");
    for (const std::string_view file : sys::lines_of(files)) {
      if (file.empty()) continue;
      findings.push_back(fmt::format(
          "{}: git ignores this file, so that no commit has it, and nobody else can make the paper",
          file));
    }
  } catch (const sys::ToolError&) {
    return {};  // without git there are no commits
  }
  return findings;
}

ExitCode run(const Settings& settings, const Paper& paper, const std::string& quoted_text,
             bool records) {
  const Names names = read_names(settings.generated() / "names.json");
  ReferenceReport references = check_references(settings.document, names);
  std::ranges::move(missing_inputs(settings.document, settings.generated()),
                    std::back_inserter(references.errors));
  std::vector<std::string> findings = typed_numbers_below(settings.document);
  const auto add = [&](std::vector<std::string> more) {
    std::ranges::move(more, std::back_inserter(findings));
  };
  add(typed_numbers_in(names.texts));
  add(script_findings(settings.generated(), names, settings.figures.filename().string()));
  add(ignored_inputs(settings, paper.project));
  add(unquoted_statements(statements_below(settings.document)));
  if (!quoted_text.empty()) {
    add(quotation_errors(read_quotations(settings.document), quoted_text));
  }
  const Restyled restyled = restyled_values(settings.document, names);
  print(references.errors);
  print(restyled.errors);
  for (const std::string& name : references.unused) {
    complain(name + " is registered and not used", ExitCode::failed);
  }
  print(findings);
  for (const std::string& note : names.claim_notes) {
    complain("note: " + note, ExitCode::success);
  }
  const ExitCode of_sentences = reread(settings, paper.project, names, records);
  const ExitCode of_faults = command_line::answer_faults(names.faults);
  if (!references.errors.empty() || !restyled.errors.empty()) return ExitCode::bad_input;
  if (!references.unused.empty() || !findings.empty()) return ExitCode::failed;
  return of_sentences == ExitCode::success ? of_faults : of_sentences;
}

}  // namespace

void add_check_stage(CLI::App& program, ExitCode& exit_code, const Paper& paper) {
  const auto quoted_text = std::make_shared<std::string>();
  const auto records = std::make_shared<bool>(false);
  add_stage(
      program, exit_code, "check",
      "Check the prose of the document against what `compute` wrote: unknown names, unused ones, "
      "missing parts, typed numbers, points that no figure shows, quotations, sentences to be read "
      "again, what does not hold",
      [quoted_text, records, &paper](const Settings& settings) {
        return run(settings, paper, *quoted_text, *records);
      },
      [quoted_text, records](CLI::App& command) {
        command_line::add_switch(
            command, "--record", *records,
            "Write the results beside the prose, for later lists of sentences");
        command_line::add_text(command, "--quoted-text", *quoted_text, "FILE",
                               "The text that is quoted: hold every quotation against it");
      });
}

}  // namespace literate
