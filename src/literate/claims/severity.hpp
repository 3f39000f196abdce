// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace literate {

/// Which planted faults turn which claims, as `make severity` found it.
struct Severity {
  int n_faults = 0;                      ///< that were planted
  std::map<std::string, int> n_turning;  ///< of each claim, how many of them change its verdict
  int n_turning_any = 0;                 ///< that change any verdict
  int n_failing_only = 0;                ///< others that fail a check or end the program

  /// «3 of 41 faults»; of a claim that was not there then, «not known».
  std::string text_of(const std::string& claim) const;

  /// «Of 41 planted faults the verdicts show 30; internal checks, or an abort of the program, show
  /// 8 more; nothing here shows the other 3.»
  std::string summary() const;
};

/// SHA-256 of files, and of all files below folders, as named from `root` on. Comments and blanks
/// count: which of them compute nothing depends on the language. Throws sys::OutputError.
std::string digest_of_code(const std::filesystem::path& root,
                           const std::vector<std::string>& names);

/// Reads severity.csv. Its first line is «# SHA-256 of folder:folder:case.toml», the digest of the
/// code that the faults were planted in; then a row for each claim, which holds below each fault
/// the verdict that this turns it to. None if there is no such file, if it is of other code than
/// there is now, or of another case. Throws sys::SourceError for a file that is no such record.
std::optional<Severity> read_severity(const std::filesystem::path& file,
                                      const std::filesystem::path& root,
                                      const std::filesystem::path& case_file);

}  // namespace literate
