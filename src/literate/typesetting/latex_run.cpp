// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/latex_run.hpp"

#include <fmt/core.h>

namespace literate {
namespace fs = std::filesystem;

std::string seen_from(const fs::path& source_dir, const fs::path& path) {
  const fs::path from = fs::weakly_canonical(fs::absolute(source_dir));
  return fs::weakly_canonical(fs::absolute(path)).lexically_relative(from).generic_string();
}

std::map<std::string, std::string> latex_environment(const TypesetOptions& options) {
  std::string inputs = ".:" + seen_from(options.source_dir, options.generated_dir) + ":";
  if (!options.repository_dir.empty()) {
    inputs += seen_from(options.source_dir, options.repository_dir) + ":";
  }
  inputs += seen_from(options.source_dir, at_width_dir(options)) + ":";
  // TEXMFHOME, the folder of the user's own packages, is set to one that does not exist.
  return {{"SOURCE_DATE_EPOCH", fmt::format("{}", options.source_date_epoch)},
          {"FORCE_SOURCE_DATE", "1"},
          {"TZ", "UTC"},
          {"LC_ALL", "C"},
          {"max_print_line", "1000"},
          {"TEXMFHOME", "no-texmf-of-the-user"},
          {"TEXINPUTS", inputs}};
}

fs::path in_build_dir(const TypesetOptions& options, const char* extension) {
  return options.build_dir / fs::path(options.main_file).filename().replace_extension(extension);
}

}  // namespace literate
