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
#include "literate/excerpts/find_excerpts.hpp"
#include "literate/excerpts/paper_sources.hpp"
#include "literate/figures/draw.hpp"
#include "literate/main/platform.hpp"
#include "literate/main/stage_record.hpp"
#include "literate/main/stages.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/prose/figure_widths.hpp"
#include "literate/prose/images.hpp"
#include "literate/prose/references.hpp"
#include "literate/prose/restyle.hpp"
#include "literate/prose/statements.hpp"
#include "literate/provenance/digest.hpp"
#include "literate/provenance/manifest.hpp"
#include "literate/provenance/manifest_comparison.hpp"
#include "literate/provenance/repository.hpp"
#include "literate/typesetting/latex_run.hpp"
#include "literate/typesetting/typeset.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"
#include "system/tool_version.hpp"

namespace literate {
namespace fs = std::filesystem;
using command_line::complain;
using command_line::ExitCode;
namespace {

struct TypesetStageOptions {
  std::string document, main_file, generated, build, output;
  std::string engine = "pdflatex";
  std::string figures = "figures";
  bool tolerates_overfull = false;
  std::string digest, manifest, case_file, source = ".", repository, against, record;
};

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
  const fs::path relative = file.lexically_relative(root);
  const bool is_inside = !relative.empty() && *relative.begin() != "..";
  return (is_inside ? relative : file.filename()).generic_string();
}

// The folder of the gnuplot scripts, from the root on.
std::string scripts_folder(const fs::path& root, const TypesetStageOptions& options) {
  return fs::weakly_canonical(root / options.figures).lexically_relative(root).generic_string();
}

// All that `compute` and `draw` wrote.
std::vector<std::string> made_files(const Names& names) {
  std::vector<std::string> files = names.files;
  std::ranges::move(drawn_files(names.figure_places), std::back_inserter(files));
  return files;
}

// The digests of everything that the document is made from. A case from outside the checkout is
// listed by its name alone.
Manifest::Texts inputs_of(const TypesetStageOptions& options, const Paper& paper,
                          const Names& names) {
  const fs::path root = fs::weakly_canonical(options.source);
  Manifest::Texts files;
  for (const std::string& folder : paper.source_folders) {
    files.merge(sources_below(root, folder, {".cpp", ".hpp", ".in", ".sty"}));
  }
  files.merge(sources_below(root, scripts_folder(root, options), {".gp"}));
  files.merge(imported_files(fs::path(options.generated) / "names.json"));
  const fs::path document = fs::weakly_canonical(options.document);
  const std::string folder = name_within(root, document);
  const std::string prefix = folder == "." ? "" : folder + "/";
  files.merge(digests(document, document_files(document), prefix));
  for (const auto& [file, digest] :
       sources_below(document, ".", {".bib", ".sty", "quotations.toml"})) {
    files[prefix + file.substr(2)] = digest;
  }
  files.merge(digests(document, images_of(document).files, prefix));
  for (const Excerpt& excerpt : find_excerpts(root, paper.source_folders)) {
    files[excerpt.file] = sys::sha256_of_file(root / excerpt.file);
  }
  if (!options.case_file.empty()) {
    const fs::path file = fs::weakly_canonical(options.case_file);
    // A second reading could find another case than the computation did.
    files[name_within(root, file)] =
        names.case_sha256.empty() ? sys::sha256_of_file(file) : names.case_sha256;
  }
  return files;
}

// All that the manifest tells but the PDF and what LaTeX asked to be drawn: none of it waits for
// LaTeX.
Manifest manifest_without_pdf(const TypesetStageOptions& options, const Paper& paper,
                              const Repository& repository, const Names& names) {
  const fs::path generated = options.generated;
  Manifest::Texts libraries = engine_libraries();
  libraries.insert(paper.libraries.begin(), paper.libraries.end());
  return {.project = paper.project,
          .facts = {{"sources",
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
                    {"tools",
                     {{"gnuplot", sys::tool_version("gnuplot")},
                      {options.engine == "lualatex" ? "LuaTeX" : "pdfTeX",
                       sys::tool_version(options.engine)}}}},
          .inputs = inputs_of(options, paper, names),
          .outputs = digests(generated, made_files(names), "generated/"),
          .numbers = numbers_in(generated / "names.json"),
          .verdicts = verdicts_in(generated / "names.json")};
}

// Says how this report differs from the one that `file` tells of. The same bytes are not asked of
// other tools or sources; then each number must lie within its error.
ExitCode compare_with(const std::string& file, const Manifest& theirs, const Manifest& ours) {
  const ManifestComparison found = compare(theirs, ours);
  if (found.changed_outputs.empty()) {
    fmt::print("{} files have the bytes that '{}' tells of\n", ours.outputs.size(), file);
    return ExitCode::success;
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
bool tolerates_overfull(const TypesetStageOptions& options) {
  return options.tolerates_overfull || std::getenv("LITERATE_TOLERATES_OVERFULL") != nullptr;
}

// The digests of what LaTeX reads from the document's own folder.
FileDigests prose_of(const TypesetStageOptions& options) {
  const fs::path document = fs::weakly_canonical(options.document);
  const std::string prefix = document.string() + "/";
  FileDigests files = digests(document, document_files(document), prefix);
  files.merge(digests(document, images_of(document).files, prefix));
  for (const std::string& file : paper_sources(document)) {
    const bool is_read =
        file.find('/') == file.npos &&
        (file.ends_with(".bib") || file.ends_with(".sty") || file.ends_with(".cls") ||
         file.ends_with(".bst") || file == "quotations.toml");
    if (is_read) files[prefix + file] = sys::sha256_of_file(document / file);
  }
  return files;
}

// What a later look holds the announced files against.
FileDigests files_announced(const TypesetStageOptions& options, const TypesetOptions& latex,
                            FileDigests files) {
  for (const fs::path& file : {fs::path(options.output), fs::path(options.manifest),
                               fs::path(options.digest), in_build_dir(latex, ".pdf")}) {
    if (!file.empty()) files[fs::absolute(file).string()] = sys::sha256_of_file(file);
  }
  if (!options.repository.empty()) {
    const fs::path file = fs::absolute(options.repository) / "repository.json";
    files[file.string()] = sys::sha256_of_file(file);
  }
  return files;
}

void warn_of_unknown_commit(const TypesetStageOptions& options, const Repository& repository) {
  if (options.repository.empty() || repository.commit != "unknown") return;
  complain(
      fmt::format("warning: the commit of '{}' is unknown, since it is no git repository with a "
                  "commit; the document cannot tell which sources it was made from",
                  options.source),
      ExitCode::success);
}

// Typesets once. Returns nothing if the document was saved meanwhile, so that the PDF may be of
// neither text.
std::optional<ExitCode> typeset_once(const TypesetStageOptions& options, const Paper& paper,
                                     const Manifest& theirs) {
  Repository repository;
  if (!options.repository.empty()) repository = read_repository(options.repository);

  const command_line::Stage typesetting("typeset");
  StageRecord record(options.record);
  const fs::path generated = options.generated;
  const Names names = read_names(generated / "names.json");
  if (!options.digest.empty()) {
    require_as_made(generated, options.digest, made_files(names));
  }
  const FileDigests prose = prose_of(options);

  ReferenceReport references = check_references(options.document, names);
  std::ranges::move(images_of(options.document).errors, std::back_inserter(references.errors));
  std::ranges::move(figure_width_errors(options.document), std::back_inserter(references.errors));
  for (const std::string& error : references.errors) complain(error, ExitCode::bad_input);
  const Restyled restyled = restyled_values(options.document, names);
  for (const std::string& error : restyled.errors) complain(error, ExitCode::bad_input);
  if (!references.errors.empty() || !restyled.errors.empty()) return ExitCode::bad_input;
  require_drawn(generated, names.figure_places);
  for (const std::string& name : references.unused) {
    complain(fmt::format("warning: {} is registered and not used", name), ExitCode::success);
  }
  warn_of_unknown_commit(options, repository);

  // LaTeX looks into its output folder before all others.
  write_statements(options.document, names, fs::path(options.build) / "statements.tex");
  sys::write_if_changed(fs::path(options.build) / "restyled.tex", restyled.latex);
  const TypesetOptions latex{.source_dir = options.document,
                             .main_file = options.main_file,
                             .generated_dir = options.generated,
                             .repository_dir = options.repository,
                             .build_dir = options.build,
                             .output_pdf = options.output,
                             .engine = options.engine,
                             .figures = names.figure_places,
                             .scripts_label = fs::path(options.figures).filename().string(),
                             .tolerates_overfull = tolerates_overfull(options)};
  const bool is_recorded = !options.manifest.empty() || !options.against.empty();
  Typeset done;
  Manifest ours;
  sys::for_each_parallel(is_recorded ? 2 : 1, 2, [&](std::size_t i) {
    if (i == 0) done = typeset(latex);
    if (i == 1) ours = manifest_without_pdf(options, paper, repository, names);
  });
  if (prose_of(options) != prose) return std::nullopt;
  typesetting.done(fs::path(options.output).filename().string());
  for (const std::string& warning : done.warnings) {
    complain("warning: " + warning, ExitCode::success);
  }
  const ExitCode verdict = command_line::answer_faults(names.faults);
  if (!is_recorded) return verdict;

  if (!done.warnings.empty() && !options.manifest.empty()) {
    // Without a manifest the build is not done: the next one that tolerates nothing will tell.
    fs::remove(options.manifest);
    return verdict;
  }

  const fs::path pdf = options.output;
  ours.outputs[pdf.filename().string()] = sys::sha256_of_file(pdf);
  ours.outputs.merge(digests(at_width_dir(latex), done.drawn));
  if (!options.manifest.empty()) {
    sys::write_if_changed(options.manifest, manifest_json(ours));
  }
  // A document that is not to be trusted is told of each time, so it is never done.
  if (verdict != ExitCode::success) return verdict;
  record.done(files_announced(options, latex, prose));
  if (options.against.empty()) return verdict;
  return compare_with(options.against, theirs, ours);
}

ExitCode run(const TypesetStageOptions& options, const Paper& paper) {
  // Report a manifest that cannot be read before the work begins.
  Manifest theirs;
  if (!options.against.empty()) theirs = read_manifest(options.against, paper.project);
  constexpr int most_runs = 5;
  for (int n_runs = 0; n_runs < most_runs; ++n_runs) {
    if (const auto answer = typeset_once(options, paper, theirs)) return *answer;
    complain(fmt::format("warning: '{}' was saved while it was typeset; it is typeset again",
                         options.document),
             ExitCode::success);
  }
  throw sys::InputError(
      fmt::format("'{}' was saved {} times while it was typeset", options.document, most_runs));
}

}  // namespace

void add_typeset_stage(CLI::App& program, ExitCode& exit_code, const Paper& paper) {
  using namespace command_line;
  add_command(
      program, "typeset", "Typeset the document with LaTeX from what `compute` and `draw` wrote",
      exit_code, [&paper](CLI::App& command) {
        auto options = std::make_shared<TypesetStageOptions>();
        options->main_file = paper.main_file;
        add_required_text(command, "--document", options->document, "DIR",
                          "Folder of the LaTeX document");
        add_text(command, "--main", options->main_file, "FILE", "Its main file");
        add_required_text(command, "--generated", options->generated, "DIR",
                          "Folder that `compute` wrote");
        add_required_text(command, "--build", options->build, "DIR",
                          "Folder for LaTeX's own files");
        add_required_text(command, "--output", options->output, "FILE", "The PDF");
        add_text(command, "--figures", options->figures, "DIR",
                 "Folder of the gnuplot scripts, for messages and the manifest");
        add_choice(command, "--engine", options->engine, {"pdflatex", "lualatex"},
                   "The LaTeX that typesets it");
        add_switch(command, "--tolerate-overfull", options->tolerates_overfull,
                   "Overfull boxes are warnings, as under `watch`");
        add_text(command, "--digest", options->digest, "FILE",
                 "SHA-256 of the generated files; refuse those that were changed since");
        add_text(command, "--manifest", options->manifest, "FILE",
                 "Write what the document was made from and with, as JSON");
        add_text(command, "--case", options->case_file, "FILE", "Case file, for the manifest");
        add_text(command, "--source", options->source, "DIR", "The checkout, for the manifest");
        add_text(command, "--repository", options->repository, "DIR",
                 "Folder with the state of the repository, for the manifest and \\papercommit");
        add_text(command, "--against", options->against, "FILE",
                 "Compare with the manifest of the same document made elsewhere");
        add_text(command, "--record", options->record, "FILE",
                 "Write what was read and made, with its SHA-256, when all is done");
        return [options, &paper] { return run(*options, paper); };
      });
}

}  // namespace literate
