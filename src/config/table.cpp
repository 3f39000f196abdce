// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/table.hpp"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "system/nearest_name.hpp"
#include "system/text.hpp"

namespace config {
namespace {

std::string place_in(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::string in_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    constexpr unsigned char first_printable = 0x20;
    constexpr unsigned char del = 0x7f;
    if (c == '\n') {
      line += "\\n";
    } else if (byte < first_printable || byte == del) {
      line += fmt::format("\\x{:02x}", byte);
    } else {
      line += c;
    }
  }
  return line;
}

}  // namespace

Error::Error(const std::string& message) : InputError(in_one_line(message)) {}

bool say_the_same(const std::string& a, const std::string& b) {
  try {
    return toml::parse(a) == toml::parse(b);
  } catch (const toml::parse_error&) {
    return false;
  }
}

// One table of a file. All tables of a file share the document and the record of the keys that were
// asked for.
struct Table::Node {
  struct Document {
    std::string file;
    toml::table root;
    std::set<const toml::node*> asked_for;
    std::map<std::string, std::set<std::string>> asked_names;  // of each table, by its path
  };
  std::shared_ptr<Document> document;
  const toml::table* table;
  std::string path;  // the keys that lead here, joined by dots; empty for the root

  std::string path_of(const std::string& key) const {
    return path.empty() ? key : path + "." + key;
  }

  const toml::node& get(const Table& self, const std::string& key) const {
    document->asked_names[path].insert(key);
    const toml::node* node = table->get(key);
    if (node == nullptr) fail_missing(self, key);
    document->asked_for.insert(node);
    return *node;
  }

  /// A key that may be misspelt is told at its own place.
  [[noreturn]] void fail_missing(const Table& self, const std::string& key) const {
    const auto nearest = sys::nearest_name(key, unknown_keys());
    for (const auto& [other, node] : *table) {
      if (other.str() != nearest) continue;
      throw Error(fmt::format("{}: {}: missing, did you mean '{}'?",
                              place_in(document->file, other.source()), path_of(key), *nearest));
    }
    self.fail(key, "missing");
  }

  /// The keys that nobody has asked for so far.
  std::set<std::string> unknown_keys() const {
    std::set<std::string> keys;
    for (const auto& [key, node] : *table) {
      if (!document->asked_for.contains(&node)) keys.emplace(key.str());
    }
    return keys;
  }

  /// The names that were asked for and are not there.
  std::set<std::string> missing_keys() const {
    std::set<std::string> keys = document->asked_names[path];
    std::erase_if(keys, [this](const std::string& key) { return table->contains(key); });
    return keys;
  }

  /// The finite number that stands at a node.
  double number_at(const toml::node& node, const std::string& key) const {
    const auto refuse = [&](const std::string& message) {
      throw Error(fmt::format("{}: {}: {}", place_in(document->file, node.source()), path_of(key),
                              message));
    };
    if (!node.is_number()) refuse("must be a number, not " + type_name(node));
    if (const auto integer = node.value_exact<std::int64_t>()) {
      constexpr std::int64_t most = std::int64_t{1} << std::numeric_limits<double>::digits;
      if (*integer > most || *integer < -most) {
        refuse(fmt::format("{}: a number holds no integer beyond 2^53 = {}", *integer, most));
      }
      return static_cast<double>(*integer);
    }
    const double number = *node.value_exact<double>();
    if (!std::isfinite(number)) refuse(fmt::format("{}: must be a finite number", number));
    return number;
  }

  [[noreturn]] void wrong_type(const Table& self, const std::string& key,
                               const std::string& wanted) const {
    self.fail(key, fmt::format("must be {}, not {}", wanted, type_name(*table->get(key))));
  }
};

Table Table::parse_file(const std::filesystem::path& path) {
  auto document = std::make_shared<Node::Document>();
  document->file = path.string();
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  const bool is_empty = stream && stream.peek() == std::ifstream::traits_type::eof();
  // A pipe, as of «<(…)», is read as a file is.
  if (std::filesystem::is_directory(path) || !(is_empty || text << stream.rdbuf())) {
    throw Error(fmt::format("{}: cannot be read", document->file));
  }
  try {
    document->root = toml::parse(text.str(), document->file);
  } catch (const toml::parse_error& e) {
    throw Error(
        fmt::format("{}: {}", place_in(document->file, e.source()), std::string(e.description())));
  }
  auto node = std::make_shared<Node>();
  node->table = &document->root;
  node->document = std::move(document);
  return Table(std::move(node));
}

bool Table::has(const std::string& key) const {
  node_->document->asked_names[node_->path].insert(key);
  return node_->table->contains(key);
}

Table Table::table(const std::string& key) const {
  const toml::table* table = node_->get(*this, key).as_table();
  if (table == nullptr) node_->wrong_type(*this, key, "a table");
  return Table(std::make_shared<Node>(Node{node_->document, table, node_->path_of(key)}));
}

std::vector<Table> Table::tables(const std::string& key) const {
  if (!has(key)) return {};
  const toml::array* array = node_->get(*this, key).as_array();
  if (array == nullptr || !array->is_array_of_tables()) {
    node_->wrong_type(*this, key, "an array of tables");
  }
  std::vector<Table> tables;
  for (const toml::node& element : *array) {
    tables.push_back(Table(
        std::make_shared<Node>(Node{node_->document, element.as_table(), node_->path_of(key)})));
  }
  return tables;
}

