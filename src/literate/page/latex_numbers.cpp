// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/latex_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "literate/prose/tex_scanner.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

[[noreturn]] void fail_of_state(const std::string& what) {
  throw sys::InputError(
      fmt::format("the PDF has no {}: it was made from another state of the document", what));
}

/// «[type][counter][counters above]number»: the type, and what sorts as the counters do.
void read_cleveref(const std::string& text, PrintedLabel& label) {
  const std::vector<std::string> parts = groups_at(text, '[', ']');
  if (parts.size() < 3) return;
  label.type = parts[0];
  // cleveref calls both the same.
  if (label.type == "subsection" || label.type == "subsubsection") label.type = "section";
  label.order = fmt::format("{:>40}{:>8}", parts[2], parts[1]);
  label.above = parts[2];
  label.count = std::atoi(parts[1].c_str());
}

// Cleveref makes the capital of a name that the document gives when it prints the name.
std::string with_capital(const std::string& name) {
  static const sys::Pattern made(R"(\\MakeUppercase\s*(?:\[\])?\s*\{([a-z])\}(.*))");
  const auto found = made.match_all_of(name);
  if (!found) return name;
  return static_cast<char>(found->parts[1].front() - 'a' + 'A') + found->str(2);
}

}  // namespace

std::vector<std::string> groups_at(std::string_view text, char open, char close) {
  std::vector<std::string> groups;
  for (std::string_view group = group_at(text, open, close); !group.empty();
       group = group_at(text, open, close)) {
    const auto begin = group.find(open) + 1;
    groups.emplace_back(group.substr(begin, group.size() - begin - 1));
    text.remove_prefix(group.size());
  }
  return groups;
}

LatexNumbers::LatexNumbers(const std::filesystem::path& aux) {
  read(aux);
  for (auto& [counter, queue] : numbers_) std::ranges::sort(queue, {}, &PrintedNumber::order);
}

void LatexNumbers::read(const std::filesystem::path& aux) {
  const std::string text = sys::read_file(aux);
  for (const std::string_view line : sys::lines_of(text)) {
    const auto open = std::min(line.find('{'), line.size());
    const std::string_view command = line.substr(0, open);
    const std::vector<std::string> arguments = groups_at(line.substr(open));
    const std::size_t n = arguments.size();
    if (command == "\\@input" && n == 1) read(aux.parent_path() / arguments[0]);
    // A list of what a package has captions for.
    constexpr std::string_view listed = "\\contentsline ";
    if (command == "\\@writefile" && n == 2 && arguments[1].starts_with(listed) &&
        arguments[0] != "toc" && arguments[0] != "lof" && arguments[0] != "lot") {
      const auto entry = groups_at(std::string_view(arguments[1]).substr(listed.size()));
      if (!entry.empty()) captioned_.insert(entry[0]);
    }
    if (command == "\\newlabel" && n == 2) read_label(arguments);
    if (command == "\\Newlabel" && n == 2) labels_[arguments[0]].number = arguments[1];
    if (command == "\\bibcite" && n == 2) {
      const auto parts = groups_at(arguments[1]);
      citations_[arguments[0]] = parts.empty() ? std::vector{arguments[1]} : parts;
    }
    if (command == "\\LiterateName" && n == 5) {
      names_[arguments[0]] = {arguments[1], arguments[2], with_capital(arguments[3]),
                              with_capital(arguments[4])};
    }
    if (command == "\\LiterateAutoName" && n == 2) auto_names_[arguments[0]] = arguments[1];
    // An environment of several numbered parts steps its counter once more for the whole.
    if (command == "\\LiterateNumber" && n == 5 && arguments[2] != "subequations" &&
        !arguments[1].empty()) {
      numbers_[arguments[0]].push_back(
          {arguments[1], arguments[2], arguments[3], std::atoi(arguments[4].c_str())});
    }
  }
}

void LatexNumbers::read_label(const std::vector<std::string>& arguments) {
  const std::vector<std::string> parts = groups_at(arguments[1]);
  constexpr std::string_view cleveref = "@cref";
  if (arguments[0].ends_with(cleveref) && !parts.empty()) {
    const std::string key = arguments[0].substr(0, arguments[0].size() - cleveref.size());
    return read_cleveref(parts[0], labels_[key]);
  }
  if (parts.size() < 2) return;
  PrintedLabel& label = labels_[arguments[0]];
  label.number = parts[0];
  const bool is_group = label.number.starts_with('{') && group_at(label.number) == label.number;
  if (is_group) label.number = label.number.substr(1, label.number.size() - 2);
  label.page = parts[1];
  if (parts.size() > 2) label.title = parts[2];
  if (parts.size() > 3) label.link = parts[3].substr(0, parts[3].find('.'));
}

const PrintedNumber* LatexNumbers::next(const std::string& counter) const {
  const auto found = numbers_.find(counter);
  return found == numbers_.end() || found->second.empty() ? nullptr : &found->second.front();
}

PrintedNumber LatexNumbers::take(const std::string& counter) {
  if (!next(counter)) fail_of_state("further number of a " + counter);
  std::deque<PrintedNumber>& queue = numbers_[counter];
  const PrintedNumber number = queue.front();
  queue.pop_front();
  taken_.insert(counter);
  return number;
}

// A float of a package need not bear the name of its counter.
std::string LatexNumbers::captioned(const std::string& environment) const {
  if (next(environment)) return environment;
  const auto counter =
      std::ranges::find_if(captioned_, [&](const std::string& name) { return next(name); });
  if (counter == captioned_.end()) {
    fail_of_state(fmt::format("further number for a caption of '{}'", environment));
  }
  return *counter;
}

std::string LatexNumbers::left() const {
  // Counters that LaTeX's packages keep for themselves print nothing.
  static const std::set<std::string, std::less<>> printed{
      "part",  "chapter", "section",    "subsection", "subsubsection", "equation", "figure",
      "table", "enumi",   "lstlisting", "footnote",   "enumii",        "enumiii"};
  std::string text;
  for (const auto& [counter, queue] : numbers_) {
    const bool is_printed =
        printed.contains(counter) || taken_.contains(counter) || captioned_.contains(counter);
    if (queue.empty() || !is_printed) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", queue.size(), counter);
  }
  return text;
}

const PrintedLabel& LatexNumbers::label(const std::string& key) const {
  const auto found = labels_.find(key);
  if (found == labels_.end()) fail_of_state(fmt::format("label '{}'", key));
  return found->second;
}

bool LatexNumbers::follows(const std::string& first, const std::string& second) const {
  const PrintedLabel &a = label(first), &b = label(second);
  return a.above == b.above && a.count > 0 && b.count == a.count + 1;
}

std::array<std::string, 4> LatexNumbers::names(const std::string& type) const {
  const auto found = names_.find(type == "subequation" ? "equation" : type);
  return found == names_.end() ? std::array{type, type + "s", type, type + "s"} : found->second;
}

const std::string& LatexNumbers::auto_name(const PrintedLabel& label) const {
  const auto found = auto_names_.find(label.link);
  if (found == auto_names_.end()) fail_of_state(fmt::format("\\autoref to a '{}'", label.link));
  return found->second;
}

std::vector<std::string> LatexNumbers::citation(const std::string& key) const {
  const auto found = citations_.find(key);
  if (found == citations_.end()) fail_of_state(fmt::format("source '{}'", key));
  return found->second;
}

}  // namespace literate
