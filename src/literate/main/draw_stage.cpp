// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <string>

#include "command_line/stage.hpp"
#include "literate/document/names.hpp"
#include "literate/figures/draw.hpp"
#include "literate/main/stage_record.hpp"
#include "literate/main/stages.hpp"
#include "literate/provenance/digest.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

// The scripts that were run, as their copies beside the drawings have them, and the list of
// digests.
FileDigests files_of(const Settings& settings, const Names& names) {
  FileDigests files;
  const std::filesystem::path figures = settings.generated() / "figures";
  const std::filesystem::path folder = std::filesystem::absolute(settings.figures);
  for (const std::string& name : names.figures) {
    files[(folder / (name + ".gp")).string()] = sys::sha256_of_file(figures / name / "script.gp");
  }
  if (!names.figures.empty()) {
    files[(folder / "style.gp").string()] = sys::sha256_of_file(figures / "style.gp");
  }
  files[std::filesystem::absolute(settings.digest()).string()] =
      sys::sha256_of_file(settings.digest());
  return files;
}

sys::ExitCode draw_changed(const Settings& settings) {
  const command_line::Stage drawing("draw");
  const std::filesystem::path generated = settings.generated();
  StageRecord record(settings.record("draw"));
  const Names names = read_names(generated / "names.json");
  const std::size_t n_drawn = draw_figures(generated, settings.figures, names.figure_places);
  sys::write_if_changed(settings.digest(), digest_of(generated));
  record.done(files_of(settings, names));
  drawing.done(fmt::format("{} of {} figures", n_drawn, names.figures.size()));
  return sys::ExitCode::success;
}

}  // namespace

void add_draw_stage(CLI::App& program, sys::ExitCode& exit_code) {
  add_stage(program, exit_code, "draw",
            "Draw by gnuplot the figures whose script or data changed since they were drawn",
            draw_changed);
}

}  // namespace literate
