// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a report as `make report` does, in a folder of its own, and reads its PDF.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "program.hpp"

/// One report: where it is made, and from which case.
struct Report : ReportSettings {
  std::string manifest() const { return sys::read_file(output / "manifest.json"); }

  void make(const Surroundings& surroundings = {}) const {
    const Outcome computed = run_program(stage("compute"), surroundings);
    BOOST_TEST_REQUIRE(computed.status == 0, computed.errors);
    const Outcome drawn = run_program(stage("draw"), surroundings);
    BOOST_TEST_REQUIRE(drawn.status == 0, drawn.errors);
    const Outcome typeset = run_program(stage("typeset"), surroundings);
    BOOST_TEST_REQUIRE(typeset.status == 0, typeset.errors);
    BOOST_TEST(computed.errors == "");
    BOOST_TEST(typeset.errors == "");
  }

  /// The PDF as text, words and numbers with one plain blank between.
  std::string text() const {
    const auto read =
        sys::run({.program = "pdftotext", .arguments = {"-layout", pdf().string(), "-"}});
    BOOST_TEST_REQUIRE(read.exit_status == 0, read.output);
    std::string text = read.output;
    for (const auto& [special, plain] :
         {std::pair{"\u2212", "-"}, {"\u00a0", " "}, {"\u2009", " "}, {"\u202f", " "}}) {
      text = std::regex_replace(text, std::regex(special), plain);
    }
    return std::regex_replace(text, std::regex("[ \\n\\r\\f\\t]+"), " ");
  }

  /// What the prose prints for a value.
  std::string printed(const std::string& key) const {
    const auto names = nlohmann::json::parse(sys::read_file(generated() / "names.json"));
    return names.at("values").at(key).at("printed");
  }
};

inline bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
