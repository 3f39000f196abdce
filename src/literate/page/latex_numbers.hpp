// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// A number as the PDF prints it, LaTeX.
struct PrintedNumber {
  std::string number;
  std::string environment;  ///< around it
  std::string shown;        ///< the word before it in a caption, or the item's whole mark
  int order = 0;            ///< floats stand elsewhere in the PDF
};

/// What a label names.
struct PrintedLabel {
  std::string number;  ///< LaTeX
  std::string page;
  std::string title;  ///< of the section or caption, LaTeX; empty without hyperref
  std::string type;   ///< as cleveref calls it; empty without cleveref
  std::string link;   ///< the kind of its link, as hyperref calls it; empty without hyperref
  std::string order;  ///< sorts like the counters
  std::string above;  ///< the counters above this one
  int count = 0;      ///< of the counter
};

/// All numbers of the PDF, from the .aux file that LaTeX wrote for it.
class LatexNumbers {
 public:
  /// Reads the file and those that it names (\include). Throws sys::OutputError.
  explicit LatexNumbers(const std::filesystem::path& aux);

  /// The counter's next number that was not taken yet; null if the PDF prints no more.
  const PrintedNumber* next(const std::string& counter) const;

  /// The counter of the next caption in an environment of a package. Throws sys::InputError if the
  /// PDF has no more.
  std::string captioned(const std::string& environment) const;

  /// Takes the counter's next number. Throws sys::InputError if the PDF has no more.
  PrintedNumber take(const std::string& counter);

  /// «2 equations, 1 figure»: what was not taken; empty if all was.
  std::string left() const;

  /// Throws sys::InputError for a label that the PDF does not have.
  const PrintedLabel& label(const std::string& key) const;

  /// Whether the second label's number is the next of the first one's counter.
  bool follows(const std::string& first, const std::string& second) const;

  /// How a reference to labels of one type begins: singular, plural, and both at the start of a
  /// sentence.
  std::array<std::string, 4> names(const std::string& type) const;

  /// What \\autoref prints before the number of a label, LaTeX; nothing if it has no word for it.
  /// Throws sys::InputError if the PDF has no such reference.
  const std::string& auto_name(const PrintedLabel& label) const;

  bool cites(const std::string& key) const { return citations_.contains(key); }

  /// The label of a citation, such as 3; of natbib also year and authors.
  std::vector<std::string> citation(const std::string& key) const;

 private:
  void read(const std::filesystem::path& aux);
  void read_label(const std::vector<std::string>& arguments);

  std::map<std::string, std::deque<PrintedNumber>> numbers_;
  std::set<std::string> taken_;
  std::map<std::string, PrintedLabel> labels_;
  std::map<std::string, std::array<std::string, 4>> names_;
  std::map<std::string, std::string> auto_names_;  ///< by the kind of link
  std::map<std::string, std::vector<std::string>> citations_;
  std::set<std::string> captioned_;  ///< counters of a package's captions, by the lists of them
};

/// The groups in braces, or other delimiters, at the start of a text, without their delimiters.
std::vector<std::string> groups_at(std::string_view text, char open = '{', char close = '}');

}  // namespace literate
