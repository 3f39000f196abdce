// SPDX-License-Identifier: GPL-3.0-or-later
// What every stage has to know of a paper: where its parts lie, and where what is made of them
// goes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// The file NAME.settings that literate_add_paper writes: a line «name=value» for each of these, of
/// which the last counts.
/// The scripts read the same file and more lines of it.
struct Settings {
  std::string name = {};                 ///< of the paper's targets and of the PDF
  std::filesystem::path root = {};       ///< the checkout
  std::filesystem::path document = {};   ///< the folder in which LaTeX runs
  std::string main_file = {};            ///< of the document, such as "report.tex"
  std::filesystem::path case_file = {};  ///< the parameters
  std::filesystem::path figures = {};    ///< the folder of the gnuplot scripts
  /// What the scripts read that make its data (literate_run_script).
  std::vector<std::filesystem::path> reads = {};
  std::vector<std::string> tools = {};  ///< that run these scripts, such as python3
  /// Records, as sha256sum writes them, of what was read and made for it before the stages.
  std::vector<std::filesystem::path> records = {};
  std::filesystem::path output = {};      ///< the folder of all that is made
  std::filesystem::path repository = {};  ///< the folder of its state; empty if it is not known
  std::filesystem::path engine = {};      ///< the engine's own folder, for what the page looks like
  std::string latex = "pdflatex";         ///< or "lualatex"

  std::filesystem::path generated() const { return output / "generated"; }
  /// The list of the generated files with their SHA-256.
  std::filesystem::path digest() const { return output / "generated.sha256"; }
  /// Which planted faults turn which claims, as `severity` found it; part of the document.
  std::filesystem::path severity_record() const { return document / "severity.csv"; }
  /// LaTeX's own files.
  std::filesystem::path latex_folder() const { return output / "latex"; }
  std::filesystem::path pdf() const { return output / (name + ".pdf"); }
  std::filesystem::path manifest() const { return output / "manifest.json"; }
  /// The parts of the page.
  std::filesystem::path page_folder() const { return output / "html"; }
  std::filesystem::path page() const { return output / (name + ".html"); }
  /// The record of a stage that is done.
  std::filesystem::path record(const std::string& stage) const { return output / "state" / stage; }
};

/// Throws sys::InputError naming the file, and the line or the setting, for a line that is no
/// setting, for one that is missing and for a LaTeX that is not known.
Settings read_settings(const std::filesystem::path& file);

}  // namespace literate
