// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "literate/deposit/citation.hpp"
#include "literate/document/names.hpp"
#include "literate/main/stages.hpp"
#include "literate/page/one_file.hpp"
#include "literate/page/page.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

using command_line::complain;
using command_line::ExitCode;

// What a page is told that stands on a site.
struct Site {
  std::string folder, address, beside;
};

// The PDF, whose numbers the page takes, must be of the same text.
void require_same_state(const fs::path& record) {
  const auto typeset = fs::is_regular_file(record) ? sys::parse_record(sys::read_file(record))
                                                   : std::optional<sys::Record>();
  if (!typeset) throw sys::InputError("the PDF, whose numbers the page takes, is not made yet");
  for (const sys::RecordEntry& entry : *typeset) {
    const bool is_read = entry.name.ends_with(".tex") || entry.name.ends_with(".sha256");
    if (!is_read || sys::is_as_recorded("/", entry)) continue;
    throw sys::InputError(
        fmt::format("'{}' is not as it was when the PDF was made: make the PDF again", entry.name));
  }
}

std::string lines_of(std::vector<std::string> names) {
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  return text;
}

ExitCode write(const Settings& settings) {
  const fs::path build = settings.page_folder();
  fs::create_directories(build);
  require_same_state(settings.record("typeset"));
  PageSources sources{.document = settings.document,
                      .main_file = settings.main_file,
                      .generated = settings.generated(),
                      .aux = settings.latex_folder() /
                             fs::path(settings.main_file).replace_extension(".aux").filename(),
                      .engine = settings.engine / "page",
                      .build = build,
                      .known = sys::read_file(settings.engine / "page/known.tex"),
                      .repository = {}};
  const fs::path repository = settings.repository / "repository.tex";
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

// Authors as the page prints them, unless a CITATION.cff names them.
PageCitation citation_of(const Settings& settings, const Site& site) {
  const nlohmann::json page =
      nlohmann::json::parse(sys::read_file(settings.page_folder() / "page.json"));
  PageCitation citation{.title = page.at("title"),
                        .authors = {},
                        .date = page.at("date"),
                        .description = page.at("description"),
                        .site = site.address,
                        .pdf = site.beside.substr(0, site.beside.find(':'))};
  if (fs::is_regular_file(settings.root / "CITATION.cff")) {
    const Citation file = read_citation(settings.root / "CITATION.cff");
    for (const Author& author : file.authors) citation.authors.push_back(author.name);
    citation.doi = file.doi;
  } else {
    citation.authors = page.at("authors");
  }
  return citation;
}

ExitCode embed(const Settings& settings, const Site& site) {
  const fs::path build = settings.page_folder();
  const PageCitation citation = citation_of(settings, site);
  const std::string html = one_file(sys::read_file(build / "page.html"),
                                    {.look = settings.engine / "page",
                                     .data = page_data(settings.generated(), build / "plotted"),
                                     .meta = citation_tags(citation),
                                     .bibtex = bibtex_entry(citation),
                                     .beside = sys::split(site.beside, ':'),
                                     .build = build});
  if (!site.folder.empty()) {
    sys::write_file_atomically(fs::path(site.folder) / (settings.name + "-citation.bib"),
                               bibtex_entry(citation));
  }
  sys::write_file_atomically(
      site.folder.empty() ? settings.page() : fs::path(site.folder) / "index.html", html);
  // As of the PDF: the page is made, since it is where one looks for the cause.
  return command_line::answer_faults(read_names(settings.generated() / "names.json").faults);
}

}  // namespace

void add_page_stages(CLI::App& program, ExitCode& exit_code) {
  using command_line::add_text;
  add_stage(program, exit_code, "page",
            "Write the document as a page, without its figures and fonts", write);
  const auto site = std::make_shared<Site>();
  add_stage(
      program, exit_code, "embed", "Put style, script, data, figures and fonts into the page",
      [site](const Settings& settings) { return embed(settings, *site); },
      [site](CLI::App& command) {
        add_text(command, "--site", site->folder, "DIR",
                 "Folder of a site, whose index.html the page becomes");
        add_text(command, "--address", site->address, "URL", "Where the site will stand");
        add_text(command, "--beside", site->beside, "FILES",
                 "Files beside the page there, which it links, between colons; the PDF first");
      });
}

}  // namespace literate
