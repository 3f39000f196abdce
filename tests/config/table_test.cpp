// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/table.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(table_test)

using config::Dimension;
using config::Error;
using config::Table;
using config::unit_system;

namespace {

// Parses the text, reads from it, and wants an error at «line:column: what».
void check_error(const std::string& text, const std::function<void(const Table&)>& read,
                 const std::string& expected) {
  const TemporaryFolder folder;
  const auto file = folder.write("some case.toml", text);
  BOOST_CHECK_EXCEPTION(read(Table::parse_file(file)), Error, [&](const Error& e) {
    const std::string what = e.what();
    BOOST_TEST_MESSAGE(what);
    BOOST_TEST(what.find('\n') == std::string::npos);
    return what.find(file.string() + ":" + expected) == 0;
  });
}

void read_length(const Table& table) {
  table.quantity("width", Dimension::length, unit_system("mm-N"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_quantity_is_converted_to_the_systems_unit) {
  const TemporaryFolder folder;
  const auto table = Table::parse_file(folder.write(
      "case.toml", "width = {value = 2, unit = \"in\"}\nyoung = {value = 210, unit = \"GPa\"}\n"));

  BOOST_TEST(table.quantity("width", Dimension::length, unit_system("mm-N")) == 50.8);
  BOOST_TEST(table.quantity("young", Dimension::stress, unit_system("mm-N")) == 210e3);
}

BOOST_AUTO_TEST_CASE(a_converted_quantity_has_no_noise_of_the_conversion) {
  const TemporaryFolder folder;
  const auto converted = [&](const std::string& value, const char* from, const char* to) {
    const std::string text = "q = {value = " + value + ", unit = \"" + from + "\"}\n";
    return Table::parse_file(folder.write("case.toml", text)).quantity("q", to);
  };

  // By the definitions: an inch is 0.0254 m, a pound of force 4.4482216152605 N.
  BOOST_TEST(converted("39.4", "in", "m") == 1.00076);
  BOOST_TEST(converted("12", "in", "m") == 0.3048);
  BOOST_TEST(converted("3", "ft", "m") == 0.9144);
  BOOST_TEST(converted("5", "um", "m") == 5e-6);
  BOOST_TEST(converted("-39.4", "lbf", "N") == -175.2599316412637);
  BOOST_TEST(converted("6.02214076e23", "um", "m") == 6.02214076e17);
  BOOST_TEST(converted("0", "in", "m") == 0);
  // The factor is 1/3.6, 1/12 or 1/25.4, of which no decimal number is exact.
  for (int i = 1; i < 1000; ++i) {
    const std::string in_km_h = std::to_string(36 * i / 10) + "." + std::to_string(36 * i % 10);
    BOOST_TEST(converted(in_km_h, "km/h", "m/s") == i);
    BOOST_TEST(converted(std::to_string(12 * i), "in", "ft") == i);
    const int tenths = 254 * i;
    BOOST_TEST(converted(std::to_string(tenths / 10) + "." + std::to_string(tenths % 10), "mm",
                         "in") == i);
  }
}

BOOST_AUTO_TEST_CASE(a_list_of_numbers_or_quantities_names_the_element_that_is_none) {
  const TemporaryFolder folder;
  const auto table = Table::parse_file(
      folder.write("case.toml", "n = [1, 2.5]\nnone = []\nq = {value = [3, 5], unit = \"ft\"}\n"));

  BOOST_TEST((table.numbers("n") == std::vector<double>{1, 2.5}));
  BOOST_TEST(table.numbers("none").empty());
  BOOST_TEST((table.quantities("q", "m") == std::vector<double>{0.9144, 1.524}));
  table.reject_unknown_keys();

  const auto read = [](const Table& t) { t.numbers("n"); };
  check_error("n = [1,\n  'x']\n", read, "2:3: n: must be a number, not a string");
  check_error("n = [1, nan]\n", read, "1:9: n: nan: must be a finite number");
  check_error("n = 1\n", read, "1:5: n: must be an array of numbers, not an integer");
  check_error(
      "q = 1\n", [](const Table& t) { t.quantities("q", "m"); },
      "1:5: q: must be quantities such as {value = [1.0, 2.0], unit = \"m\"}, not an integer");
}

BOOST_AUTO_TEST_CASE(an_integer_that_no_double_holds_is_not_read_as_another_number) {
  const auto read = [](const Table& t) { t.number("seed"); };

  check_error(
      "seed = 9007199254740993\n", read,
      "1:8: seed: 9007199254740993: a number holds no integer beyond 2^53 = 9007199254740992");
  const TemporaryFolder folder;
  const auto table = Table::parse_file(folder.write("case.toml", "seed = 9007199254740992\n"));
  BOOST_TEST(table.number("seed") == 9007199254740992.0);
}

BOOST_AUTO_TEST_CASE(a_unit_of_the_wrong_kind_is_shown_with_its_place) {
  check_error("\nwidth = {value = 2, unit = \"psi\"}\n", read_length, "2:28: width.unit: ");
  check_error("width = {value = 2, unit = \"furlongz\"}\n", read_length,
              "1:28: width.unit: unknown unit \"furlongz\"");
}

BOOST_AUTO_TEST_CASE(a_missing_key_is_named) {
  check_error(
      "a = 1\n", [](const Table& t) { t.number("b"); }, "1:1: b: missing");
  check_error("width = {value = 2}\n", read_length, "1:9: width.unit: missing");
}

BOOST_AUTO_TEST_CASE(a_wrong_type_says_what_is_wanted_and_what_stands_there) {
  check_error("width = 2\n", read_length, "1:9: width: must be a quantity");
  check_error("width = {value = \"2\", unit = \"mm\"}\n", read_length,
              "1:18: width.value: must be a number, not a string");
  check_error(
      "n = 1.5\n", [](const Table& t) { t.integer("n"); },
      "1:5: n: must be an integer, not a number");
  check_error(
      "t = 3\n", [](const Table& t) { t.table("t"); }, "1:5: t: must be a table");
  check_error(
      "p = [1.5]\n", [](const Table& t) { t.printed_numbers("p"); }, "1:5: p: must be");
  check_error(
      "p = [\n  \"1.5\",\n  \"one\"]\n", [](const Table& t) { t.printed_numbers("p"); },
      "3:3: p: \"one\" is not");
}

BOOST_AUTO_TEST_CASE(nan_and_infinity_are_no_numbers_here) {
  check_error(
      "a = nan\n", [](const Table& t) { t.number("a"); }, "1:5: a: nan");
  check_error(
      "a = -inf\n", [](const Table& t) { t.number("a"); }, "1:5: a: -inf");
}

BOOST_AUTO_TEST_CASE(a_doubled_key_is_an_error_at_the_second) {
  check_error(
      "a = 1\na = 2\n", [](const Table&) {}, "2:");
}

BOOST_AUTO_TEST_CASE(what_is_not_toml_is_an_error_with_its_place) {
  check_error(
      "a = 1\nb = \n", [](const Table&) {}, "2:");
}

BOOST_AUTO_TEST_CASE(a_key_that_nobody_asked_for_is_an_error) {
  const auto read = [](const Table& t) {
    t.number("a");
    t.table("t").number("b");
    t.reject_unknown_keys();
  };

  check_error("a = 1\nyuong = 2\n[t]\nb = 3\n", read, "2:1: yuong: unknown key");
  check_error("a = 1\n[t]\nb = 3\nc = 4\n", read, "4:1: t.c: unknown key");
}

BOOST_AUTO_TEST_CASE(who_asks_for_a_text_has_asked_for_the_key) {
  const auto read = [](const Table& t) {
    const double mode = t.is_text("mode", "auto") ? 0 : t.number("mode");
    t.is_text("absent", "auto");
    t.reject_unknown_keys();
    return mode;
  };
  const TemporaryFolder folder;
  const auto path = folder.write("case.toml", "mode = \"auto\"\n");
  BOOST_TEST(read(Table::parse_file(path)) == 0);
  check_error(
      "mod = \"auto\"\n",
      [](const Table& t) {
        t.is_text("mode", "auto");
        t.reject_unknown_keys();
      },
      "1:1: mod: unknown key, did you mean 'mode'?");
}

BOOST_AUTO_TEST_CASE(a_misspelt_key_is_told_with_the_nearest_one) {
  check_error(
      "lenght = 1\n", [](const Table& t) { t.number("length"); },
      "1:1: length: missing, did you mean 'lenght'?");
  check_error(
      "# a\na = 1\n  lenght = 1\n", [](const Table& t) { t.number("length"); },
      "3:3: length: missing, did you mean 'lenght'?");
  check_error(
      "[t]\na = 1\nlenght = 1\n", [](const Table& t) { t.table("t").number("length"); },
      "3:1: t.length: missing, did you mean 'lenght'?");
  const auto read = [](const Table& t) {
    t.number("length");
    if (t.has("gravity")) t.number("gravity");
    t.reject_unknown_keys();
  };
  check_error("length = 1\ngravty = 2\n", read,
              "2:1: gravty: unknown key, did you mean 'gravity'?");
  check_error("length = 1\nmass = 2\n", read, "2:1: mass: unknown key");
  // A key that stands there too is no misspelling of another one.
  check_error("length = 1\nlength2 = 2\n", read, "2:1: length2: unknown key");
}

BOOST_AUTO_TEST_CASE(an_array_of_tables_is_read_in_its_order) {
  const TemporaryFolder folder;
  const auto table =
      Table::parse_file(folder.write("case.toml", "[[t]]\nn = 1\n[[t]]\nn = 2\n[[t.u]]\nm = 3\n"));

  const auto tables = table.tables("t");

  BOOST_REQUIRE(tables.size() == 2);
  BOOST_TEST(tables[1].integer("n") == 2);
  BOOST_REQUIRE(tables[1].tables("u").size() == 1);
  BOOST_TEST(tables[1].tables("u")[0].integer("m") == 3);
  BOOST_TEST(tables[0].tables("u").empty());
}

BOOST_AUTO_TEST_CASE(errors_within_an_array_of_tables_have_their_place) {
  const auto read = [](const Table& table) {
    for (const Table& t : table.tables("t")) {
      t.integer("n");
      for (const Table& u : t.tables("u")) u.integer("m");
    }
    table.reject_unknown_keys();
  };

  check_error("[[t]]\nn = 1\n[[t]]\nn = 'x'\n", read, "4:5: t.n: must be an integer");
  check_error("[[t]]\nn = 1\n[[t]]\n", read, "3:1: t.n: missing");
  check_error("[[t]]\nn = 1\nk = 2\n", read, "3:1: t.k: unknown key");
  check_error("[[t]]\nn = 1\n[[t.u]]\nm = 1\nk = 2\n", read, "5:1: t.u.k: unknown key");
  check_error("[[v]]\nn = 1\n", read, "1:3: v: unknown key");
  check_error("t = [1]\n", read, "1:5: t: must be an array of tables");
  check_error("t = 1\n", read, "1:5: t: must be an array of tables, not an integer");
}

BOOST_AUTO_TEST_CASE(an_array_of_strings_names_the_element_that_is_none) {
  const TemporaryFolder folder;
  const auto table = Table::parse_file(folder.write("case.toml", "s = ['a', \"b\"]\n"));
  const auto read = [](const Table& t) { t.texts("s"); };

  BOOST_TEST((table.texts("s") == std::vector<std::string>{"a", "b"}));
  check_error("s = ['a',\n  2]\n", read, "2:3: s: must be a string, not an integer");
  check_error("s = 'a'\n", read, "1:5: s: must be an array of strings, not a string");
}

BOOST_AUTO_TEST_CASE(files_say_the_same_whatever_their_comments_and_layout) {
  BOOST_TEST(config::say_the_same("a = 1\nb = [2, 3]\n", "# both\nb = [2,\n  3]  # more\na = 1"));
  BOOST_TEST(!config::say_the_same("a = 1\n", "a = 2\n"));
  BOOST_TEST(!config::say_the_same("a = 1\n", "a = 1\nb = 1\n"));
  BOOST_TEST(!config::say_the_same("a = ", "a = "));
}

BOOST_AUTO_TEST_CASE(an_instant_counts_its_offset) {
  const TemporaryFolder folder;
  const auto table = Table::parse_file(
      folder.write("case.toml", "utc = 2027-01-15T22:59:01Z\nlocal = 2027-01-15T23:59:01+01:00\n"));

  BOOST_TEST(table.instant("utc").time_since_epoch().count() == 1800053941);
  BOOST_CHECK(table.instant("utc") == table.instant("local"));
}

BOOST_AUTO_TEST_CASE(an_instant_without_offset_is_none) {
  const auto read = [](const Table& t) { t.instant("d"); };

  check_error("d = 2027-01-15T23:59:00\n", read, "1:5: d: must be a date and time with offset");
  check_error("d = 2027-01-15\n", read, "1:5: d: must be a date and time with offset");
  check_error("d = 'now'\n", read, "1:5: d: must be a date and time with offset");
}

BOOST_AUTO_TEST_CASE(a_place_is_that_of_the_value) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.toml", "\na = 1\n");

  BOOST_TEST(Table::parse_file(file).place("a") == file.string() + ":2:5");
}

BOOST_AUTO_TEST_CASE(a_pipe_is_read_as_a_file_is) {
  const TemporaryFolder folder;
  const std::string pipe = (folder / "pipe").string();
  BOOST_REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::thread writer([&] { std::ofstream(pipe) << "a = 31\n"; });

  // A reader that never opens the pipe would leave the writer waiting for ever.
  const int kept_open = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  writer.join();
  std::thread closer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::close(kept_open);
  });
  double read = 0;
  BOOST_CHECK_NO_THROW(read = Table::parse_file(pipe).number("a"));
  closer.join();

  BOOST_TEST(read == 31);
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_named) {
  BOOST_CHECK_EXCEPTION(Table::parse_file("no such file.toml"), Error, [](const Error& e) {
    return std::string(e.what()) == "no such file.toml: cannot be read";
  });
  BOOST_CHECK_THROW(Table::parse_file(TemporaryFolder().path()), Error);
}

BOOST_AUTO_TEST_SUITE_END()
