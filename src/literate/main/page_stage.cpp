// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "literate/deposit/citation.hpp"
#include "literate/document/names.hpp"
#include "literate/main/stages.hpp"
#include "literate/page/citation_tags.hpp"
#include "literate/page/one_file.hpp"
#include "literate/page/page.hpp"
#include "literate/page/page_data.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

using command_line::complain;
using command_line::ExitCode;

struct WriteOptions {
  std::string document, main_file, generated, repository, build, aux, engine, record;
};

struct EmbedOptions {
  std::string document, generated, build, look, output;
  std::string citation_file, site, bibtex_file, beside;
};

// The PDF, whose numbers the page takes, must be of the same text.
void require_same_state(const std::string& record) {
  if (record.empty()) return;
  if (!fs::is_regular_file(record)) {
    throw sys::InputError("the PDF, whose numbers the page takes, is not made yet");
  }
  const std::string text = sys::read_file(record);
  for (const std::string_view line : sys::lines_of(text)) {
    const auto blank = line.find("  ");
    const std::string file(line.substr(std::min(blank + 2, line.size())));
    if (!file.ends_with(".tex") && !file.ends_with(".sha256")) continue;
    if (fs::is_regular_file(file) && sys::sha256_of_file(file) == line.substr(0, blank)) continue;
    throw sys::InputError(
        fmt::format("'{}' is not as it was when the PDF was made: make the PDF again", file));
  }
}

std::string lines_of(std::vector<std::string> names) {
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  return text;
}

ExitCode write(const WriteOptions& options) {
  const fs::path generated = options.generated;
  const fs::path build = options.build;
  fs::create_directories(build);
  require_same_state(options.record);
  PageSources sources{.document = options.document,
                      .main_file = options.main_file,
                      .generated = generated,
                      .aux = options.aux,
                      .engine = options.engine,
                      .build = build,
                      .known = sys::read_file(fs::path(options.engine) / "known.tex"),
                      .repository = {}};
  const fs::path repository = fs::path(options.repository) / "repository.tex";
  if (fs::is_regular_file(repository)) sources.repository = sys::read_file(repository);
  const Page page = write_page(sources);
  for (const std::string& error : page.errors) complain(error, ExitCode::bad_input);
  if (!page.errors.empty()) return ExitCode::bad_input;
  sys::write_if_changed(build / "page.html", page.html);
  sys::write_if_changed(build / "page.json", nlohmann::json{{"title", page.title},
                                                            {"authors", page.authors},
                                                            {"date", page.date},
                                                            {"description", page.description}}
                                                 .dump());
  std::string typeset;
  for (const std::string& picture : page.typeset) {
    typeset += "\\begin{LiteratePage}%\n" + picture + "%\n\\end{LiteratePage}\n";
  }
  sys::write_if_changed(build / "typeset.txt", typeset);
  sys::write_if_changed(build / "figures.txt", lines_of(page.figures));
  sys::write_if_changed(build / "pictures.txt", lines_of(page.pictures));
  return ExitCode::success;
}

// The parts of a text between separators, without the blanks before them.
std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream >> std::ws, part, separator);) parts.push_back(part);
  return parts;
}

// Authors as the page prints them, between commas; those of a CITATION.cff are told one by one.
PageCitation citation_of(const EmbedOptions& options) {
  const nlohmann::json page =
      nlohmann::json::parse(sys::read_file(fs::path(options.build) / "page.json"));
  PageCitation citation{.title = page.at("title"),
                        .authors = {},
                        .date = page.at("date"),
                        .description = page.at("description"),
                        .site = options.site,
                        .pdf = options.beside.substr(0, options.beside.find(':'))};
  if (!options.citation_file.empty() && fs::is_regular_file(options.citation_file)) {
    const Citation file = read_citation(options.citation_file);
    for (const Author& author : file.authors) citation.authors.push_back(author.name);
    citation.doi = file.doi;
  } else {
    citation.authors = parts_of(page.at("authors").get<std::string>(), ',');
  }
  return citation;
}

ExitCode embed(const EmbedOptions& options) {
  const PageCitation citation = citation_of(options);
  const std::string html = one_file(
      sys::read_file(fs::path(options.build) / "page.html"),
      {.look = options.look,
       .data = page_data(options.document, options.generated, fs::path(options.build) / "plotted"),
       .meta = citation_tags(citation),
       .bibtex = bibtex_entry(citation),
       .beside = parts_of(options.beside, ':'),
       .build = options.build});
  if (!options.bibtex_file.empty()) {
    sys::write_file_atomically(options.bibtex_file, bibtex_entry(citation));
  }
  sys::write_file_atomically(options.output, html);
  // As of the PDF: the page is made, since it is where one looks for the cause.
  return command_line::answer_faults(read_names(fs::path(options.generated) / "names.json").faults);
}

}  // namespace

void add_page_stage(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(program, "page", "Write the document as a page, without its figures and fonts",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<WriteOptions>();
                add_required_text(command, "--document", options->document, "DIR",
                                  "Folder of the LaTeX document");
                add_required_text(command, "--main", options->main_file, "FILE", "Its main file");
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `compute` and `draw` wrote");
                add_required_text(command, "--repository", options->repository, "DIR",
                                  "Folder with the state of the repository, repository.tex");
                add_required_text(command, "--aux", options->aux, "FILE",
                                  "The .aux file of the PDF, with all its numbers");
                add_required_text(command, "--engine", options->engine, "DIR",
                                  "Folder with the filter for pandoc");
                add_text(command, "--record", options->record, "FILE",
                         "Record of what the PDF was made from; refuse what was changed since");
                add_required_text(
                    command, "--build", options->build, "DIR",
                    "Folder for page.html, the lists figures.txt and pictures.txt, and "
                    "typeset.txt for LaTeX");
                return [options] { return write(*options); };
              });
  add_command(
      program, "embed", "Put style, script, data, figures and fonts into the page", exit_code,
      [](CLI::App& command) {
        auto options = std::make_shared<EmbedOptions>();
        add_required_text(command, "--build", options->build, "DIR",
                          "Folder with page.html, figures, pictures and fonts");
        add_required_text(command, "--look", options->look, "DIR",
                          "Folder with style sheets and scripts");
        add_required_text(command, "--document", options->document, "DIR",
                          "Folder of the LaTeX document");
        add_required_text(command, "--generated", options->generated, "DIR",
                          "Folder that `compute` and `draw` wrote");
        add_required_text(command, "--output", options->output, "FILE", "The page");
        add_text(command, "--citation", options->citation_file, "FILE",
                 "CITATION.cff, whose authors are the page's; none if there is no such file");
        add_text(command, "--site", options->site, "URL", "Address at which the page will stand");
        add_text(command, "--beside", options->beside, "FILES",
                 "Files beside the page there, which it links, between colons; the PDF first");
        add_text(command, "--bibtex", options->bibtex_file, "FILE",
                 "Where the entry for BibTeX is written, too");
        return [options] { return embed(*options); };
      });
}

}  // namespace literate
