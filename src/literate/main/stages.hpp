// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "literate/main/main.hpp"
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

/// Computes. On a terminal a line tells every ten seconds for how long, and what was registered
/// last.
///
/// An exception that says nothing of where it comes from becomes a sys::ComputationError with its
/// type and what was registered last. A signal that ends the program, as after a wrong pointer, is
/// told with the same. If LITERATE_TIMEOUT, a number of seconds, is set and they are over, the
/// program ends with 1 and a line: no computation can be ended from outside in another way.
void compute_guarded(Document& document, const Inputs& inputs, const Compute& compute);

void add_compute_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper,
                       const Compute& compute);
void add_draw_stage(CLI::App& program, sys::ExitCode& exit_code);
void add_typeset_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper);
void add_check_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper);
void add_page_stages(CLI::App& program, sys::ExitCode& exit_code);
void add_describe_stage(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper);

}  // namespace literate
