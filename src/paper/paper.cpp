// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include <utility>

#include "system/parallel.hpp"

namespace paper {

void compute(Document& document, const parameters::Case& from_file,
             const std::optional<Listings>& listings, const literate::Paper& paper) {
  require_reportable(from_file);
  const Case from{from_file, read_printed(from_file), listings, paper};
  document.flag("printed", from.printed_data.has_value());
  document.flag("point-contact", from.point_contact.has_value());
  document.flag("block", from.block.has_value());
  document.flag("block.fitted", from.block && from.printed_data);

  std::vector<Document> documents(sections().size());
  sys::for_each_parallel(documents.size(), 0,
                         [&](std::size_t i) { sections()[i].compute(documents[i], from); });
  for (Document& part : documents) document.append(std::move(part));
}

}  // namespace paper
