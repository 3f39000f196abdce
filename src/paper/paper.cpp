// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include <functional>
#include <tuple>
#include <utility>

#include "paper/printed_data.hpp"
#include "system/parallel.hpp"

// One line a section, in the order of the report, which numbers the claims: its name, and the parts
// of the case that it needs. NAME is that of its prose, with _ for -, and of its file,
// NAME_section.cpp, which defines compute_NAME(document, part …). A section whose parts the case
// does not all have is left out.
#define PAPER_SECTIONS(SECTION)                                                           \
  SECTION(provenance, std::filesystem::path, std::string, literate::Paper)                \
  SECTION(formulation, HalfSpaceCase, UnitSystem)                                         \
  SECTION(quadrature, HalfSpaceCase, UnitSystem)                                          \
  SECTION(results, HalfSpaceCase, UnitSystem, std::optional<PrintedData>)                 \
  SECTION(finite_block, HalfSpaceCase, BlockCase, UnitSystem, std::optional<PrintedData>) \
  SECTION(error_analysis, HalfSpaceCase, UnitSystem, std::optional<PrintedData>)          \
  SECTION(cylinders, ContactCase, UnitSystem, std::optional<PrintedData>)                 \
  SECTION(contact_m, ContactCase, UnitSystem, PrintedData)                                \
  SECTION(elements, ContactCase)                                                          \
  SECTION(methods, ContactCase)                                                           \
  SECTION(profiles, ContactCase, UnitSystem)                                              \
  SECTION(regions, ContactCase, UnitSystem)                                               \
  SECTION(friction, ContactCase)                                                          \
  SECTION(stresses, ContactCase)                                                          \
  SECTION(program, Listings)

namespace paper {

using config::UnitSystem;
using literate::Document;
using parameters::BlockCase;
using parameters::ContactCase;
using parameters::HalfSpaceCase;

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
      : parts_(&c.file, &c.title, &c.units, &c.half_space, &c.contact, pointer_to(c.block),
               &printed, pointer_to(printed), pointer_to(listings), &paper) {}

  template <typename Part>
  const Part* find() const {
    return std::get<const Part*>(parts_);
  }

 private:
  std::tuple<const std::filesystem::path*, const std::string*, const UnitSystem*,
             const HalfSpaceCase*, const ContactCase*, const BlockCase*,
             const std::optional<PrintedData>*, const PrintedData*, const Listings*,
             const literate::Paper*>
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

// The report inverts matrices of several grids, the finest with eight times the case's nodes, and
// solves a dozen blocks.
constexpr long most_nodes = 1001;
constexpr int most_refine = 3;

// A case that the commands can solve may be too large for the report.
void require_reportable(const parameters::Case& c) {
  const auto refuse = [&](const char* table, const char* key, long value, long most) {
    config::Table::parse_file(c.file).table(table).fail(
        key, fmt::format("{}: must be at most {} for the report", value, most));
  };
  if (c.contact.n_nodes > most_nodes) refuse("contact", "nodes", c.contact.n_nodes, most_nodes);
  if (c.block && c.block->discretization.refine > most_refine) {
    refuse("block", "refine", c.block->discretization.refine, most_refine);
  }
}

}  // namespace

void compute(Document& document, const parameters::Case& from_file,
             const std::optional<Listings>& listings, const literate::Paper& paper) {
  require_reportable(from_file);
  const std::optional<PrintedData> printed = read_printed(from_file);
  document.flag("printed", printed.has_value());
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
