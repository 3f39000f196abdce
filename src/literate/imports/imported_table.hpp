// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "literate/document/document.hpp"
#include "literate/tables/table.hpp"
#include "system/error.hpp"

namespace literate {

/// A file of another program's numbers cannot be used as it is; what() is
/// «file:line:column: what is wrong», without line and column if the file as a whole is meant.
class ImportError : public sys::InputError {
 public:
  using InputError::InputError;
};

/// A column of a table from elsewhere.
struct ImportedColumn {
  std::string heading = {};           ///< LaTeX
  std::string plain = {};             ///< the heading as its file writes it, if that is plain text
  std::string unit = {};              ///< literal text
  std::optional<Format> format = {};  ///< none where each number has the digits that its file gives
  int exponent = 0;                   ///< the power of ten that numbers are divided by
  bool is_text = false;
  bool is_exact = false;  ///< whether a number without an error is exact
  std::string at = {};    ///< where it is described, for messages; filled in by what reads the file
};

/// A number as a file writes it.
struct WrittenNumber {
  double number = 0;
  int place = 0;  ///< the power of ten of the last written digit
  bool has_exponent = false;
  std::string text;  ///< as it is written
};

/// Reads a decimal number, with a sign, a point or an exponent or without; none if the text is
/// anything else, which includes nan and inf. A number beyond the range of double becomes infinite.
std::optional<WrittenNumber> written_number(std::string_view text);

/// Whether the double has all digits that are written, or its rounding is less than the error.
bool is_held(const WrittenNumber& written, double error);

/// A cell of a table from elsewhere.
struct ImportedCell {
  std::variant<std::monostate, WrittenNumber, std::string> content = {};
  std::map<std::string, double> errors = {};  ///< abs_error, or below and above, and standard
  std::string at = {};                        ///< «file:line:column», for messages
};

/// Makes a table for the document. A number that keeps its digits keeps them as far as its error
/// supports them.
///
/// Throws ImportError naming the cell for a number or an error bound that is not finite, an error
/// bound that is negative, one to one side without the other, a number without an error unless its
/// column is exact or of integers, a number printed with more digits than its error supports or a
/// double holds, a text in a column of numbers, a number in a column of texts, and a fraction in a
/// column of whole numbers; naming the column's place, or `at`, which is where the table begins,
/// for a column that cannot be printed.
Table table_of(const std::string& name, const std::vector<ImportedColumn>& columns,
               const std::vector<std::vector<ImportedCell>>& rows, const std::string& at);

/// A file of numbers and the script that wrote it.
struct NumbersAndScript {
  AttachedFile numbers;
  AttachedFile script;
};

/// Reads a file as text; throws ImportError naming it if it cannot be read.
std::string read_numbers(const std::filesystem::path& file);

/// Puts a file of numbers, whose text was read already, together with its script. Both are named
/// relative to `root`, or by their file name alone if they lie elsewhere.
///
/// Throws ImportError if the script cannot be read, or if either name holds characters other than
/// letters, digits and _ + . , = / -, which LaTeX and arXiv do not all take.
NumbersAndScript with_script(const std::filesystem::path& file, std::string text,
                             const std::filesystem::path& script,
                             const std::filesystem::path& root);

}  // namespace literate
