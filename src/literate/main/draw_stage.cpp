// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "literate/document/names.hpp"
#include "literate/figures/draw.hpp"
#include "literate/main/stage_record.hpp"
#include "literate/main/stages.hpp"
#include "literate/provenance/digest.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

struct DrawOptions {
  std::string generated;
  std::string scripts;
  std::string digest;
  std::string record;
};

// The scripts that were run, as their copies beside the drawings have them, and the list of
// digests.
FileDigests files_of(const DrawOptions& options, const Names& names) {
  FileDigests files;
  const std::filesystem::path figures = std::filesystem::path(options.generated) / "figures";
  const std::filesystem::path folder = std::filesystem::absolute(options.scripts);
  for (const std::string& name : names.figures) {
    files[(folder / (name + ".gp")).string()] = sys::sha256_of_file(figures / name / "script.gp");
  }
  if (!names.figures.empty()) {
    files[(folder / "style.gp").string()] = sys::sha256_of_file(figures / "style.gp");
  }
  if (!options.digest.empty()) {
    files[std::filesystem::absolute(options.digest).string()] = sys::sha256_of_file(options.digest);
  }
  return files;
}

sys::ExitCode run(const DrawOptions& options) {
  const command_line::Stage drawing("draw");
  const std::filesystem::path generated = options.generated;
  StageRecord record(options.record);
  const Names names = read_names(generated / "names.json");
  const std::size_t n_drawn = draw_figures(generated, options.scripts, names.figure_places);
  if (!options.digest.empty()) sys::write_if_changed(options.digest, digest_of(generated));
  record.done(files_of(options, names));
  drawing.done(fmt::format("{} of {} figures", n_drawn, names.figures.size()));
  return sys::ExitCode::success;
}

}  // namespace

void add_draw_stage(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(program, "draw",
              "Draw by gnuplot the figures whose script or data changed since they were drawn",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<DrawOptions>();
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `compute` wrote, to draw in");
                add_required_text(command, "--scripts", options->scripts, "DIR",
                                  "Folder of the gnuplot scripts, one a figure, and style.gp");
                add_text(command, "--digest", options->digest, "FILE",
                         "Write the SHA-256 of all generated files, unless it is there already");
                add_text(command, "--record", options->record, "FILE",
                         "Write the SHA-256 of the scripts when all is drawn");
                return [options] { return run(*options); };
              });
}

}  // namespace literate
