// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "literate/document/document.hpp"
#include "system/files.hpp"
#include "system/tool_version.hpp"
#include "toolchain/build_info.hpp"
#include "toolchain/libraries.hpp"

namespace paper {
using literate::Value;

void compute_provenance(literate::Document& document, const std::filesystem::path& file,
                        const std::string& title) {
  document.value("provenance.version", Value::text(toolchain::version));
  document.value("provenance.commit", Value::text(toolchain::commit));
  document.flag("provenance.modified", toolchain::modified);
  document.value("provenance.case", Value::text(file.filename().string()));
  document.value("provenance.case-sha256", Value::text(sys::sha256_of_file(file)));
  document.value("provenance.compiler", Value::text(toolchain::compiler));
  document.value("provenance.flags", Value::text(toolchain::flags));
  const auto libraries = toolchain::libraries();
  for (const auto& [key, name] :
       {std::pair{"gsl", "GSL"}, {"eigen", "Eigen"}, {"boost", "Boost"}, {"fmt", "fmt"}}) {
    document.value(std::string("provenance.") + key, Value::text(libraries.at(name)));
  }
  document.value("provenance.gnuplot", Value::text(sys::tool_version("gnuplot")));
  document.value("provenance.tex", Value::text(sys::tool_version("pdflatex")));
  document.value("case.title", Value::text(title));
  document.value("case.file", Value::text(file.filename().string()));
}

}  // namespace paper
