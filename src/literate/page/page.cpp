// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include "literate/page/expansion.hpp"
#include "literate/page/html_text.hpp"
#include "literate/prose/document_files.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="UTF-8">
<title>{0}</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="description" content="{1}">
<!--lit:meta-->
<!--lit:style-->
<!--lit:script-->
</head>
<body>
<a class="lit-skip" href="#main">Skip to the text</a>
{2}</main>
<!--lit:data-->
</body>
</html>
)";

std::string marks_lua(const std::vector<PageMark>& marks) {
  // A string of JSON is one of Lua, but for characters beyond ASCII, which both take as they are.
  const auto quoted = [](const std::string& text) { return nlohmann::json(text).dump(); };
  std::string lua = "return {\n";
  for (const PageMark& mark : marks) {
    lua += fmt::format("{{open={}, close={}, plain={}, language={}, first={}}},\n",
                       quoted(mark.open), quoted(mark.close), mark.is_plain,
                       mark.language.empty() ? "nil" : quoted(mark.language), mark.first_line);
  }
  return lua + "}\n";
}

// The command or the beginning of the environment.
std::string command_of(const std::string& latex) {
  TexScanner piece(latex);
  const auto token = piece.next();
  return token ? std::string(token->text) : latex;
}

// What the filter said of LaTeX that pandoc does not know, with the place where the document has
// it.
std::vector<std::string> complaints(const std::string& said, const Expanded& document,
                                    const fs::path& folder) {
  constexpr std::string_view unknown = "unknown: ", formula = "formula: ";
  std::vector<std::string> errors;
  for (const std::string_view line : sys::lines_of(said)) {
    std::string place = source_label(folder);
    if (line.starts_with(unknown)) {
      const std::string command = command_of(std::string(line.substr(unknown.size())));
      const auto known = document.commands.find(command);
      if (known != document.commands.end()) place = known->second;
      errors.push_back(fmt::format("{}: {} is not known to the page", place, command));
    } else if (line.starts_with(formula)) {
      const std::string text(line.substr(formula.size())), bare = without_blanks(text);
      for (const auto& [latex, known] : document.formulas) {
        if (bare.find(latex) != bare.npos && !latex.empty()) place = known;
      }
      errors.push_back(fmt::format("{}: pandoc cannot read the formula {}", place, text));
    }
  }
  return errors;
}

std::string run_pandoc(const PageSources& sources, const Expanded& document, Page& page) {
  const fs::path build = fs::absolute(sources.build);
  sys::write_if_changed(build / "page.tex", document.latex);
  sys::write_if_changed(build / "marks.lua", marks_lua(document.marks));
  const sys::ProcessResult result = sys::run(
      {.program = "pandoc",
       .arguments = {"--from=latex+raw_tex", "--to=html5", "--mathml", "--wrap=none",
                     "--section-divs", "--shift-heading-level-by=1",
                     "--lua-filter=" + (fs::absolute(sources.engine) / "filter.lua").string(),
                     "--output=pandoc.html", "page.tex"},
       .working_directory = build,
       .environment = {{"LITERATE_MARKS", (build / "marks.lua").string()}},
       .limit = {.what = "pandoc on page.tex", .seconds = 60}});
  if (result.exit_status != 0) {
    throw sys::ToolError("pandoc failed (" + sys::end_of(result) + "):\n" + result.output);
  }
  page.errors = complaints(result.output, document, sources.document);
  return sys::read_file(build / "pandoc.html");
}

// The text between two pieces of HTML; empty if they are not there.
std::string_view between(std::string_view html, std::string_view open, std::string_view close) {
  const auto begin = html.find(open);
  if (begin == html.npos) return {};
  html.remove_prefix(begin + open.size());
  return html.substr(0, html.find(close));
}

// A drawing is told by the caption of its figure.
std::string with_captions(std::string html) {
  constexpr std::string_view wanted = "@alt@";
  for (auto at = html.find(wanted); at != html.npos; at = html.find(wanted, at)) {
    const auto figure = html.rfind("<figure", at);
    const auto end = html.find("</figure>", at);
    std::string caption;
    if (figure != html.npos && html.find("</figure>", figure) == end) {
      caption = text_of_html(between(std::string_view(html).substr(figure, end - figure),
                                     "<figcaption>", "</figcaption>"));
    }
    html.replace(at, wanted.size(), caption.empty() ? "" : escape_html(caption) + " – ");
  }
  return html;
}

// A head of nothing but a formula has no name for a screen reader.
std::string with_named_heads(std::string html) {
  constexpr std::string_view math = "\"><math ";
  for (auto at = html.find(math); at != html.npos; at = html.find(math, at + 1)) {
    if (html.rfind("<th", at) != html.rfind('<', at)) continue;
    const std::string name =
        text_of_html(std::string_view(html).substr(at + 2, html.find("</math>", at) - at - 2));
    html.insert(at + math.size(), "aria-label=\"" + name + "\" ");
  }
  return html;
}

}  // namespace

Page write_page(const PageSources& sources) {
  Expanded document = Expander(sources).expand();
  Page page;
  std::string body = run_pandoc(sources, document, page);
  page.errors.insert(page.errors.begin(), document.errors.begin(), document.errors.end());
  body = with_captions(with_named_heads(std::move(body)));
  page.title = text_of_html(
      boost::replace_all_copy(std::string(between(body, "<h1>", "</h1>")), "<br />", " "));
  // Their names stand in comments, for the citation.
  constexpr std::string_view author = "<!--lit:author ";
  for (auto at = body.find(author); at != body.npos; at = body.find(author, at)) {
    const std::string_view name = between(std::string_view(body).substr(at), author, "-->");
    page.authors.push_back(text_of_html(name));
    body.erase(at, author.size() + name.size() + 3);
  }
  page.date = text_of_html(between(body, "<p class=\"lit-date\">", "</p>"));
  const std::string_view abstract = between(body, "<section class=\"lit-abstract\"", "</section>");
  page.description = text_of_html(between(abstract, "<p>", "</p>"));
  page.html = fmt::format(head, escape_html(page.title), escape_html(page.description), body);
  page.figures = document.figures;
  page.pictures = document.pictures;
  page.typeset = document.typeset;
  return page;
}

}  // namespace literate
