// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
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

/// A figure as a document shows it with \fig[width=…]{name}.
struct FigureAtWidth {
  std::string name;
  std::int64_t width = 0;  ///< in TeX's scaled points, of which 65536 make a point

  auto operator<=>(const FigureAtWidth&) const = default;
};

/// The folder of such a drawing, as the document reads it: «drawn/name-14916681».
std::string folder_of(const FigureAtWidth& figure);

/// Draws figures at the widths of a document, in the height that keeps their shape, with letters
/// and lines as large as in any other width. They are drawn from what draw_figures left in
/// `generated`, into folder_of() below `output`; those that are there and were made from the same
/// are left alone. `places` says where each is registered, and `label` what messages call the
/// folder of scripts. Throws as draw_figures does. Returns how many were drawn.
std::size_t draw_at_widths(const std::filesystem::path& generated,
                           const std::filesystem::path& output,
                           const std::set<FigureAtWidth>& figures, const FigurePlaces& places,
                           const std::string& label);

/// Removes from `output` the drawings of other figures and widths, and returns the files that
/// remain, sorted, relative to `output`.
std::vector<std::string> keep_at_widths(const std::filesystem::path& output,
                                        const std::set<FigureAtWidth>& figures);

}  // namespace literate
