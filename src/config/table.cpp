// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/table.hpp"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <cmath>
#include <map>
#include <sstream>

#include "system/files.hpp"
#include "system/text.hpp"

namespace config {
namespace {

std::string place_in(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

std::string type_name(const toml::node& node) {
  std::ostringstream name;
  name << node.type();  // such as «floating-point»
  return name.str();
}

}  // namespace

// One table of a file. All tables of a file share the document and the record of the keys that were
// read.
struct Table::Node {
  struct Document {
    std::string file;
    toml::table root;
    std::map<std::string, std::set<std::string>>
        read_keys;  // of each table, by its path; some are missing
  };
  std::shared_ptr<Document> document;
  const toml::table* table;
  std::string path;  // the keys from the root to this table, joined by dots

  std::string path_of(const std::string& key) const {
    return path.empty() ? key : path + "." + key;
  }

  bool is_read(const std::string& key) const { return document->read_keys[path].contains(key); }

  [[noreturn]] void fail(const toml::source_region& source, const std::string& key,
                         const std::string& message) const {
    throw Error(fmt::format("{}: {}: {}", place_in(document->file, source), path_of(key), message));
  }

  const toml::node& get(const std::string& key) const {
    document->read_keys[path].insert(key);
    const toml::node* node = table->get(key);
    if (node == nullptr) fail_missing(key);
    return *node;
  }

  /// If the key is misspelt, the error has the place of the misspelt key.
  [[noreturn]] void fail_missing(const std::string& key) const {
    std::set<std::string> unknown;
    for (const auto& [other, node] : *table) {
      if (!is_read(std::string(other.str()))) unknown.emplace(other.str());
    }
    const auto nearest = sys::nearest_name(key, unknown);
    if (!nearest) fail(table->source(), key, "missing");
    fail(table->get(*nearest)->source(), key, fmt::format("missing; is '{}' misspelt?", *nearest));
  }

  /// The keys that were read but do not exist.
  std::set<std::string> missing_keys() const {
    std::set<std::string> keys = document->read_keys[path];
    std::erase_if(keys, [this](const std::string& key) { return table->contains(key); });
    return keys;
  }

  [[noreturn]] void wrong_type(const toml::node& node, const std::string& key,
                               const std::string& expected) const {
    fail(node.source(), key, fmt::format("must be {}, not {}", expected, type_name(node)));
  }

  double number_at(const toml::node& node, const std::string& key) const {
    const auto number = node.value<double>();
    if (!node.is_number() || !number) wrong_type(node, key, "a number");
    if (!std::isfinite(*number)) {
      fail(node.source(), key, fmt::format("{}: must be a finite number", *number));
    }
    return *number;
  }

  std::string text_at(const toml::node& node, const std::string& key) const {
    const auto text = node.value_exact<std::string>();
    if (!text) wrong_type(node, key, "a string");
    return *text;
  }
};

Table Table::parse_file(const std::filesystem::path& path) {
  auto document = std::make_shared<Node::Document>();
  document->file = path.string();
  try {
    document->root = toml::parse(sys::read_file(path), document->file);
  } catch (const toml::parse_error& e) {
    throw Error(
        fmt::format("{}: {}", place_in(document->file, e.source()), std::string(e.description())));
  } catch (const sys::OutputError& e) {
    throw Error(e.what());
  }
  const toml::table* root = &document->root;
  return Table(std::make_shared<Node>(Node{std::move(document), root, ""}));
}

bool Table::has(const std::string& key) const {
  node_->document->read_keys[node_->path].insert(key);
  return node_->table->contains(key);
}

std::vector<std::string> Table::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, node] : *node_->table) keys.emplace_back(key.str());
  return keys;
}

Table Table::table(const std::string& key) const {
  const toml::node& node = node_->get(key);
  const toml::table* table = node.as_table();
  if (table == nullptr) node_->wrong_type(node, key, "a table");
  return Table(std::make_shared<Node>(Node{node_->document, table, node_->path_of(key)}));
}

std::string Table::text(const std::string& key) const {
  return node_->text_at(node_->get(key), key);
}

std::vector<std::string> Table::texts(const std::string& key) const {
  const toml::node& node = node_->get(key);
  const toml::array* array = node.as_array();
  if (array == nullptr) node_->wrong_type(node, key, "an array of strings");
  std::vector<std::string> texts;
  for (const toml::node& element : *array) texts.push_back(node_->text_at(element, key));
  return texts;
}

double Table::number(const std::string& key) const {
  return node_->number_at(node_->get(key), key);
}

long Table::integer(const std::string& key) const {
  const toml::node& node = node_->get(key);
  const auto integer = node.value_exact<std::int64_t>();
  if (!integer) node_->wrong_type(node, key, "an integer");
  return static_cast<long>(*integer);
}

double Table::quantity(const std::string& key, Dimension dimension, const UnitSystem& units) const {
  return quantity(key, units.unit(dimension));
}

double Table::quantity(const std::string& key, const std::string& unit) const {
  const toml::node& node = node_->get(key);
  if (node.as_table() == nullptr) {
    node_->wrong_type(node, key,
                      fmt::format("a quantity such as {{value = 1.0, unit = \"{}\"}}", unit));
  }
  const Table given = table(key);
  const double number = given.number("value");
  return given.at("unit", [&] { return converted(number, given.text("unit"), unit); });
}

bool Table::is_text(const std::string& key, const std::string& text) const {
  return has(key) && node_->get(key).value_exact<std::string>() == text;
}

void Table::reject_unknown_keys(const std::set<std::string>& left_to_others) const {
  for (const auto& [key, node] : *node_->table) {
    const std::string name(key.str());
    if (left_to_others.contains(name)) continue;
    if (!node_->is_read(name)) {
      node_->fail(key.source(), name, "unknown key" + sys::suggestion(name, node_->missing_keys()));
    }
    if (node.is_table()) table(name).reject_unknown_keys();
  }
}

std::string Table::place(const std::string& key) const {
  const toml::node* node = node_->table->get(key);
  return place_in(node_->document->file, node != nullptr ? node->source() : node_->table->source());
}

void Table::fail(const std::string& key, const std::string& message) const {
  throw Error(fmt::format("{}: {}: {}", place(key), node_->path_of(key), message));
}

}  // namespace config
