// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "literate/changes/changes.hpp"
#include "literate/program/commands.hpp"
#include "literate/provenance/manifest.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

struct ChangesOptions {
  std::string project, before, after, names, document_before, document, label, output;
};

/// The inputs and tools that differ. A project that brings the engine itself has one commit for
/// both, and its own changes are none of the engine.
std::vector<std::string> reasons_beside_its_own_engine(const Manifest& before,
                                                       const Manifest& after) {
  const auto brings_engine = [](const Manifest& manifest) {
    const auto sources = manifest.facts.find("sources"), engine = manifest.facts.find("engine");
    return sources != manifest.facts.end() && engine != manifest.facts.end() &&
           sources->second.contains("commit") && engine->second.contains("engine commit") &&
           sources->second.at("commit") == engine->second.at("engine commit");
  };
  std::vector<std::string> reasons = compare(before, after).reasons;
  if (brings_engine(before) && brings_engine(after)) {
    std::erase_if(reasons, [](const std::string& line) { return line.starts_with("engine "); });
  }
  return reasons;
}

sys::ExitCode compare(const ChangesOptions& options) {
  const Manifest before = read_manifest(options.before, options.project);
  const Manifest after = read_manifest(options.after, options.project);
  if (before.facts.contains("case")) {
    throw sys::InputError(
        fmt::format("'{}' is a record of results and no manifest", options.before));
  }
  const bool has_text = !options.document_before.empty();
  const auto sentences = sentences_below(options.document, flags_of(after));
  const auto former = has_text ? sentences_below(options.document_before, flags_of(before))
                               : std::vector<Sentence>();
  const std::vector<Change> changes =
      changes_between(before, after, former, sentences, read_names(options.names).numbers);

  // The results of a state that cannot be made are told by giving the present ones twice.
  const Compared compared{.before = options.label,
                          .after = "the sources as they are",
                          .reasons = reasons_beside_its_own_engine(before, after),
                          .has_words = has_text,
                          .has_results = options.before != options.after};
  const fs::path folder = options.output;
  sys::write_file_atomically(folder / "changes.csv", changes_csv(changes));
  sys::write_file_atomically(folder / "changes.html", changes_html(changes, compared));
  // Without the former text only results can be told.
  const auto edits = has_text ? edits_between(former, sentences) : std::vector<Edit>();
  sys::write_file_atomically(folder / "answer.md", answer_to_referees(changes, compared, edits));
  fmt::print("{}", changes_text(changes));
  if (changes.empty())
    fmt::print("no value, text, table, figure, listing, verdict or limit differs\n");
  if (!edits.empty()) {
    fmt::print("the author's words are others at {} {}: answer.md quotes them\n", edits.size(),
               edits.size() == 1 ? "place" : "places");
  }
  return sys::ExitCode::success;
}

}  // namespace

void add_changes_command(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(
      program, "changes", "Compare two states of a document by their manifests", exit_code,
      [](CLI::App& command) {
        auto options = std::make_shared<ChangesOptions>();
        command_line::hide(command);  // the build alone calls it
        add_required_text(command, "--project", options->project, "NAME", "The paper's project");
        add_required_text(command, "--before", options->before, "FILE", "The former manifest");
        add_required_text(command, "--after", options->after, "FILE", "The later manifest");
        add_required_text(command, "--names", options->names, "FILE", "Its names.json");
        add_required_text(command, "--document", options->document, "DIR",
                          "The LaTeX document of the later state");
        add_text(command, "--document-before", options->document_before, "DIR",
                 "That of the former state, if it is known");
        add_required_text(command, "--label", options->label, "TEXT",
                          "What the former state is called");
        add_required_text(command, "--output", options->output, "DIR",
                          "The folder for changes.csv, changes.html and answer.md");
        return [options] { return compare(*options); };
      });
}

}  // namespace literate
