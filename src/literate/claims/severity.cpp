// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/severity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "literate/claims/claim.hpp"
#include "system/csv.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;

namespace {

bool may_be_turned_to(const std::string& text) {
  const std::array verdicts{Verdict::confirmed, Verdict::partly, Verdict::refuted,
                            Verdict::undecided};
  return text == "gone" ||
         std::ranges::any_of(verdicts, [&](Verdict verdict) { return text == name_of(verdict); });
}

}  // namespace

std::string Severity::text_of(const std::string& claim) const {
  const auto found = n_turning.find(claim);
  if (found == n_turning.end()) return "not known";
  const int n = found->second;
  return fmt::format("{} of {} faults", n == 0 ? "none" : fmt::format("{}", n), n_faults);
}

std::string Severity::summary() const {
  return fmt::format(
      "Of {} planted faults the verdicts show {}; internal checks, or an abort of the program, "
      "show {} more; "
      "nothing here shows the other {}.",
      n_faults, n_turning_any, n_failing_only, n_faults - n_turning_any - n_failing_only);
}

std::string digest_of_code(const fs::path& root, const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    if (!fs::is_directory(root / name)) {
      files.push_back(name);
      continue;
    }
    for (const std::string& file : sys::files_below(root / name))
      files.push_back(name + "/" + file);
  }
  std::ranges::sort(files);
  std::string lines;
  for (const std::string& file : files) {
    lines += sys::sha256_of_text(sys::read_file(root / file)) + "  " + file + "\n";
  }
  return sys::sha256_of_text(lines);
}

std::optional<Severity> read_severity(const fs::path& file, const fs::path& root,
                                      const fs::path& case_file) {
  if (!fs::exists(file)) return std::nullopt;
  const std::string text = sys::read_file(file);
  const auto refuse = [&](const char* what) {
    throw sys::SourceError(
        fmt::format("{}:1:1: {}; 'make severity' writes it", file.string(), what));
  };
  const std::string head(text.substr(0, text.find('\n')));
  constexpr std::string_view begins = "# ", of = " of ";
  constexpr std::size_t digest_length = 64;
  if (!head.starts_with(begins) || head.find(of) != begins.size() + digest_length) {
    refuse("the first line is not «# SHA-256 of folders»");
  }
  const std::vector<std::string> names =
      sys::split(std::string_view(head).substr(begins.size() + digest_length + of.size()), ':');
  const std::string this_case = fs::relative(case_file, root).generic_string();
  if (std::ranges::find(names, this_case) == names.end()) return std::nullopt;
  if (!std::ranges::all_of(names, [&](const auto& name) { return fs::exists(root / name); }) ||
      digest_of_code(root, names) != head.substr(begins.size(), digest_length)) {
    return std::nullopt;
  }
  const std::vector<sys::CsvRow> rows =
      sys::parse_csv(text, file.string(), sys::CsvComments::number_sign);
  if (rows.empty() || rows.front().front().text != "claim") refuse("there is no row of faults");
  const std::size_t n_faults = rows.front().size() - 1;
  Severity severity{.n_faults = static_cast<int>(n_faults), .n_turning = {}};
  std::vector<bool> turns(n_faults), fails(n_faults);
  for (const sys::CsvRow& row : rows) {
    if (&row == &rows.front()) continue;
    const bool is_claim = !row.front().text.starts_with('(');  // «(checks)» and «(program)»
    for (std::size_t i = 0; i < std::min(n_faults, row.size() - 1); ++i) {
      const sys::CsvField& turned_to = row[i + 1];
      if (turned_to.text.empty()) continue;
      if (is_claim && !may_be_turned_to(turned_to.text)) {
        throw sys::SourceError(fmt::format("{}: '{}' is no verdict; 'make severity' writes it",
                                           turned_to.place, turned_to.text));
      }
      (is_claim ? turns : fails)[i] = true;
      ++severity.n_turning[row.front().text];
    }
    severity.n_turning.try_emplace(row.front().text, 0);
  }
  for (std::size_t i = 0; i < n_faults; ++i) {
    severity.n_turning_any += turns[i] ? 1 : 0;
    severity.n_failing_only += fails[i] && !turns[i] ? 1 : 0;
  }
  return severity;
}

}  // namespace literate
