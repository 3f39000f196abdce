// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/figure_widths.hpp"

#include <fmt/core.h>

#include <string_view>

#include "literate/prose/document_files.hpp"
#include "literate/prose/source_label.hpp"
#include "literate/prose/tex_commands.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"
#include "system/pattern.hpp"

namespace literate {
namespace {

/// What is wrong with the options; empty if nothing is.
std::string fault_of(std::string_view options) {
  static const sys::Pattern number(
      R"(\s*([-+]?)(\d+[.,]?\d*|[.,]\d+)\s*(pt|mm|cm|in|ex|em|bp|pc|dd|cc|sp)\s*)");
  const auto equals = options.find('=');
  const std::string_view key = sys::stripped(options.substr(0, equals));
  if (key != "width" || equals == std::string_view::npos) {
    return fmt::format("\\fig takes one option, width=…, and not '{}'", options);
  }
  const std::string_view width = sys::stripped(options.substr(equals + 1));
  const auto found = number.match_all_of(width);
  const bool holds_length = width.find('\\') != std::string_view::npos;
  if (found ? found->parts[1] != "-" : holds_length) return "";
  return fmt::format(
      "width={} is no width: a number with a unit, or lengths of LaTeX as 0.8\\columnwidth", width);
}

}  // namespace

std::vector<std::string> figure_width_errors(const std::filesystem::path& source_dir) {
  std::vector<std::string> errors;
  for (const std::string& file : document_files(source_dir)) {
    for (const TexCommand& use : commands_in(sys::read_file(source_dir / file), {"fig"})) {
      if (use.options.empty()) continue;
      const std::string fault = fault_of(use.options);
      if (fault.empty()) continue;
      errors.push_back(fmt::format("{}/{}:{}:{}: figure '{}': {}", source_label(source_dir), file,
                                   use.line, use.column, use.argument, fault));
    }
  }
  return errors;
}

}  // namespace literate
