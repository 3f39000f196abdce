// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/gnuplot.hpp"

#include <fmt/core.h>

#include <string_view>
#include <vector>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr int figure_seconds = 300;  // the slowest seen took 3

/// Overwrites the creation date of a PDF with a fixed one of the same length, because cairo writes
/// the present second whatever SOURCE_DATE_EPOCH says. cairo 1.18 hides it in a compressed stream of
/// objects, which qpdf takes apart.
void fix_creation_date(const fs::path& file) {
  constexpr std::string_view key = "/CreationDate (D:";
  constexpr std::string_view zero = "19700101000000";
  std::string pdf = sys::read_file(file);
  const bool is_whole = pdf.ends_with("%%EOF\n");  // half of one is told by who checks the figure
  if (is_whole && pdf.find("/ObjStm") != std::string::npos) {
    const sys::ProcessResult result = sys::run(
        {.program = "qpdf",
         .arguments = {"--object-streams=disable", "--static-id", "--replace-input", file.string()},
         .environment = {{"LC_ALL", "C.UTF-8"}}});
    if (result.exit_status != 0) {
      throw sys::ToolError(fmt::format("qpdf cannot read '{}': {}", file.string(), result.output));
    }
    pdf = sys::read_file(file);
  }
  const auto at = pdf.rfind(key);
  if (at == std::string::npos) return;
  const auto digits = at + key.size();
  if (pdf.find_first_not_of("0123456789", digits) != digits + zero.size()) return;
  pdf.replace(digits, zero.size(), zero);
  sys::write_file_atomically(file, pdf);
}

}  // namespace

sys::ProcessResult run_gnuplot(const fs::path& folder, const std::string& name,
                               const std::string& settings) {
  std::vector<std::string> arguments{"--default-settings"};
  if (!settings.empty()) arguments.insert(arguments.end(), {"-e", settings});
  arguments.push_back(name + ".gp");
  // With default settings gnuplot does not read the user's ~/.gnuplot.
  sys::ProcessResult result =
      sys::run({.program = "gnuplot",
                .arguments = arguments,
                .working_directory = folder,
                .environment = {{"LC_ALL", "C.UTF-8"}, {"TZ", "UTC"}, {"SOURCE_DATE_EPOCH", "0"}},
                .limit = {fmt::format("figure '{}'", name), figure_seconds}});
  const fs::path pdf = folder / (name + ".pdf");
  if (fs::is_regular_file(pdf)) fix_creation_date(pdf);
  return result;
}

}  // namespace literate
