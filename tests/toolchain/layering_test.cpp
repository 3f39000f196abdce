// SPDX-License-Identifier: GPL-3.0-or-later
// The architecture: which folder may include which.
#include <boost/test/unit_test.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "toolchain/source_tree.hpp"

namespace {

// A folder, and what it may include besides itself: other folders, or single headers of them.
const std::map<std::string, std::set<std::string>> allowed = {
    {"numerics", {}},
    {"elasticity", {"numerics"}},
    {"contact", {"numerics", "elasticity"}},
    {"block", {"numerics", "elasticity"}},
    {"literate", {"numerics/estimate.hpp"}},
    {"parameters", {"numerics", "elasticity", "contact", "block"}},
    {"figures", {"literate"}},
    {"toolchain", {}},
    {"paper",
     {"numerics", "elasticity", "contact", "block", "literate", "parameters", "figures",
      "toolchain/build_info.hpp", "toolchain/libraries.hpp"}},
    {"course", {"literate", "numerics", "parameters/case_table.hpp"}},
    {"assignment", {"course", "literate", "numerics", "elasticity", "contact"}},
    {"app",
     {"numerics", "elasticity", "contact", "block", "literate", "parameters", "figures", "paper",
      "course", "assignment", "toolchain"}},
};

const std::set<std::string> mechanics = {"numerics", "elasticity", "contact", "block"};

std::string folder_of(const std::filesystem::path& file) {
  auto part = file.begin();
  if (*part == "src") ++part;
  return part->string();
}

bool may_include(const std::string& folder, const std::string& header) {
  const std::string from = header.substr(0, header.find('/'));
  const auto& others = allowed.at(folder);
  return from == folder || others.contains(from) || others.contains(header);
}

// What a line includes of this project; empty if nothing.
std::string included(const std::string& line) {
  static const std::regex include(R"re(^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>))re");
  std::smatch match;
  if (!std::regex_search(line, match, include)) return "";
  if (match[1].matched) return match[1];
  const std::string header = match[2];
  const bool ours =
      allowed.contains(header.substr(0, header.find('/'))) && header.find('/') != std::string::npos;
  return ours ? header : "";
}

// A LaTeX command, as a comment or raw string writes it (from a list, because "\n" and "\t" also
// start a word) or as an ordinary string does, with two backslashes.
bool holds_latex(const std::string& line) {
  static const std::regex command(
      R"re(\\(begin|end|frac|sqrt|left|right|text\w*|math\w*|emph|cite|ref|label|eqref|cref|num|qty|)re"
      R"re(SI|si|unit|val|tab|fig|claim|excerpt|sigma|pi|ln|int|sum|cdot)\b|\\\\[A-Za-z]{2,})re");
  return std::regex_search(line, command);
}

std::vector<std::filesystem::path> sources() {
  auto files = source_tree::files_below("src");
  for (auto& file : source_tree::files_below("figures")) files.push_back(std::move(file));
  std::erase_if(files, [](const auto& file) { return !source_tree::is_cpp(file); });
  return files;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_rules_tell_downward_from_upward) {
  BOOST_TEST(may_include("contact", "elasticity/material.hpp"));
  BOOST_TEST(may_include("contact", "contact/grid.hpp"));
  BOOST_TEST(may_include("literate", "numerics/estimate.hpp"));
  BOOST_TEST(!may_include("literate", "numerics/quadrature.hpp"));
  BOOST_TEST(!may_include("elasticity", "contact/grid.hpp"));
  BOOST_TEST(!may_include("numerics", "figures/style.hpp"));
}

BOOST_AUTO_TEST_CASE(includes_and_latex_are_recognised_as_written) {
  BOOST_TEST(included("#  include \"literate/value.hpp\"  // why") == "literate/value.hpp");
  BOOST_TEST(included("#include <contact/grid.hpp>") == "contact/grid.hpp");
  BOOST_TEST(included("#include <Eigen/Dense>").empty());
  BOOST_TEST(holds_latex(R"(/// \frac{1}{2})"));
  BOOST_TEST(holds_latex(R"(out << "\\textbf{x}";)"));
  BOOST_TEST(!holds_latex(R"(out << "\nleft\tright";)"));
}

BOOST_AUTO_TEST_CASE(every_folder_has_a_rule) {
  for (const auto& file : sources()) {
    BOOST_TEST(allowed.contains(folder_of(file)), file.string() << ": a folder without a rule");
  }
}

BOOST_AUTO_TEST_CASE(no_folder_includes_upward) {
  for (const auto& file : sources()) {
    if (!allowed.contains(folder_of(file))) continue;
    for (const auto& line : source_tree::lines_of(file)) {
      const std::string header = included(line);

      BOOST_TEST((header.empty() || may_include(folder_of(file), header)),
                 file.string() << " must not include " << header);
    }
  }
}

BOOST_AUTO_TEST_CASE(mechanics_knows_no_latex) {
  for (const auto& file : sources()) {
    if (!mechanics.contains(folder_of(file))) continue;
    for (const auto& line : source_tree::lines_of(file)) {
      BOOST_TEST(!holds_latex(line), file.string() << " holds LaTeX: " << line);
    }
  }
}
