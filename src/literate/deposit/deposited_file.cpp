// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/deposit/deposited_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

bool holds_digest(const Manifest::Texts& digests, const std::string& sha256) {
  return std::ranges::any_of(digests, [&](const auto& entry) { return entry.second == sha256; });
}

}  // namespace

std::vector<DepositedFile> deposited_files(const fs::path& folder, const Manifest& manifest) {
  std::vector<DepositedFile> files;
  for (const std::string& name : sys::files_below(folder)) {
    DepositedFile file{.name = name,
                       .sha256 = sys::sha256_of_file(folder / name),
                       .size = fs::file_size(folder / name)};
    if (holds_digest(manifest.outputs, file.sha256)) {
      file.part = Part::output;
    } else if (holds_digest(manifest.inputs, file.sha256)) {
      file.part = Part::input;
    }
    files.push_back(std::move(file));
  }
  return files;
}

std::string media_type(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> types{
      {{".pdf", "application/pdf"},
       {".csv", "text/csv"},
       {".json", "application/json"},
       {".toml", "application/toml"},
       {".cff", "application/yaml"},
       {".yml", "application/yaml"},
       {".html", "text/html"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".tex", "text/x-tex"},
       {".dat", "text/plain"},
       {".gp", "text/plain"},
       {".m", "text/x-octave"},
       {".txt", "text/plain"}}};
  for (const auto& [ending, type] : types) {
    if (name.ends_with(ending)) return std::string(type);
  }
  return "";
}

}  // namespace literate
