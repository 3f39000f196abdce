// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "literate/document/names.hpp"
#include "literate/figures/draw.hpp"
#include "literate/main/stages.hpp"

namespace literate {
namespace {

struct DrawOptions {
  std::string generated;
  std::string scripts;
};

sys::ExitCode run(const DrawOptions& options) {
  const command_line::Stage drawing("draw");
  const std::filesystem::path generated = options.generated;
  const Names names = read_names(generated / "names.json");
  const std::size_t n_drawn = draw_figures(generated, options.scripts, names.figure_places);
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
                return [options] { return run(*options); };
              });
}

}  // namespace literate