std::string Table::text(const std::string& key) const {
  const auto text = node_->get(*this, key).value_exact<std::string>();
  if (!text) node_->wrong_type(*this, key, "a string");
  return *text;
}

std::vector<std::string> Table::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, node] : *node_->table) keys.emplace_back(key.str());
  return keys;
}

bool Table::is_text(const std::string& key, const std::string& text) const {
  return has(key) && node_->get(*this, key).value_exact<std::string>() == text;
}

double Table::number(const std::string& key) const {
  return node_->number_at(node_->get(*this, key), key);
}

std::vector<double> Table::numbers(const std::string& key) const {
  const toml::array* array = node_->get(*this, key).as_array();
  if (array == nullptr) node_->wrong_type(*this, key, "an array of numbers");
  std::vector<double> numbers;
  for (const toml::node& element : *array) numbers.push_back(node_->number_at(element, key));
  return numbers;
}

long Table::integer(const std::string& key) const {
  const auto integer = node_->get(*this, key).value_exact<std::int64_t>();
  if (!integer) node_->wrong_type(*this, key, "an integer");
  return static_cast<long>(*integer);
}

double Table::quantity(const std::string& key, Dimension dimension, const UnitSystem& units) const {
  return quantity(key, units.unit(dimension));
}

double Table::quantity(const std::string& key, const std::string& unit) const {
  const std::string wanted = fmt::format("a quantity such as {{value = 1.0, unit = \"{}\"}}", unit);
  if (node_->get(*this, key).as_table() == nullptr) node_->wrong_type(*this, key, wanted);
  const Table given = table(key);
  const double number = given.number("value");
  return given.at("unit", [&] { return converted(number, given.text("unit"), unit); });
}

std::vector<double> Table::quantities(const std::string& key, const std::string& unit) const {
  if (node_->get(*this, key).as_table() == nullptr) {
    node_->wrong_type(
        *this, key, fmt::format("quantities such as {{value = [1.0, 2.0], unit = \"{}\"}}", unit));
  }
  const Table given = table(key);
  std::vector<double> quantities = given.numbers("value");
  for (double& number : quantities) {
    number = given.at("unit", [&] { return converted(number, given.text("unit"), unit); });
  }
  return quantities;
}

PrintedNumber Table::printed_number(const std::string& key) const {
  try {
    return PrintedNumber(text(key));
  } catch (const std::invalid_argument& e) {
    fail(key, e.what());
  }
}

std::vector<PrintedNumber> Table::printed_numbers(const std::string& key) const {
  const std::string wanted = "an array of decimal numbers in quotes, which keep their digits";
  const toml::array* array = node_->get(*this, key).as_array();
  if (array == nullptr) node_->wrong_type(*this, key, wanted);
  std::vector<PrintedNumber> numbers;
  for (const toml::node& element : *array) {
    const auto text = element.value_exact<std::string>();
    if (!text) fail(key, "must be " + wanted);
    try {
      numbers.emplace_back(*text);
    } catch (const std::invalid_argument& e) {
      throw Error(fmt::format("{}: {}: {}", place_in(node_->document->file, element.source()),
                              node_->path_of(key), e.what()));
    }
  }
  return numbers;
}

std::vector<std::string> Table::texts(const std::string& key) const {
  const toml::array* array = node_->get(*this, key).as_array();
  if (array == nullptr) node_->wrong_type(*this, key, "an array of strings");
  std::vector<std::string> texts;
  for (const toml::node& element : *array) {
    const auto text = element.value_exact<std::string>();
    if (!text) {
      throw Error(fmt::format("{}: {}: must be a string, not {}",
                              place_in(node_->document->file, element.source()),
                              node_->path_of(key), type_name(element)));
    }
    texts.push_back(*text);
  }
  return texts;
}

std::chrono::sys_seconds Table::instant(const std::string& key) const {
  const std::string wanted = "a date and time with offset such as 2027-01-15T23:59:00Z";
  const auto given = node_->get(*this, key).value_exact<toml::date_time>();
  if (!given) node_->wrong_type(*this, key, wanted);
  if (!given->offset) fail(key, "must be " + wanted + ", not one without offset");
  using namespace std::chrono;
  return sys_days(year(given->date.year) / month(given->date.month) / day(given->date.day)) +
         hours(given->time.hour) + minutes(given->time.minute - given->offset->minutes) +
         seconds(given->time.second);
}

void Table::reject_unknown_keys(const std::set<std::string>& left_to_others) const {
  for (const auto& [key, node] : *node_->table) {
    const std::string name(key.str());
    if (left_to_others.contains(name)) continue;
    if (!node_->document->asked_for.contains(&node)) {
      throw Error(fmt::format("{}: {}: unknown key{}",
                              place_in(node_->document->file, key.source()), node_->path_of(name),
                              sys::suggestion(name, node_->missing_keys())));
    }
    if (node.is_table()) table(name).reject_unknown_keys();
    if (!node.is_array_of_tables()) continue;
    for (const Table& element : tables(name)) element.reject_unknown_keys();
  }
}

std::string Table::place(const std::string& key) const {
  const toml::node* node = node_->table->get(key);
  const toml::source_region& source = node != nullptr ? node->source() : node_->table->source();
  return place_in(node_->document->file, source);
}

void Table::fail(const std::string& key, const std::string& message) const {
  throw Error(fmt::format("{}: {}: {}", place(key), node_->path_of(key), message));
}

}  // namespace config
