// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/document_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "literate/prose/tex_commands.hpp"
#include "system/files.hpp"
#include "system/nearest_name.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

bool begins_document(const fs::path& file) {
  return std::ranges::any_of(sys::lines_of(sys::read_file(file)), [](std::string_view line) {
    return sys::stripped(line).starts_with("\\documentclass");
  });
}

}  // namespace

std::vector<std::string> document_files(const fs::path& source_dir) {
  std::vector<std::string> files = sys::files_below(source_dir);
  std::erase_if(files, [](const std::string& file) {
    return !file.ends_with(".tex") || file == page_preamble;
  });
  std::vector<std::string> others;  // folders of other documents, each with a '/' at its end
  for (const std::string& file : files) {
    const auto slash = file.rfind('/');
    if (slash == file.npos || !begins_document(source_dir / file)) continue;
    others.push_back(file.substr(0, slash + 1));
  }
  std::erase_if(files, [&](const std::string& file) {
    return std::ranges::any_of(others, [&](const auto& other) { return file.starts_with(other); });
  });
  return files;
}

std::string DocumentFile::at(int line, int column) const {
  return fmt::format("{}:{}:{}", label, line, column);
}

std::vector<DocumentFile> read_document(const fs::path& source_dir) {
  std::vector<DocumentFile> files;
  for (const std::string& name : document_files(source_dir)) {
    files.push_back(
        {name, source_label(source_dir) + "/" + name, sys::read_file(source_dir / name)});
  }
  return files;
}

OwnCommands own_commands_of(const fs::path& source_dir) {
  OwnCommands own;
  for (const DocumentFile& file : read_document(source_dir)) own.merge(own_commands_in(file.text));
  for (const std::string& file : sys::files_below(source_dir)) {
    if (!file.ends_with(".sty")) continue;
    own.merge(own_commands_in(sys::read_file(source_dir / file)));
  }
  return own;
}

std::vector<std::string> images_of(const fs::path& source_dir) {
  static const std::set<std::string> endings = {".png", ".jpg", ".jpeg", ".pdf"};
  std::set<std::string> found;
  for (const DocumentFile& file : read_document(source_dir)) {
    for (const TexCommand& use : commands_in(file.text, {"includegraphics"})) {
      const fs::path image = fs::path(use.argument).lexically_normal();
      if (image.is_absolute() || *image.begin() == ".." || !endings.contains(image.extension()) ||
          !fs::is_regular_file(source_dir / image)) {
        continue;
      }
      found.insert(image.generic_string());
    }
  }
  return {found.begin(), found.end()};
}

namespace {

bool is_in(const fs::path& folder, const std::string& name) {
  return fs::is_regular_file(folder / name) || fs::is_regular_file(folder / (name + ".tex"));
}

/// Whether TeX has a file of this name, as it has `glyphtounicode`.
bool is_in_tex(const fs::path& folder, const std::string& name) {
  return sys::run({"kpsewhich", {name}, folder, {}, {}}).exit_status == 0;
}

/// The names of the databases in the argument of \bibliography or \addbibresource, as files.
std::vector<std::string> databases(const TexCommand& use) {
  std::vector<std::string> files;
  for (const std::string& part : sys::split(use.argument, ',')) {
    const std::string name(sys::stripped(part));
    if (!name.empty()) files.push_back(name.ends_with(".bib") ? name : name + ".bib");
  }
  return files;
}

/// Whether the document brings the references themselves, as BibTeX wrote them.
bool has_references(const fs::path& folder) {
  return std::ranges::any_of(sys::files_below(folder),
                             [](const std::string& file) { return file.ends_with(".bbl"); });
}

std::vector<std::string> missing_databases(const fs::path& folder, const DocumentFile& file) {
  std::vector<std::string> errors;
  for (const TexCommand& use : commands_in(file.text, {"bibliography", "addbibresource"})) {
    for (const std::string& name : databases(use)) {
      if (name.find('\\') != std::string::npos) continue;
      const bool is_there = fs::is_regular_file(folder / name);
      const bool is_outside =
          is_there && fs::path(name).lexically_normal().begin()->string() == "..";
      if (!is_outside && (is_there || is_in_tex(folder, name))) continue;
      errors.push_back(fmt::format(
          "{}: {}", file.at(use.line, use.column),
          is_outside ? fmt::format("the bibliography '{}' lies outside the folder of the document, "
                                   "where no build would see it change; move it there",
                                   name)
                     : fmt::format("there is no bibliography '{}'", name)));
    }
  }
  return errors;
}

}  // namespace

std::vector<std::string> missing_inputs(const fs::path& folder, const fs::path& generated) {
  const std::vector<DocumentFile> files = read_document(folder);
  std::set<std::string> parts;
  for (const DocumentFile& file : files) {
    parts.insert(fs::path(file.name).replace_extension().generic_string());
  }
  const bool brings_references = has_references(folder);
  std::vector<std::string> errors;
  for (const DocumentFile& file : files) {
    std::set<std::string> optional;
    for (const TexCommand& use : commands_in(file.text, {"IfFileExists"})) {
      optional.insert(use.argument);
    }
    for (const TexCommand& use : commands_in(file.text, {"input", "include"})) {
      const std::string& name = use.argument;
      if (optional.contains(name) || optional.contains(name + ".tex")) continue;
      if (name.find('\\') != std::string::npos || is_in(folder, name) || is_in(generated, name) ||
          is_in_tex(folder, name)) {
        continue;
      }
      errors.push_back(fmt::format("{}: there is no file '{}'{}", file.at(use.line, use.column),
                                   name, sys::suggestion(name, parts)));
    }
    if (!brings_references) {
      const std::vector<std::string> missing = missing_databases(folder, file);
      errors.insert(errors.end(), missing.begin(), missing.end());
    }
  }
  return errors;
}

std::vector<std::string> misplaced_files(const fs::path& folder,
                                         const std::vector<std::string>& generated) {
  std::vector<std::string> errors;
  for (const std::string& file : generated) {
    // LaTeX reads no script of a figure, and these may stand in the document's folder.
    if (file.ends_with(".gp") || !fs::exists(folder / file)) continue;
    errors.push_back(fmt::format(
        "{}/{}: has the name of a file that is generated, and would take its place; rename it",
        source_label(folder), file));
  }
  for (const DocumentFile& file : read_document(folder)) {
    for (const TexCommand& use : commands_in(file.text, {"input", "include"})) {
      const fs::path name = fs::path(use.argument).lexically_normal();
      if (name != page_preamble && name != fs::path(page_preamble).stem()) continue;
      errors.push_back(fmt::format("{}: {} is read for the page alone; rename this part",
                                   file.at(use.line, use.column), page_preamble));
    }
  }
  return errors;
}

}  // namespace literate
