// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands can compute and the report cannot say.
#include <fmt/core.h>

#include <sstream>

#include "literate/text/latex.hpp"
#include "paper/paper.hpp"
#include "paper/prelude.hpp"
#include "system/text.hpp"

namespace paper {
namespace {

// Claims about stresses hold the elements against a search for the largest shear: fewer nodes have
// no such place beneath them, and of more the errors are below what the search can tell.
constexpr long fewest_nodes = 7;
constexpr long most_nodes = 401;

// The report solves a dozen blocks; of a lower order their displacements have not converged to what
// it reads from them.
constexpr int fewest_order = 6;
constexpr int most_order = 10;
constexpr int most_refine = 3;

// Half-widths of the load that the drawing of the loaded region shows to either side and downwards.
constexpr double shown_half_widths = 4;

// Nearer to 1/2 the stiffness of the block is too ill-conditioned.
constexpr double most_poisson = 0.4999;

// What fits a line of the report: its first table has the title and the case's file.
constexpr std::size_t longest_title = 200;
constexpr std::size_t longest_word = 40;
constexpr std::size_t longest_file_name = 60;

void require_title(const config::Table& table, const std::string& title) {
  const std::string_view unprintable = literate::first_unprintable(title);
  if (!unprintable.empty()) {
    table.fail("title", fmt::format("holds '{}', which LaTeX cannot print: must be letters of "
                                    "European languages, digits and common signs",
                                    unprintable));
  }
  const std::size_t length = sys::n_characters(title);
  if (length > longest_title) {
    table.fail("title", fmt::format("{} characters: must be at most {}", length, longest_title));
  }
  std::istringstream words(title);
  for (std::string word; words >> word;) {
    const std::size_t length_of_word = sys::n_characters(word);
    if (length_of_word > longest_word) {
      table.fail("title", fmt::format("a word of {} characters: must be at most {}, so that LaTeX "
                                      "can break the line",
                                      length_of_word, longest_word));
    }
  }
}

void require_file_name(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const auto refuse = [&](const std::string& reason) {
    throw config::Error(fmt::format("{}: the report prints the name of the case's file, {}",
                                    file.string(), reason));
  };
  const std::string_view unprintable = literate::first_unprintable(name);
  if (!unprintable.empty()) {
    refuse(fmt::format("and LaTeX cannot print the '{}' in it", unprintable));
  }
  if (sys::n_characters(name) > longest_file_name) {
    refuse(fmt::format("which has {} characters: must be at most {}", sys::n_characters(name),
                       longest_file_name));
  }
}

void require_integer(const config::Table& table, const char* key, long value, long fewest,
                     long most) {
  if (value >= fewest && value <= most) return;
  table.fail(key, fmt::format("{}: must be from {} to {} for the report", value, fewest, most));
}

void require_block(const config::Table& root, const parameters::Case& c, const BlockCase& block) {
  const config::Table table = root.table("block");
  require_integer(table, "order", block.discretization.order, fewest_order, most_order);
  require_integer(table, "refine", block.discretization.refine, 0, most_refine);
  const double shown = shown_half_widths * c.half_space.load.half_width();
  const auto require_size = [&](const char* key, double size, double times) {
    if (size >= times * shown) return;
    table.fail(key, fmt::format("{0} {1}: must be at least {2:.6g} {1}, {3} times "
                                "half_space.load.half_width, for the report",
                                size, c.units.length, times * shown, times * shown_half_widths));
  };
  require_size("width", block.rectangle.width(), 2);
  require_size("height", block.rectangle.height(), 1);
  const double poisson = c.half_space.material.poisson();
  if (poisson > most_poisson) {
    root.table("half_space")
        .table("material")
        .fail("poisson", fmt::format("{}: must be at most {} in a case with a [block]", poisson,
                                     most_poisson));
  }
}

}  // namespace

void require_reportable(const parameters::Case& c) {
  require_file_name(c.file);
  const config::Table root = config::Table::parse_file(c.file);
  require_title(root, c.title);
  require_integer(root.table("contact"), "nodes", c.contact.n_nodes, fewest_nodes, most_nodes);
  const double half_width = c.half_space.load.half_width();
  if (c.half_space.datum < half_width) {
    root.table("half_space")
        .fail("datum", fmt::format("{0} {1}: must be at least half_space.load.half_width, {2:.6g} "
                                   "{1}, for the report",
                                   c.half_space.datum, c.units.length, half_width));
  }
  if (c.block) require_block(root, c, *c.block);
}

}  // namespace paper
