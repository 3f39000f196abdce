// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/source_files.hpp"

#include <fmt/core.h>

#include <string_view>
#include <utility>

#include "literate/imports/import_error.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

std::string name_below(const fs::path& root, const fs::path& file) {
  const fs::path whole = fs::weakly_canonical(file);
  const fs::path relative = whole.lexically_relative(fs::weakly_canonical(root));
  const bool is_inside = !relative.empty() && *relative.begin() != "..";
  std::string name = (is_inside ? relative : whole.filename()).generic_string();
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+.,=/-";
  if (name.find_first_not_of(allowed) != name.npos) {
    throw ImportError(fmt::format(
        "{}: the name must be letters, digits and _ + . , = / -, to be attached to the document",
        file.string()));
  }
  return name;
}

}  // namespace

std::string read_numbers(const fs::path& file) {
  try {
    return sys::read_file(file);
  } catch (const sys::OutputError&) {
    throw ImportError(fmt::format("{}: the file cannot be read", file.string()));
  }
}

NumbersAndScript with_script(const fs::path& file, std::string text, const fs::path& script,
                             const fs::path& root) {
  std::string script_text;
  try {
    script_text = sys::read_file(script);
  } catch (const sys::OutputError&) {
    throw ImportError(
        fmt::format("{}: its script '{}' cannot be read", file.string(), script.string()));
  }
  return {{name_below(root, file), std::move(text), "numbers of another program"},
          {name_below(root, script), std::move(script_text), "script of such numbers"}};
}

}  // namespace literate
