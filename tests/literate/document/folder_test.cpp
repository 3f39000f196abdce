// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/folder.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <string>

#include "holds.hpp"
#include "literate/document/read_document.hpp"
#include "message_of.hpp"
#include "pendulum/pendulum.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

using literate::Document;
using literate::exact;
using literate::Value;
namespace fs = std::filesystem;

namespace {

const fs::path paper = ENGINE_TESTS "/pendulum";

/// Replaces the places in this source file, if one is named, by PLACE, since its lines may move.
std::string without_places(std::string text, const std::string& source) {
  if (source.empty()) return text;
  for (auto at = text.find(source); at != text.npos; at = text.find(source, at)) {
    auto begin = text.find_last_of("\"{,\n", at) + 1, end = at + source.size();
    while (end < text.size() && (text[end] == ':' || std::isdigit(text[end]) != 0)) ++end;
    text.replace(begin, end - begin, "PLACE");
    at = begin;
  }
  return text;
}

/// The contents of the files in a folder by name, without places.
std::map<std::string, std::string> files_of(const fs::path& folder, const std::string& source) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    files[name] = without_places(sys::read_file(entry.path()), source);
  }
  return files;
}

void require_same(const std::map<std::string, std::string>& found,
                  const std::map<std::string, std::string>& expected) {
  BOOST_TEST(found.size() == expected.size());
  for (const auto& [name, text] : expected) {
    BOOST_TEST_CONTEXT(name) {
      BOOST_REQUIRE(found.contains(name));
      BOOST_TEST(found.at(name) == text);
    }
  }
}

Document one_value(double number) {
  Document document;
  document.value("x", Value(number, exact()));
  return document;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(folder_test)

// `literate_pendulum compute pendulum/case.toml FOLDER` wrote pendulum/folder; PLACE replaces its
// lines of code.
BOOST_AUTO_TEST_CASE(a_paper_writes_its_folder) {
  const TemporaryFolder folder;
  Document document;
  pendulum::compute(document, paper / "case.toml");
  write_folder(document, folder.path(), "case.toml");
  require_same(files_of(folder.path(), "pendulum.cpp"), files_of(paper / "folder", ""));
}

BOOST_AUTO_TEST_CASE(a_script_that_registers_the_same_gives_the_same_folder) {
  const TemporaryFolder folder;
  const Document document = literate::read_document(paper / "registered.json");
  write_folder(document, folder.path(), "case.toml");
  require_same(files_of(folder.path(), "registered.json"), files_of(paper / "folder", ""));
}

BOOST_AUTO_TEST_CASE(an_unchanged_file_keeps_its_time_stamp) {
  const TemporaryFolder folder;
  write_folder(one_value(1), folder.path(), "c");
  const auto earlier = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const char* name : {"values.tex", "ledger.tex", "results.json"}) {
    fs::last_write_time(folder / name, earlier);
  }
  write_folder(one_value(2), folder.path(), "c");
  BOOST_CHECK(fs::last_write_time(folder / "ledger.tex") == earlier);
  BOOST_CHECK(fs::last_write_time(folder / "values.tex") != earlier);
  BOOST_CHECK(fs::last_write_time(folder / "results.json") != earlier);
}

BOOST_AUTO_TEST_CASE(obsolete_files_are_removed_and_drawings_stay) {
  const TemporaryFolder folder;
  Document with_figure = one_value(1);
  with_figure.figure("f", {.width_cm = 1, .height_cm = 1, .data = {{"d", {{"x", {1}}}}}});
  write_folder(with_figure, folder.path(), "c");
  const fs::path drawing = folder.write("figures/f/f.pdf", "a drawing");
  BOOST_TEST(fs::exists(folder / "figures/f/d.csv"));
  write_folder(one_value(1), folder.path(), "c");
  BOOST_TEST(!fs::exists(folder / "figures/f/d.csv"));
  BOOST_TEST(!fs::exists(folder / "figures/f/data.gp"));
  BOOST_TEST(fs::exists(drawing));
}

BOOST_AUTO_TEST_CASE(an_edited_list_of_files_removes_nothing_elsewhere) {
  const TemporaryFolder folder;
  const fs::path outside = folder.write("kept.txt", "kept");
  for (const std::string& list : {"{\"files\": [\"../kept.txt\", \"" + outside.string() + "\", 3]}",
                                  std::string("[1]"), std::string("half {")}) {
    folder.write("generated/results.json", list);
    write_folder(one_value(1), folder / "generated", "c");
    BOOST_TEST(fs::exists(outside));
  }
}

BOOST_AUTO_TEST_CASE(an_error_names_the_folder_that_cannot_be_written) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("generated", "a file in the place of the folder");
  const std::string message =
      message_of<sys::OutputError>([&] { write_folder(one_value(1), file, "c"); });
  BOOST_TEST(holds(message, file.string()));
}

BOOST_AUTO_TEST_SUITE_END()
