// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "literate/main/paper.hpp"
#include "paper/paper.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "toolchain/libraries.hpp"

namespace paper {

void compute_provenance(Document& document, const Case& from) {
  document.value("provenance.version", Value::text(from.paper.version));
  document.value("provenance.case", Value::text(from.file.filename().string()));
  document.value("provenance.case-sha256", Value::text(sys::sha256_of_file(from.file)));
  document.value("provenance.compiler", Value::text(from.paper.compiler));
  document.value("provenance.flags", Value::text(from.paper.flags));
  auto libraries = toolchain::libraries();
  libraries.merge(literate::engine_libraries());
  for (const auto& [key, name] :
       {std::pair{"gsl", "GSL"}, {"eigen", "Eigen"}, {"boost", "Boost"}, {"fmt", "fmt"}}) {
    document.value(std::string("provenance.") + key, Value::text(libraries.at(name)));
  }
  document.value("provenance.gnuplot", Value::text(sys::tool_version("gnuplot")));
  document.value("provenance.tex", Value::text(sys::tool_version(from.paper.latex)));
  document.value("case.title", Value::text(from.title));
}

}  // namespace paper
