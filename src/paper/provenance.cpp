// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gsl/gsl_version.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <string>

#include "literate/files.hpp"
#include "literate/process.hpp"
#include "paper/sections.hpp"
#include "toolchain/build_info.hpp"

namespace paper {
namespace {

using literate::Value;

std::string first_line_of(const std::string& program, const std::string& flag) {
  const literate::ProcessResult result = literate::run({.program = program, .arguments = {flag}});
  return result.output.substr(0, result.output.find('\n'));
}

}  // namespace

void describe_provenance(literate::Document& document, const parameters::Case& from_file) {
  document.value("provenance.version", Value::text(toolchain::version));
  document.value("provenance.commit", Value::text(toolchain::commit));
  document.flag("provenance.modified", toolchain::modified);
  document.value("provenance.case", Value::text(from_file.file.filename().string()));
  document.value("provenance.case-sha256", Value::text(literate::sha256_of_file(from_file.file)));
  document.value("provenance.compiler", Value::text(toolchain::compiler));
  document.value("provenance.flags", Value::text(toolchain::flags));
  document.value("provenance.gsl", Value::text(gsl_version));
  document.value("provenance.eigen",
                 Value::text(fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                         EIGEN_MINOR_VERSION)));
  document.value("provenance.boost", Value::text(fmt::format("{}.{}", BOOST_VERSION / 100000,
                                                             BOOST_VERSION / 100 % 1000)));
  document.value("provenance.fmt",
                 Value::text(fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                                         FMT_VERSION % 100)));
  document.value("provenance.gnuplot", Value::text(first_line_of("gnuplot", "--version")));
  document.value("provenance.tex", Value::text(first_line_of("pdflatex", "--version")));
  document.value("case.title", Value::text(from_file.title));
  document.value("case.file", Value::text(from_file.file.filename().string()));
}

}  // namespace paper
