// SPDX-License-Identifier: GPL-3.0-or-later
// The architecture. That a folder includes only what it links is the compiler's to see, since a
// library exports its own headers alone. Here: that the links, which CMake wrote down, have no
// circle and keep their direction, that the rooms within a folder keep their order, and that no
// file needs itself by way of others.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "toolchain/source_tree.hpp"

BOOST_AUTO_TEST_SUITE(architecture_test)

namespace {

struct Library {
  std::string name;
  std::string folder;
  std::vector<std::string> links;
  std::vector<std::string> rooms;  // in the order in which they build on one another
};

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

// What CMake wrote: a line a library, «name|folder|links|rooms».
std::vector<Library> libraries() {
  std::vector<Library> result;
  std::ifstream file(HALFSPACE_ARCHITECTURE);
  for (std::string line; std::getline(file, line);) {
    std::istringstream stream(line);
    std::string name, folder, links, rooms;
    std::getline(stream, name, '|');
    std::getline(stream, folder, '|');
    std::getline(stream, links, '|');
    std::getline(stream, rooms, '|');
    result.push_back({name, folder, words_of(links), words_of(rooms)});
  }
  return result;
}

// For each name, the names that it needs itself.
using Graph = std::map<std::string, std::set<std::string>>;

// All that a name needs, directly or not; itself only if there is a circle.
std::set<std::string> reach_of(const std::string& name, const Graph& graph) {
  std::set<std::string> reach;
  std::vector<std::string> open{name};
  while (!open.empty()) {
    const auto needs = graph.find(open.back());
    open.pop_back();
    if (needs == graph.end()) continue;
    for (const std::string& need : needs->second) {
      if (reach.insert(need).second) open.push_back(need);
    }
  }
  return reach;
}

// The names that need themselves by way of others.
std::vector<std::string> in_circles(const Graph& graph) {
  std::vector<std::string> names;
  for (const auto& [name, needs] : graph) {
    if (reach_of(name, graph).contains(name)) names.push_back(name);
  }
  return names;
}

Graph links() {
  Graph graph;
  for (const Library& library : libraries()) {
    graph[library.name] = {library.links.begin(), library.links.end()};
  }
  return graph;
}

bool links_any(const std::set<std::string>& reach, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const auto& name) { return reach.contains(name); });
}

const std::set<std::string> mechanics = {"numerics",     "elasticity",    "contact",
                                         "line_contact", "point_contact", "block"};

// The room of «literate/values/value.hpp» is values; that of a header in the folder itself is
// empty.
std::string room_of(const std::string& path) {
  const auto first = path.find('/');
  const auto second = path.find('/', first + 1);
  return second == std::string::npos ? "" : path.substr(first + 1, second - first - 1);
}

// Whether a file of one room may include a header of another: the same one, or one that comes
// before. What lies in the folder itself, outside all rooms, is the roof of them all: it may use
// every room, and no room uses it.
bool may_include(const std::vector<std::string>& rooms, const std::string& from,
                 const std::string& to) {
  const auto at = [&](const std::string& room) {
    return std::find(rooms.begin(), rooms.end(), room);
  };
  return at(to) <= at(from);
}

