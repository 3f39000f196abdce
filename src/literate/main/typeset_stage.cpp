// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "literate/document/names.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/figures/draw.hpp"
#include "literate/main/paper.hpp"
#include "literate/main/stage_record.hpp"
#include "literate/main/stages.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/prose/recorded_ages.hpp"
#include "literate/prose/references.hpp"
#include "literate/prose/restyle.hpp"
#include "literate/prose/statements.hpp"
#include "literate/provenance/manifest.hpp"
#include "literate/typesetting/typeset.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"
#include "system/process.hpp"

namespace literate {
namespace fs = std::filesystem;
using command_line::complain;
using command_line::ExitCode;
namespace {

// The digests of all files below `folder` of the checkout whose names end in one of these.
Manifest::Texts sources_below(const fs::path& source, const std::string& folder,
                              const std::vector<std::string>& endings) {
  if (!fs::is_directory(source / folder)) return {};
  std::vector<std::string> files = paper_sources(source / folder);
  std::erase_if(files, [&](const std::string& file) {
    return std::ranges::none_of(endings, [&](const auto& end) { return file.ends_with(end); });
  });
  return digests(source / folder, files, folder + "/");
}

// A file or folder from the root on, or by its name alone if it lies elsewhere: no folder of the
// machine is told.
std::string name_within(const fs::path& root, const fs::path& file) {
  return sys::name_below(root, file).value_or(file.filename().generic_string());
}

// The folder of the gnuplot scripts, from the root on.
std::string scripts_folder(const fs::path& root, const Settings& settings) {
  return fs::weakly_canonical(root / settings.figures).lexically_relative(root).generic_string();
}

// All that `compute` and `draw` wrote.
std::vector<std::string> made_files(const Names& names) {
  std::vector<std::string> files = names.files;
  std::ranges::move(drawn_files(names.figures), std::back_inserter(files));
  files.emplace_back(attached_list);
  return files;
}

// The digests of everything that the document is made from. A case from outside the checkout is
// listed by its name alone.
Manifest::Texts inputs_of(const Settings& settings, const Paper& paper, const Names& names) {
  const fs::path root = fs::weakly_canonical(settings.root);
  Manifest::Texts files;
  for (const std::string& folder : paper.source_folders) {
    files.merge(sources_below(root, folder, {".cpp", ".hpp", ".in", ".sty"}));
  }
  files.merge(sources_below(root, scripts_folder(root, settings), {".gp"}));
  files.merge(imported_files(settings.generated() / "names.json"));
  const fs::path document = fs::weakly_canonical(settings.document);
  const std::string folder = name_within(root, document);
  const std::string prefix = folder == "." ? "" : folder + "/";
  files.merge(digests(document, document_files(document), prefix));
  for (const auto& [file, digest] : sources_below(
           document, ".", {".bib", ".sty", "quotations.toml", "results.json", "severity.csv"})) {
    files[prefix + file.substr(2)] = digest;
  }
  files.merge(digests(document, images_of(document), prefix));
  for (const Excerpt& excerpt : find_excerpts(root, paper.source_folders)) {
    files[excerpt.file] = sys::sha256_of_file(root / excerpt.file);
  }
  for (const fs::path& read : settings.reads) {
    const fs::path file = fs::weakly_canonical(read);
    files[name_within(root, file)] = sys::sha256_of_file(file);
  }
  // A second reading could find another case than the computation did.
  files[name_within(root, fs::weakly_canonical(settings.case_file))] = names.case_sha256;
  // So could one of what was compiled, and of what scripts of data read and wrote.
  for (const fs::path& record : settings.records) {
    if (!fs::is_regular_file(record)) continue;
    const auto entries = sys::parse_record(sys::read_file(record));
    if (!entries) {
      sys::remove_file(record);
      throw sys::OutputError(
          fmt::format("'{}' was no list of digests and is removed; build again", record.string()));
    }
    for (const sys::RecordEntry& entry : *entries) {
      files[name_within(root, fs::weakly_canonical(entry.name))] = entry.digest;
    }
  }
  return files;
}

// The tools by their names in the manifest. One that runs scripts of data may not tell its version.
Manifest::Texts tools_of(const Settings& settings) {
  Manifest::Texts tools{
      {"gnuplot", sys::tool_version("gnuplot")},
      {settings.latex == "lualatex" ? "LuaTeX" : "pdfTeX", sys::tool_version(settings.latex)}};
  for (const std::string& tool : settings.tools) {
    try {
      const sys::ProcessResult said = sys::run({.program = tool, .arguments = {"--version"}});
      tools[fs::path(tool).filename()] = said.exit_status == 0
                                             ? said.output.substr(0, said.output.find('\n'))
                                             : "tells no version";
    } catch (const sys::ToolError&) {
      tools[fs::path(tool).filename()] = "not on this machine";
    }
  }
  return tools;
}

// All that the manifest tells but the PDF and what LaTeX asked to be drawn: none of it waits for
// LaTeX.
Manifest manifest_without_pdf(const Settings& settings, const Paper& paper,
                              const Repository& repository, const Names& names) {
  const fs::path generated = settings.generated();
  Manifest::Texts libraries = engine_libraries();
  libraries.insert(paper.libraries.begin(), paper.libraries.end());
  Manifest manifest = results_in(generated / "names.json", paper.project);
  manifest.facts = {{"sources",
                     {{"version", paper.version},
                      {"commit", repository.commit},
                      {"modified", repository.modified ? "yes" : "no"},
                      {"date", repository.date}}},
                    {"engine",
                     {{"engine version", engine_version()},
                      {"engine commit", repository.engine_commit},
                      {"engine modified", repository.engine_modified ? "yes" : "no"}}},
                    {"platform",
                     {{"compiler", paper.compiler},
                      {"build type", paper.build_type},
                      {"flags", paper.flags},
                      {"processor", processor()}}},
                    {"libraries", libraries},
                    {"tools", tools_of(settings)}};
  manifest.inputs = inputs_of(settings, paper, names);
  manifest.outputs = digests(generated, made_files(names), "generated/");
  const RecordedAges ages(settings.document, names);
  for (const auto& [id, claim] : names.claims) {
    for (std::size_t i = 0; i < claim.limits.size(); ++i) {
      const std::string& age = ages.of(id)[i];
      manifest.words[fmt::format("claim {}: {}: age of the limit", id, claim.limits[i].quantity)] =
          age.empty() ? "not known" : age;
    }
  }
  return manifest;
}

// Says how this report differs from the one that `file` tells of. The same bytes are not asked of
// other tools or sources; then each number must lie within its error.
ExitCode compare_with(const std::string& file, const Manifest& theirs, const Manifest& ours) {
  const ManifestComparison found = compare(theirs, ours);
  if (found.changed_outputs.empty()) {
    fmt::print("{} files have the bytes that '{}' tells of\n", ours.outputs.size(), file);
    if (found.has_same_results) return ExitCode::success;
    for (const std::string& moved : found.moved) complain("moved: " + moved, ExitCode::failed);
    return complain(fmt::format("'{}' tells other results than these files hold: it was changed "
                                "after it was written",
                                file),
                    ExitCode::failed);
  }
  fmt::print("{} of {} files have other bytes than '{}' tells of; the first is {}\n",
             found.changed_outputs.size(), ours.outputs.size(), file,
             found.changed_outputs.front());
  if (!found.reasons.empty()) fmt::print("They may, since these are not the same:\n");
  for (const std::string& reason : found.reasons) fmt::print("  {}\n", reason);
  for (const std::string& moved : found.moved) complain("moved: " + moved, ExitCode::failed);
  if (!found.moved.empty()) return ExitCode::failed;
  if (found.reasons.empty()) {
    return complain("tools and sources are the same, and so should the bytes be", ExitCode::failed);
  }
  fmt::print("{} numbers of text and tables are the same within their errors, and {} verdicts\n",
             ours.numbers.size(), ours.verdicts.size());
  const auto is_data = [](const std::string& output) {
    return output.starts_with("generated/figures/") && output.ends_with(".csv");
  };
  const auto n_data = std::ranges::count_if(
      ours.outputs, [&](const auto& output) { return is_data(output.first); });
  const auto n_others = std::ranges::count_if(found.changed_outputs, is_data);
  fmt::print("{} of {} files of data for figures have the same bytes\n", n_data - n_others, n_data);
  for (const std::string& output : found.changed_outputs) {
    if (is_data(output)) fmt::print("  not {}\n", output);
  }
  return ExitCode::success;
}

// `watch` builds as any other build does, and says by a variable that its author is still writing.
bool tolerates_overfull() {
  return std::getenv("LITERATE_WATCHES") != nullptr;
}

// The digests of what LaTeX reads from the document's own folder.
FileDigests prose_of(const Settings& settings) {
  const fs::path document = fs::weakly_canonical(settings.document);
  const std::string prefix = document.string() + "/";
  FileDigests files = digests(document, document_files(document), prefix);
  files.merge(digests(document, images_of(document), prefix));
  for (const std::string& file : paper_sources(document)) {
    const bool is_read =
        file.find('/') == file.npos &&
        (file.ends_with(".bib") || file.ends_with(".sty") || file.ends_with(".cls") ||
         file.ends_with(".bst") || file == "quotations.toml" || file == "results.json");
    if (is_read) files[prefix + file] = sys::sha256_of_file(document / file);
  }
  return files;
}

// What a later look holds the announced files against.
FileDigests files_announced(const Settings& settings, const TypesetOptions& latex,
                            FileDigests files) {
  for (const fs::path& file :
       {settings.pdf(), settings.manifest(), settings.digest(), in_build_dir(latex, ".pdf")}) {
    if (!file.empty()) files[fs::absolute(file).string()] = sys::sha256_of_file(file);
  }
  if (!settings.repository.empty()) {
    const fs::path file = fs::absolute(settings.repository) / "repository.json";
    files[file.string()] = sys::sha256_of_file(file);
  }
  return files;
}

void warn_of_unknown_commit(const Settings& settings, const Repository& repository) {
  if (settings.repository.empty() || repository.commit != "unknown") return;
  complain(
      fmt::format("warning: the commit of '{}' is unknown, since it is no git repository with a "
                  "commit; the document cannot tell which sources it was made from",
                  settings.root.string()),
      ExitCode::success);
}

// Typesets once. Returns nothing if the document was saved meanwhile, so that the PDF may be of
// neither text.
std::optional<ExitCode> typeset_once(const Settings& settings, const Paper& paper,
                                     const std::string& against, const Manifest& theirs) {
  Repository repository;
  if (!settings.repository.empty()) repository = read_repository(settings.repository);

  const command_line::Stage typesetting("typeset");
  StageRecord record(settings.record("typeset"));
  const fs::path generated = settings.generated();
  const Names names = read_names(generated / "names.json");
  require_drawn(generated, names.figures);
  require_as_made(generated, settings.digest(), made_files(names));
  const FileDigests prose = prose_of(settings);

  ReferenceReport references = check_references(settings.document, names);
  std::vector<std::string> made = made_files(names);
  made.insert(made.end(), {"statements.tex", "restyled.tex", "repository.tex"});
  std::ranges::move(misplaced_files(settings.document, made),
                    std::back_inserter(references.errors));
  std::ranges::move(missing_inputs(settings.document, generated),
                    std::back_inserter(references.errors));
  for (const std::string& error : references.errors) complain(error, ExitCode::bad_input);
  const Restyled restyled = restyled_values(settings.document, names);
  for (const std::string& error : restyled.errors) complain(error, ExitCode::bad_input);
  // What does not hold is told with what is wrong in the prose, and before LaTeX may fail.
  const ExitCode verdict = command_line::answer_faults(names.faults);
  if (!references.errors.empty() || !restyled.errors.empty()) return ExitCode::bad_input;
  for (const std::string& name : references.unused) {
    complain(fmt::format("warning: {} is registered and not used", name), ExitCode::success);
  }
  warn_of_unknown_commit(settings, repository);

  // LaTeX looks into its output folder before all others.
  write_statements(settings.document, names, settings.latex_folder() / "statements.tex");
  sys::write_if_changed(settings.latex_folder() / "restyled.tex", restyled.latex);
  const TypesetOptions latex{.source_dir = settings.document,
                             .main_file = settings.main_file,
                             .generated_dir = generated,
                             .repository_dir = settings.repository,
                             .build_dir = settings.latex_folder(),
                             .output_pdf = settings.pdf(),
                             .engine = settings.latex,
                             .figures = names.figures,
                             .scripts = settings.figures,
                             .tolerates_overfull = tolerates_overfull()};
  Typeset done;
  Manifest ours;
  sys::for_each_parallel(2, 2, [&](std::size_t i) {
    if (i == 0) done = typeset(latex);
    if (i == 1) ours = manifest_without_pdf(settings, paper, repository, names);
  });
  if (prose_of(settings) != prose) return std::nullopt;
  typesetting.done(settings.pdf().filename().string());
  for (const std::string& warning : done.warnings) {
    complain("warning: " + warning, ExitCode::success);
  }
  if (!done.warnings.empty()) {
    // Without a manifest the build is not done: the next one that tolerates nothing will tell.
    fs::remove(settings.manifest());
    return verdict;
  }

  const fs::path pdf = settings.pdf();
  ours.outputs[pdf.filename().string()] = sys::sha256_of_file(pdf);
  ours.outputs.merge(digests(at_width_dir(latex), done.drawn));
  sys::write_if_changed(settings.manifest(), manifest_json(ours));
  // A document that is not to be trusted is told of each time, so it is never done.
  if (verdict != ExitCode::success) return verdict;
  record.done(files_announced(settings, latex, prose));
  return against.empty() ? verdict : compare_with(against, theirs, ours);
}

ExitCode run(const Settings& settings, const Paper& paper, const std::string& against) {
  // Report a manifest that cannot be read before the work begins.
  Manifest theirs;
  if (!against.empty()) theirs = read_manifest(against, paper.project);
  constexpr int most_runs = 5;
  for (int n_runs = 0; n_runs < most_runs; ++n_runs) {
    if (const auto answer = typeset_once(settings, paper, against, theirs)) return *answer;
    complain(fmt::format("warning: '{}' was saved while it was typeset; it is typeset again",
                         settings.document.string()),
             ExitCode::success);
  }
  throw sys::InputError(fmt::format("'{}' was saved {} times while it was typeset",
                                    settings.document.string(), most_runs));
}

}  // namespace

void add_typeset_stage(CLI::App& program, ExitCode& exit_code, const Paper& paper) {
  const auto against = std::make_shared<std::string>();
  add_stage(
      program, exit_code, "typeset",
      "Typeset the document with LaTeX from what `compute` and `draw` wrote",
      [against, &paper](const Settings& settings) { return run(settings, paper, *against); },
      [against](CLI::App& command) {
        command_line::add_text(command, "--against", *against, "FILE",
                               "Compare with the manifest of the same document made elsewhere");
      });
}

}  // namespace literate
