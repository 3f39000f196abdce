// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "literate/main/computation.hpp"
#include "literate/main/paper.hpp"
#include "literate/main/settings.hpp"
#include "system/error.hpp"

namespace CLI {
class App;
}

namespace literate {

/// What `draw` writes beside the results: the SHA-256 of all that may be attached to the PDF.
constexpr const char* attached_list = "attached.sha256";

/// Adds the stages of a paper to a program as its subcommands, beside others that it may have.
void add_stages(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper,
                const Compute& compute);

/// Adds one, whose only argument is the file of settings; `add_flags` may add what differs from one
/// call to the next.
void add_stage(CLI::App& program, sys::ExitCode& exit_code, const std::string& name,
               const std::string& description,
               const std::function<sys::ExitCode(const Settings&)>& run,
               const std::function<void(CLI::App& command)>& add_flags = {});

void add_compute_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper,
                       const Compute& compute);
void add_draw_stage(CLI::App& program, sys::ExitCode& exit_code);
void add_typeset_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper);
void add_check_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper);
void add_page_stages(CLI::App& program, sys::ExitCode& exit_code);
void add_describe_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper);

}  // namespace literate
