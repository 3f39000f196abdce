// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/stage.hpp"
#include "literate/document/names.hpp"
#include "literate/figures/draw.hpp"

namespace app {
namespace {

struct DrawOptions {
  std::string generated;
  std::string scripts;
};

ExitCode run(const DrawOptions& options) {
  const Stage drawing("draw");
  const std::filesystem::path generated = options.generated;
  const literate::Names names = literate::read_names(generated / "names.json");
  const std::size_t n_drawn =
      literate::draw_figures(generated, options.scripts, names.figure_places);
  drawing.done(fmt::format("{} of {} figures", n_drawn, names.figures.size()));
  return ExitCode::success;
}

}  // namespace

void add_draw_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "draw",
              "Draw by gnuplot the figures whose script or data changed since they were drawn",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<DrawOptions>();
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `report` wrote, to draw in");
                add_required_text(command, "--scripts", options->scripts, "DIR",
                                  "Folder of the gnuplot scripts, one a figure, and style.gp");
                return [options] { return run(*options); };
              });
}

}  // namespace app
