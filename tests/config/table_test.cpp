// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/table.hpp"

#include <boost/test/unit_test.hpp>
#include <functional>
#include <string>
#include <vector>

#include "messages.hpp"
#include "temporary_folder.hpp"

using config::Dimension;
using config::Error;
using config::Table;
using config::unit_system;

namespace {

/// Returns the error from reading this text, without the file's name: «line:column: key: message».
std::string error_of(const std::string& text, const std::function<void(const Table&)>& read) {
  const TemporaryFolder folder;
  const auto file = folder.write("some case.toml", text);
  const std::string message = message_of<Error>([&] { read(Table::parse_file(file)); });
  const std::string place = file.string() + ":";
  BOOST_TEST(message.starts_with(place), message);
  return message.substr(std::min(place.size(), message.size()));
}

void read_length(const Table& table) {
  table.quantity("width", Dimension::length, unit_system("mm-N"));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(table_test)

BOOST_AUTO_TEST_CASE(values_of_every_type_are_read) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.toml",
                                 "title = 'x'\ncount = 3\nratio = 1\n"
                                 "names = ['a', \"b\"]\n[t]\nwidth = {value = 2, unit = \"in\"}\n");
  const Table table = Table::parse_file(file);

  BOOST_TEST(table.text("title") == "x");
  BOOST_TEST(table.integer("count") == 3);
  BOOST_TEST(table.number("ratio") == 1);
  BOOST_TEST((table.texts("names") == std::vector<std::string>{"a", "b"}));
  BOOST_TEST(table.table("t").quantity("width", Dimension::length, unit_system("mm-N")) == 50.8);
  BOOST_TEST(table.table("t").quantity("width", "ft") == 0.166666666666667);
  BOOST_TEST(table.is_text("title", "x"));
  BOOST_TEST(!table.is_text("absent", "x"));
  BOOST_TEST(table.place("count") == file.string() + ":2:9");
  BOOST_TEST(table.keys().size() == 5);
  table.reject_unknown_keys();
}

BOOST_AUTO_TEST_CASE(an_error_is_one_line_with_place_and_key) {
  const auto number = [](const Table& t) { t.number("a"); };
  const struct {
    const char* text;
    std::function<void(const Table&)> read;
    const char* error;
  } table[] = {
      {"a = 1\nb = \n", number, "2:5: "},
      {"a = 1\na = 2\n", number, "2:"},
      {"b = 1\n", number, "1:1: a: missing"},
      {"a = nan\n", number, "1:5: a: nan: must be a finite number"},
      {"a = 'x'\n", number, "1:5: a: must be a number, not string"},
      {"a = true\n", number, "1:5: a: must be a number, not boolean"},
      {"n = 1.5\n", [](const Table& t) { t.integer("n"); },
       "1:5: n: must be an integer, not floating-point"},
      {"t = 3\n", [](const Table& t) { t.table("t"); }, "1:5: t: must be a table, not integer"},
      {"s = ['a',\n  2]\n", [](const Table& t) { t.texts("s"); },
       "2:3: s: must be a string, not integer"},
      {"s = 'a'\n", [](const Table& t) { t.texts("s"); },
       "1:5: s: must be an array of strings, not string"},
      {"width = 2\n", read_length,
       "1:9: width: must be a quantity such as {value = 1.0, unit = \"mm\"}, not integer"},
      {"width = {value = 2}\n", read_length, "1:9: width.unit: missing"},
      {"width = {value = \"2\", unit = \"mm\"}\n", read_length,
       "1:18: width.value: must be a number, not string"},
      {"\nwidth = {value = 2, unit = \"psi\"}\n", read_length,
       "2:28: width.unit: \"psi\" cannot be converted into \"mm\""},
      {"width = {value = 2, unit = \"furlongz\"}\n", read_length,
       "1:28: width.unit: unknown unit \"furlongz\""},
  };
  for (const auto& [text, read, error] : table) {
    BOOST_TEST_CONTEXT(text) BOOST_TEST(holds(error_of(text, read), error));
  }
}

BOOST_AUTO_TEST_CASE(an_unknown_key_is_an_error) {
  const auto read = [](const Table& t) {
    t.number("length");
    if (t.has("gravity")) t.number("gravity");
    if (t.has("t")) t.table("t").number("b");
    t.reject_unknown_keys();
  };
  BOOST_TEST(error_of("length = 1\nmass = 2\n", read) == "2:1: mass: unknown key");
  BOOST_TEST(error_of("length = 1\n[t]\nb = 3\nc = 4\n", read) == "4:1: t.c: unknown key");
  BOOST_TEST(error_of("length = 1\ngravty = 2\n", read) ==
             "2:1: gravty: unknown key, did you mean 'gravity'?");
  BOOST_TEST(error_of("[t]\na = 1\nlenght = 1\n", [](const Table& t) {
               t.table("t").number("length");
             }) == "3:10: t.length: missing; is 'lenght' misspelt?");
  // A key that exists is not suggested.
  BOOST_TEST(error_of("length = 1\nlength2 = 2\n", read) == "2:1: length2: unknown key");
}

BOOST_AUTO_TEST_CASE(an_unreadable_file_is_named) {
  BOOST_TEST(holds(message_of<Error>([] { Table::parse_file("no such file.toml"); }),
                   "cannot read 'no such file.toml'"));
  BOOST_CHECK_THROW(Table::parse_file(TemporaryFolder().path()), Error);
}

BOOST_AUTO_TEST_SUITE_END()
