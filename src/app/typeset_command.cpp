// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "literate/document/names.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/prose/references.hpp"
#include "literate/provenance/digest.hpp"
#include "literate/provenance/manifest.hpp"
#include "literate/provenance/manifest_comparison.hpp"
#include "literate/typesetting/typeset.hpp"
#include "system/files.hpp"
#include "system/tool_version.hpp"
#include "toolchain/build_info.hpp"
#include "toolchain/libraries.hpp"

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr const char* project = "halfspace";

struct TypesetCommandOptions {
  std::string document, main_file = "report.tex", generated, build, output;
  std::string digest, manifest, case_file, source = ".", against;
};

// The digests of all files below `folder` of the checkout whose names end in one of these.
literate::Manifest::Texts sources_below(const fs::path& source, const std::string& folder,
                                        const std::vector<std::string>& endings) {
  if (!fs::is_directory(source / folder)) return {};
  std::vector<std::string> files = sys::files_below(source / folder);
  std::erase_if(files, [&](const std::string& file) {
    return std::ranges::none_of(endings, [&](const auto& end) { return file.ends_with(end); });
  });
  return literate::digests(source / folder, files, folder + "/");
}

// The digests of everything that the report is made from. A case from outside the checkout is
// listed by its name alone.
literate::Manifest::Texts inputs(const TypesetCommandOptions& options) {
  const fs::path root = fs::weakly_canonical(options.source);
  literate::Manifest::Texts files = sources_below(root, "src", {".cpp", ".hpp", ".in", ".sty"});
  files.merge(sources_below(root, "figures", {".cpp", ".hpp"}));
  const fs::path document = fs::weakly_canonical(options.document);
  const std::string folder = document.filename().string();
  files.merge(literate::digests(document, literate::document_files(document), folder + "/"));
  files.merge(sources_below(document.parent_path(), folder, {".bib", ".sty"}));
  if (!options.case_file.empty()) {
    const fs::path file = fs::weakly_canonical(options.case_file);
    const fs::path relative = file.lexically_relative(root);
    const bool is_inside = !relative.empty() && *relative.begin() != "..";
    files[(is_inside ? relative : file.filename()).generic_string()] = sys::sha256_of_file(file);
  }
  return files;
}

literate::Manifest manifest_of(const TypesetCommandOptions& options, const literate::Names& names) {
  const fs::path generated = options.generated;
  const fs::path pdf = options.output;
  literate::Manifest manifest{.project = project,
                              .facts = {{"sources",
                                         {{"version", toolchain::version},
                                          {"commit", toolchain::commit},
                                          {"modified", toolchain::modified ? "yes" : "no"},
                                          {"date", toolchain::date}}},
                                        {"platform",
                                         {{"compiler", toolchain::compiler},
                                          {"build type", toolchain::build_type},
                                          {"flags", toolchain::flags},
                                          {"processor", toolchain::processor()}}},
                                        {"libraries", toolchain::libraries()},
                                        {"tools",
                                         {{"gnuplot", sys::tool_version("gnuplot")},
                                          {"pdfTeX", sys::tool_version("pdflatex")}}}},
                              .inputs = inputs(options),
                              .outputs = literate::digests(generated, names.files, "generated/"),
                              .numbers = literate::numbers_in(generated / "names.json")};
  manifest.outputs[pdf.filename().string()] = sys::sha256_of_file(pdf);
  return manifest;
}

// Prints how this report differs from the one whose manifest is `file`. If tools or sources differ,
// the bytes may too, but each number must lie within its error.
ExitCode compare_with(const std::string& file, const literate::Manifest& theirs,
                      const literate::Manifest& ours) {
  const literate::ManifestComparison found = literate::compare(theirs, ours);
  if (found.changed_outputs.empty()) {
    fmt::print("{} files have the bytes that '{}' tells of\n", ours.outputs.size(), file);
    return ExitCode::success;
  }
  fmt::print("{} of {} files have other bytes than '{}' tells of; the first is {}\n",
             found.changed_outputs.size(), ours.outputs.size(), file,
             found.changed_outputs.front());
  for (const std::string& reason : found.reasons) fmt::print("  {}\n", reason);
  for (const std::string& moved : found.moved) fmt::print(stderr, "halfspace: moved: {}\n", moved);
  if (!found.moved.empty()) return ExitCode::failed;
  if (found.reasons.empty()) {
    fmt::print(stderr, "halfspace: tools and sources are the same, and so should the bytes be\n");
    return ExitCode::failed;
  }
  fmt::print("{} numbers are the same within their errors\n", ours.numbers.size());
  return ExitCode::success;
}

ExitCode run(const TypesetCommandOptions& options) {
  // Report a manifest that cannot be read before the work begins.
  literate::Manifest theirs;
  if (!options.against.empty()) theirs = literate::read_manifest(options.against, project);

  const Stage typesetting("typeset");
  const fs::path generated = options.generated;
  const literate::Names names = literate::read_names(generated / "names.json");
  if (!options.digest.empty()) {
    literate::require_as_made(generated, options.digest, names.files);
  }
  const literate::ReferenceReport references = literate::check_references(options.document, names);
  for (const std::string& error : references.errors) fmt::print(stderr, "halfspace: {}\n", error);
  if (!references.errors.empty()) return ExitCode::bad_input;
  for (const std::string& name : references.unused) {
    fmt::print(stderr, "halfspace: warning: {} is registered and not used\n", name);
  }

  literate::typeset({.source_dir = options.document,
                     .main_file = options.main_file,
                     .generated_dir = options.generated,
                     .build_dir = options.build,
                     .output_pdf = options.output});
  typesetting.done(fs::path(options.output).filename().string());
  const ExitCode verdict = answer_faults(names.faults);
  if (options.manifest.empty() && options.against.empty()) return verdict;

  const literate::Manifest ours = manifest_of(options, names);
  if (!options.manifest.empty()) {
    sys::write_if_changed(options.manifest, literate::manifest_json(ours));
  }
  if (verdict != ExitCode::success || options.against.empty()) return verdict;
  return compare_with(options.against, theirs, ours);
}

}  // namespace

void add_typeset_command(CLI::App& program, ExitCode& exit_code) {
  add_command(
      program, "typeset", "Typeset the report with LaTeX from what `report` wrote", exit_code,
      [](CLI::App& command) {
        auto options = std::make_shared<TypesetCommandOptions>();
        add_required_text(command, "--document", options->document, "DIR",
                          "Folder of the LaTeX document");
        add_text(command, "--main", options->main_file, "FILE", "Its main file");
        add_required_text(command, "--generated", options->generated, "DIR",
                          "Folder that `report` wrote");
        add_required_text(command, "--build", options->build, "DIR",
                          "Folder for LaTeX's own files");
        add_required_text(command, "--output", options->output, "FILE", "The PDF");
        add_text(command, "--digest", options->digest, "FILE",
                 "SHA-256 of the generated files; refuse those that were changed since");
        add_text(command, "--manifest", options->manifest, "FILE",
                 "Write what the report was made from and with, as JSON");
        add_text(command, "--case", options->case_file, "FILE", "Case file, for the manifest");
        add_text(command, "--source", options->source, "DIR", "The checkout, for the manifest");
        add_text(command, "--against", options->against, "FILE",
                 "Compare with the manifest of the same report made elsewhere");
        return [options] { return run(*options); };
      });
}

}  // namespace app
