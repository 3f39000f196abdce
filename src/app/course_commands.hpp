// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exit_codes.hpp"

namespace CLI {
class App;
}

namespace app {

/// Each adds some of the subcommands of `halfspace course`.
void add_course_release_commands(CLI::App& course, ExitCode& exit_code);
void add_course_grading_commands(CLI::App& course, ExitCode& exit_code);
void add_course_sheet_command(CLI::App& course, ExitCode& exit_code);

}  // namespace app
