// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/attachments.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "literate/text/latex.hpp"
#include "system/files.hpp"

namespace literate {

void Attachments::add(const AttachedFile& file) {
  const auto [entry, is_new] = files_.try_emplace(file.name, file);
  if (is_new || entry->second.text == file.text) return;
  throw std::logic_error(
      fmt::format("the file '{}' is attached twice with different contents", file.name));
}

void Attachments::add(const Attachments& others) {
  for (const auto& [name, file] : others.files_) add(file);
}

std::map<std::string, std::string> Attachments::digests() const {
  std::map<std::string, std::string> digests;
  for (const auto& [name, file] : files_) digests[name] = sys::sha256_of_text(file.text);
  return digests;
}

void Attachments::write(const std::filesystem::path& folder) const {
  for (const auto& [name, file] : files_) sys::write_file_atomically(folder / name, file.text);
}

std::string Attachments::latex(const std::string& folder) const {
  std::string text;
  for (const auto& [name, file] : files_) {
    text += fmt::format(
        "\\par\\medskip\\textbf{{{}}}, \\texttt{{{}}}\n\\LiterateFile{{{}/{}}}{{{}}}\\par\n",
        escape_latex(file.kind), escape_latex_path(name), folder, name,
        sys::sha256_of_text(file.text));
  }
  return text;
}

}  // namespace literate
