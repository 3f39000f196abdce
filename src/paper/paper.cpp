// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include <fmt/core.h>

#include <functional>
#include <sstream>
#include <tuple>
#include <utility>

#include "literate/text/latex.hpp"
#include "paper/printed_data.hpp"
#include "system/parallel.hpp"
#include "system/utf8.hpp"

// One line a section, in the order of the report, which numbers the claims: its name, and the parts
// of the case that it needs. NAME is that of its prose, with _ for -, and of its file,
// NAME_section.cpp, which defines compute_NAME(document, part …). A section whose parts the case
// does not all have is left out.
#define PAPER_SECTIONS(SECTION)                                                           \
  SECTION(provenance, std::filesystem::path, std::string, literate::Paper)                \
  SECTION(formulation, HalfSpaceCase, UnitSystem)                                         \
  SECTION(quadrature, HalfSpaceCase)                                                      \
  SECTION(results, HalfSpaceCase, UnitSystem, std::optional<PrintedData>,                 \
          std::optional<BlockCase>)                                                       \
  SECTION(finite_block, HalfSpaceCase, BlockCase, UnitSystem, std::optional<PrintedData>) \
  SECTION(error_analysis, HalfSpaceCase, UnitSystem, std::optional<PrintedData>)          \
  SECTION(cylinders, ContactCase, UnitSystem, std::optional<PrintedData>,                 \
          std::optional<PointContactCase>)                                                \
  SECTION(octave, ContactCase, UnitSystem, PrintedData, Listings)                         \
  SECTION(contact_m, ContactCase, UnitSystem, PrintedData)                                \
  SECTION(elements, ContactCase)                                                          \
  SECTION(methods, ContactCase)                                                           \
  SECTION(profiles, ContactCase, UnitSystem)                                              \
  SECTION(regions, ContactCase, WavesCase, UnitSystem)                                    \
  SECTION(friction, ContactCase, FrictionCase, std::optional<PrintedData>)                \
  SECTION(stresses, ContactCase, FrictionCase)                                            \
  SECTION(spheres, ContactCase, PointContactCase, UnitSystem)

namespace paper {

using config::UnitSystem;
using literate::Document;
using parameters::BlockCase;
using parameters::ContactCase;
using parameters::FrictionCase;
using parameters::HalfSpaceCase;
using parameters::PointContactCase;
using parameters::WavesCase;

template <typename... Part>
using Compute = void(Document& document, const Part&... part);

#define PAPER_DECLARE(NAME, ...) Compute<__VA_ARGS__> compute_##NAME;
PAPER_SECTIONS(PAPER_DECLARE)
#undef PAPER_DECLARE

namespace {

template <typename Part>
const Part* pointer_to(const std::optional<Part>& part) {
  return part ? &*part : nullptr;
}

// All that a section can ask for; null where the case has none of it.
class Parts {
 public:
  Parts(const parameters::Case& c, const std::optional<PrintedData>& printed,
        const std::optional<Listings>& listings, const literate::Paper& paper)
      : parts_(&c.file, &c.title, &c.units, &c.half_space, &c.contact,
               pointer_to(c.contact.friction), pointer_to(c.contact.waves),
               pointer_to(c.point_contact), &c.point_contact, pointer_to(c.block), &c.block,
               &printed, pointer_to(printed), pointer_to(listings), &paper) {}

  template <typename Part>
  const Part* find() const {
    return std::get<const Part*>(parts_);
  }

 private:
  std::tuple<const std::filesystem::path*, const std::string*, const UnitSystem*,
             const HalfSpaceCase*, const ContactCase*, const FrictionCase*, const WavesCase*,
             const PointContactCase*, const std::optional<PointContactCase>*, const BlockCase*,
             const std::optional<BlockCase>*, const std::optional<PrintedData>*, const PrintedData*,
             const Listings*, const literate::Paper*>
      parts_;
};

struct Section {
  std::string name;
  std::function<void(Document&, const Parts&)> compute;
};

template <typename... Part>
Section section(const char* name, Compute<Part...>* compute) {
  return {name, [compute](Document& document, const Parts& parts) {
            if ((... && (parts.find<Part>() != nullptr))) {
              compute(document, *parts.find<Part>()...);
            }
          }};
}

#define PAPER_LIST(NAME, ...) section(#NAME, compute_##NAME),
const std::vector<Section>& sections() {
  static const std::vector<Section> list{PAPER_SECTIONS(PAPER_LIST)};
  return list;
}
#undef PAPER_LIST

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
  // They go beyond the paper: other commands do without them, the report does not.
  for (const char* key : {"friction", "waves"}) root.table("contact").table(key);
  const double half_width = c.half_space.load.half_width();
  if (c.half_space.datum < half_width) {
    root.table("half_space")
        .fail("datum", fmt::format("{0} {1}: must be at least half_space.load.half_width, {2:.6g} "
                                   "{1}, for the report",
                                   c.half_space.datum, c.units.length, half_width));
  }
  if (c.block) require_block(root, c, *c.block);
}

void compute(Document& document, const parameters::Case& from_file,
             const std::optional<Listings>& listings, const literate::Paper& paper) {
  require_reportable(from_file);
  const std::optional<PrintedData> printed = read_printed(from_file);
  document.flag("printed", printed.has_value());
  document.flag("point-contact", from_file.point_contact.has_value());
  document.flag("block", from_file.block.has_value());
  document.flag("block.fitted", from_file.block && printed);

  const Parts case_parts(from_file, printed, listings, paper);
  std::vector<Document> documents(sections().size());
  sys::for_each_parallel(documents.size(), 0,
                         [&](std::size_t i) { sections()[i].compute(documents[i], case_parts); });
  for (Document& part : documents) document.append(std::move(part));
}

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  for (const Section& section : sections()) names.push_back(section.name);
  return names;
}

}  // namespace paper
