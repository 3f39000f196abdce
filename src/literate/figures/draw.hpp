// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace literate {

/// The figures of a document by name, each with the place where the program registers it.
using FigurePlaces = std::map<std::string, std::string>;

/// Draws all figures of a document whose data, script or style, or whose gnuplot, are not those of
/// the drawing that is there.
///
/// `generated` is what Document::write made; `scripts` holds a script name.gp for each figure and
/// style.gp, which is read before each. Beside its data each drawn figure gets name.tex and
/// name.pdf, a copy of its script, files.tex (its files with their SHA-256, for the document) and
/// drawn.sha256 (what it was drawn from). So `gnuplot name.gp` draws it again there. Drawings of
/// figures that are no longer registered are removed.
///
/// Either all is drawn or nothing changes; if gnuplot refuses a figure, all that it read is kept
/// beside `generated`, in «generated.failed», and named. Throws sys::InputError for a script that
/// is missing or reads or writes what it must not, sys::ToolError for what gnuplot refuses (as
/// require_drawn_well; of several errors, that of the first figure by name), and sys::OutputError
/// for a folder that cannot be written. Returns how many figures were drawn.
std::size_t draw_figures(const std::filesystem::path& generated,
                         const std::filesystem::path& scripts, const FigurePlaces& figures);

/// All files that draw_figures makes for these figures, sorted, relative to `generated`.
std::vector<std::string> drawn_files(const FigurePlaces& figures);

/// Throws sys::OutputError naming the first figure whose drawing was not made from the data that
/// are there now.
void require_drawn(const std::filesystem::path& generated, const FigurePlaces& figures);

}  // namespace literate
