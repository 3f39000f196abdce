// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "literate/document/document.hpp"
#include "literate/main/paper.hpp"
#include "literate/main/platform.hpp"
#include "system/files.hpp"
#include "system/tool_version.hpp"
#include "toolchain/libraries.hpp"

namespace paper {
using literate::Value;

void compute_provenance(literate::Document& document, const std::filesystem::path& file,
                        const std::string& title, const literate::Paper& paper) {
  document.value("provenance.version", Value::text(paper.version));
  document.value("provenance.case", Value::text(file.filename().string()));
  document.value("provenance.case-sha256", Value::text(sys::sha256_of_file(file)));
  document.value("provenance.compiler", Value::text(paper.compiler));
  document.value("provenance.flags", Value::text(paper.flags));
  auto libraries = toolchain::libraries();
  libraries.merge(literate::engine_libraries());
  for (const auto& [key, name] :
       {std::pair{"gsl", "GSL"}, {"eigen", "Eigen"}, {"boost", "Boost"}, {"fmt", "fmt"}}) {
    document.value(std::string("provenance.") + key, Value::text(libraries.at(name)));
  }
  document.value("provenance.gnuplot", Value::text(sys::tool_version("gnuplot")));
  document.value("provenance.tex", Value::text(sys::tool_version("pdflatex")));
  document.value("case.title", Value::text(title));
}

}  // namespace paper
