// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a report as `make report` does, in a folder of its own, and reads its PDF.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "program.hpp"

/// One report: where it is made, and from which case.
struct Report {
  std::filesystem::path case_file;
  std::filesystem::path folder;
  std::filesystem::path document = source_dir / "report";

  std::filesystem::path generated() const { return folder / "generated"; }
  std::filesystem::path pdf() const { return folder / "report.pdf"; }

  Words typesetting() const {
    return {"typeset",
            "--document",
            document.string(),
            "--generated",
            generated().string(),
            "--build",
            (folder / "latex").string(),
            "--output",
            pdf().string()};
  }

  /// Writes the manifest; `more` are further flags.
  Outcome make_manifest(const Words& more = {}, const Surroundings& surroundings = {}) const {
    return run_program(typesetting() +
                           Words{"--manifest", (folder / "manifest.json").string(), "--case",
                                 case_file.string(), "--source", document.parent_path().string()} +
                           more,
                       surroundings);
  }
  std::string manifest() const { return sys::read_file(folder / "manifest.json"); }

  void make(const Surroundings& surroundings = {}) const {
    const Outcome computed = run_program({"compute", "--case", case_file.string(), "--output",
                                          generated().string(), "--source", source_dir.string()},
                                         surroundings);
    BOOST_TEST_REQUIRE(computed.status == 0, computed.errors);
    const Outcome drawn = run_program(drawing(generated()), surroundings);
    BOOST_TEST_REQUIRE(drawn.status == 0, drawn.errors);
    const Outcome typeset = run_program(typesetting(), surroundings);
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
