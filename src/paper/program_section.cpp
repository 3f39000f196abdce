// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <string>

#include "literate/document/document.hpp"
#include "literate/excerpts/excerpt_coverage.hpp"
#include "paper/paper.hpp"

namespace paper {

void compute_program(literate::Document& document, const Listings& listings) {
  using literate::Column;
  literate::Table table({Column::text("folder"), Column::integer("lines of code"),
                         Column::integer("in excerpts"), Column::fixed("share", "percent", 0),
                         Column::integer("files without")});
  std::string rest;
  for (const char* folder : {"elasticity", "contact", "block"}) {
    const auto coverage =
        literate::coverage_of(listings.source, std::string("src/") + folder, listings.excerpts);
    table.add_row({folder, coverage.n_lines, coverage.n_shown,
                   100.0 * coverage.n_shown / coverage.n_lines, coverage.rest.size()});
    for (const std::string& file : coverage.rest) {
      rest +=
          fmt::format("{}{}/{}", rest.empty() ? "" : ", ", folder, file.substr(0, file.find('.')));
    }
  }
  document.table("excerpt-coverage", std::move(table));
  document.value("coverage.rest", literate::Value::text(rest));
}

}  // namespace paper