// What a line includes of this project; empty if nothing.
std::string included(const std::string& line) {
  static const std::regex include(R"re(^\s*#\s*include\s*"([^"]+)")re");
  std::smatch match;
  return std::regex_search(line, match, include) ? match[1].str() : "";
}

// A LaTeX command, as a comment or raw string writes it (from a list, because "\n" and "\t" also
// start a word) or as an ordinary string does, with two backslashes.
bool holds_latex(const std::string& line) {
  static const std::regex command(
      R"re(\\(begin|end|frac|sqrt|left|right|text\w*|math\w*|emph|cite|ref|label|eqref|cref|num|qty|)re"
      R"re(SI|si|unit|val|tab|fig|claim|excerpt|sigma|pi|ln|int|sum|cdot)\b|\\\\[A-Za-z]{2,})re");
  return std::regex_search(line, command);
}

std::filesystem::path path_of(const Library& library) {
  return "src/" + library.folder;
}

std::vector<std::filesystem::path> sources_of(const Library& library) {
  auto files = source_tree::files_below(path_of(library));
  std::erase_if(files, [](const auto& file) { return !source_tree::is_cpp(file); });
  return files;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_folder_of_src_is_a_library_with_its_links) {
  std::set<std::string> folders;
  for (const Library& library : libraries()) folders.insert(library.folder);

  for (const auto& file : source_tree::files_below("src")) {
    if (!source_tree::is_cpp(file)) continue;
    const std::string folder = std::next(file.begin())->string();
    const bool is_known = folders.contains(folder) || folder == "app" || folder == "report_app" ||
                          folder == "toolchain";
    BOOST_TEST(is_known, file.string() << ": CMake knows no library of this folder");
  }
}

BOOST_AUTO_TEST_CASE(no_library_links_itself_by_way_of_others) {
  BOOST_TEST(in_circles(links()) == std::vector<std::string>{}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(mechanics_links_neither_engine_nor_paper_and_the_engine_no_mechanics) {
  const Graph all = links();
  const std::vector<std::string> upper = {"literate",   "paper",  "course",
                                          "assignment", "system", "config"};
  for (const std::string& name : mechanics)
    BOOST_TEST(!links_any(reach_of(name, all), upper), name);
  const std::vector<std::string> lower(mechanics.begin(), mechanics.end());
  BOOST_TEST(!links_any(reach_of("literate", all), lower));
  BOOST_TEST(!links_any(reach_of("course", all), lower));
  BOOST_TEST(!reach_of("course", all).contains("parameters"));
}

BOOST_AUTO_TEST_CASE(nothing_but_the_course_itself_links_the_course) {
  const std::set<std::string> of_course = {"course", "assignment", "course_app"};
  const Graph all = links();
  for (const Library& library : libraries()) {
    if (of_course.contains(library.name)) continue;
    BOOST_TEST(!links_any(reach_of(library.name, all), {"course", "assignment"}), library.name);
  }
}

BOOST_AUTO_TEST_CASE(a_room_includes_only_rooms_that_come_before_it) {
  for (const Library& library : libraries()) {
    if (library.rooms.empty()) continue;
    for (const auto& file : sources_of(library)) {
      const std::string from = room_of(file.lexically_relative("src").generic_string());
      BOOST_TEST(
          (from.empty() || std::count(library.rooms.begin(), library.rooms.end(), from) == 1),
          file.string() << ": a room that CMake does not list");
      for (const auto& line : source_tree::lines_of(file)) {
        const std::string header = included(line);
        if (!header.starts_with(library.folder + "/")) continue;

        BOOST_TEST(may_include(library.rooms, from, room_of(header)),
                   file.string() << " must not include " << header);
      }
    }
  }
}

// A header and the source beside it count as one: «value» is value.hpp and value.cpp.
BOOST_AUTO_TEST_CASE(no_two_files_of_a_folder_need_one_another) {
  Graph needs;
  for (const auto& file : source_tree::files_below("src")) {
    if (!source_tree::is_cpp(file)) continue;
    const std::string name = file.lexically_relative("src").replace_extension().generic_string();
    for (const auto& line : source_tree::lines_of(file)) {
      const std::string header = included(line);
      const std::string other = header.substr(0, header.rfind('.'));
      if (!other.empty() && other != name) needs[name].insert(other);
    }
  }
  BOOST_TEST(needs["literate/tables/table"].contains("literate/tables/printed_column"));

  BOOST_TEST(in_circles(needs) == std::vector<std::string>{}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_circle_is_found_however_long_it_is) {
  const Graph graph = {{"a", {"b", "d"}}, {"b", {"c"}}, {"c", {"a"}}, {"d", {"e"}}};
  BOOST_TEST(in_circles(graph) == (std::vector<std::string>{"a", "b", "c"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_order_of_rooms_tells_downward_from_upward) {
  const std::vector<std::string> rooms = {"text", "values", "tables"};
  BOOST_TEST(may_include(rooms, "tables", "values"));
  BOOST_TEST(may_include(rooms, "values", "values"));
  BOOST_TEST(may_include(rooms, "", "tables"));
  BOOST_TEST(!may_include(rooms, "values", "tables"));
  BOOST_TEST(!may_include(rooms, "tables", ""));
  BOOST_TEST(room_of("literate/values/value.hpp") == "values");
  BOOST_TEST(room_of("literate/document.hpp").empty());
}

BOOST_AUTO_TEST_CASE(includes_and_latex_are_recognised_as_written) {
  BOOST_TEST(included("#  include \"literate/value.hpp\"  // why") == "literate/value.hpp");
  BOOST_TEST(included("#include <Eigen/Dense>").empty());
  BOOST_TEST(holds_latex(R"(/// \frac{1}{2})"));
  BOOST_TEST(holds_latex(R"(out << "\\textbf{x}";)"));
  BOOST_TEST(!holds_latex(R"(out << "\nleft\tright";)"));
}

BOOST_AUTO_TEST_CASE(mechanics_knows_no_latex) {
  for (const Library& library : libraries()) {
    if (!mechanics.contains(library.folder)) continue;
    for (const auto& file : sources_of(library)) {
      for (const auto& line : source_tree::lines_of(file)) {
        BOOST_TEST(!holds_latex(line), file.string() << " holds LaTeX: " << line);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
