// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stages.hpp"

#include <memory>

#include "command_line/options.hpp"

namespace literate {

void add_stage(CLI::App& program, sys::ExitCode& exit_code, const std::string& name,
               const std::string& description,
               const std::function<sys::ExitCode(const Settings&)>& run,
               const std::function<void(CLI::App& command)>& add_flags) {
  command_line::add_command(program, name, description, exit_code, [&](CLI::App& command) {
    auto file = std::make_shared<std::string>();
    command_line::add_required_text(command, "SETTINGS", *file, "FILE",
                                    "What the build wrote of the paper: NAME.settings");
    if (add_flags) add_flags(command);
    return [file, run] { return run(read_settings(*file)); };
  });
}

void add_stages(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper,
                const Compute& compute) {
  add_compute_stage(program, exit_code, paper, compute);
  add_draw_stage(program, exit_code);
  add_typeset_stage(program, exit_code, paper);
  add_check_stage(program, exit_code);
  add_page_stages(program, exit_code);
  add_describe_stage(program, exit_code, paper);
}

}  // namespace literate
