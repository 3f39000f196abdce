// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/folder.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "messages.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

using literate::Document;
using literate::exact;
using literate::Value;
namespace fs = std::filesystem;

namespace {

Document one_value(double number) {
  Document document;
  document.value("x", Value(number, exact()));
  return document;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(folder_test)

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
  for (const std::string& list :
       {"{\"files\": [\"../kept.txt\", \"" + outside.string() + "\"]}", std::string("[1]"),
        std::string("{\"files\": [3]}"), std::string("half {")}) {
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
