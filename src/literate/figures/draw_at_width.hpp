// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "literate/figures/draw.hpp"

namespace literate {

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
