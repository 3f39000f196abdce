// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "system/process.hpp"

namespace literate {

/// Runs `gnuplot name.gp` inside the folder, after `settings` if there are any, with gnuplot's own
/// defaults instead of a user's, and sets the creation date in name.pdf to a fixed day: the same
/// script gives the same bytes on any day, for any user. What gnuplot says and its exit status are
/// the caller's to judge. Throws sys::ToolError if there is no gnuplot.
sys::ProcessResult run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                               const std::string& settings = {});

/// The files that the program wrote for a figure into its folder: its variables and its data.
std::vector<std::string> computed_files(const std::filesystem::path& folder,
                                        const std::string& name);

/// Copies them to a folder, which is made.
void copy_computed(const std::filesystem::path& folder, const std::string& name,
                   const std::filesystem::path& copy);

/// One figure whose script gnuplot runs, and what messages call its parts.
struct ScriptRun {
  std::string name;
  std::filesystem::path folder;  ///< where name.gp loads ../style.gp and script.gp
  std::string label;             ///< of the folder of scripts, such as «figures»
  std::string place;             ///< where the program registers the figure, «file:line»
};

/// Throws sys::InputError naming file and line of a command by which a script would write a file of
/// its own, change the terminal, load another script or start a program: a drawing would then
/// depend on more than its data and be more than its two files. `file` is what messages call it.
void require_draws_only(std::string_view script, const std::string& file);

/// Throws unless gnuplot, run on a figure, drew it and said nothing against it, warnings included:
///
/// - sys::InputError «figures/name.gp:line: …» for a name or a column that the program did not
///   register, for a file that is not there, and for files that the script wrote besides;
/// - sys::ToolError, in the same form, for all else that gnuplot refuses, and for a drawing that is
///   missing or empty.
///
/// Both name the place where the figure is registered. For a command that goes over several lines
/// gnuplot tells the last of them.
void require_drawn_well(const ScriptRun& run, const sys::ProcessResult& result);

}  // namespace literate
