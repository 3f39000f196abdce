// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <string>

#include "literate/document/document.hpp"
#include "literate/excerpts/excerpt_coverage.hpp"
#include "paper/paper.hpp"

namespace paper {

void compute_program(literate::Document& document, const Listings& listings) {
  using literate::Column;
  using literate::integer;
  literate::Table table(
      "excerpt-coverage",
      {Column::text("folder"), Column("lines of code", integer()), Column("in excerpts", integer()),
       Column("share", literate::percent(0)).exact(), Column("files without", integer())});
  std::string rest;
  for (const char* folder : {"elasticity", "contact", "block"}) {
    const auto coverage =
        literate::coverage_of(listings.source, std::string("src/") + folder, listings.excerpts);
    table.add_row({folder, coverage.n_lines, coverage.n_shown,
                   static_cast<double>(coverage.n_shown) / coverage.n_lines, coverage.rest.size()});
    for (const std::string& file : coverage.rest) {
      rest +=
          fmt::format("{}{}/{}", rest.empty() ? "" : ", ", folder, file.substr(0, file.find('.')));
    }
  }
  document.table(std::move(table));
  document.value("coverage.rest", literate::Value::text(rest));
}

}  // namespace paper
