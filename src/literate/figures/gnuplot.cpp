// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/gnuplot.hpp"

#include <fmt/core.h>

#include <string_view>
#include <vector>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"
#include "system/parallel.hpp"
#include "system/process.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

void require_file(const fs::path& folder, const std::string& file_name) {
  std::error_code error;
  if (fs::file_size(folder / file_name, error) == 0 || error) {
    throw sys::ToolError(fmt::format("gnuplot drew nothing: {} is missing or empty", file_name));
  }
}

/// Overwrites the creation date of a PDF with a fixed one of the same length, because cairo 1.16
/// writes the present second; later versions obey SOURCE_DATE_EPOCH.
void fix_creation_date(const fs::path& file) {
  constexpr std::string_view key = "/CreationDate (D:";
  constexpr std::string_view zero = "19700101000000";
  std::string pdf = sys::read_file(file);
  const auto at = pdf.rfind(key);
  if (at == std::string::npos) return;
  const auto digits = at + key.size();
  if (pdf.find_first_not_of("0123456789", digits) != digits + zero.size()) return;
  pdf.replace(digits, zero.size(), zero);
  sys::write_file_atomically(file, pdf);
}

}  // namespace

void run_gnuplot(const fs::path& folder, const std::string& name) {
  const std::string script = name + ".gp";
  // With default settings gnuplot does not read the user's ~/.gnuplot.
  const sys::ProcessResult result =
      sys::run({.program = "gnuplot",
                .arguments = {"--default-settings", script},
                .working_directory = folder,
                .environment = {{"LC_ALL", "C.UTF-8"}, {"TZ", "UTC"}, {"SOURCE_DATE_EPOCH", "0"}}});
  const bool has_message =
      result.output.find(fmt::format("\"{}\" line ", script)) != std::string::npos;
  if (result.exit_status != 0 || has_message) {
    throw sys::ToolError(
        fmt::format("gnuplot, figure '{}': {}", name, sys::stripped(result.output)));
  }
  require_file(folder, name + ".tex");
  require_file(folder, name + ".pdf");
  fix_creation_date(folder / (name + ".pdf"));
}

void draw_figures(const fs::path& folder, const std::map<std::string, Figure>& figures) {
  std::vector<std::string> names;
  for (const auto& [name, figure] : figures) {
    Plot plot(folder, name, figure.width_cm, figure.height_cm);
    figure.draw(plot);
    plot.close();
    names.push_back(name);
  }

  sys::for_each_parallel(names.size(), 0, [&](std::size_t i) { run_gnuplot(folder, names[i]); });
}

}  // namespace literate
