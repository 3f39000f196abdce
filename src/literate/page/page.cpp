// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "literate/page/expansion.hpp"
#include "literate/page/html_text.hpp"
#include "literate/prose/document_files.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"
#include "system/process.hpp"

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

// Where the document asks for a piece of LaTeX that pandoc did not know.
std::string place_of(const Expanded& document, const fs::path& folder, const std::string& latex) {
  const auto known = document.commands.find(command_of(latex));
  return known == document.commands.end() ? source_label(folder) : known->second;
}

// What pandoc and the filter said.
std::vector<std::string> complaints(const std::string& said, const Expanded& document,
                                    const fs::path& folder) {
  constexpr std::string_view unknown = "unknown: ",
                             formula = "[WARNING] Could not convert TeX math ";
  std::vector<std::string> errors;
  const std::vector<std::string_view> lines = sys::lines_of(said);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i];
    if (line.starts_with(unknown)) {
      const std::string latex(line.substr(unknown.size()));
      errors.push_back(fmt::format("{}: {} is not known to the page",
                                   place_of(document, folder, latex), command_of(latex)));
    } else if (line.starts_with(formula)) {
      std::string text(line.substr(formula.size()));
      while (text.find(", rendering as TeX") == text.npos && i + 1 < lines.size()) {
        text += lines[++i];
      }
      text = text.substr(0, text.rfind(", rendering as TeX"));
      std::string reason;
      while (i + 1 < lines.size() && lines[i + 1].starts_with("  ")) reason = lines[++i];
      std::string bare = without_blanks(text);
      std::string place = source_label(folder);
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

// Where an element without attributes ends that begins at a place.
std::size_t end_of_element(std::string_view html, std::size_t at, const std::string& name) {
  const std::string open_tag = "<" + name + ">", close_tag = "</" + name + ">";
  for (int depth = 0;;) {
    const auto open = html.find(open_tag, at), close = html.find(close_tag, at);
    if (close == html.npos) return html.size();
    depth += open < close ? 1 : -1;
    at = open < close ? open + open_tag.size() : close + close_tag.size();
    if (depth == 0) return at;
  }
}

// Letters that TeX sets upright: those of \mathrm, as one word, and capital Greek ones.
std::string with_upright_letters(std::string html) {
  static const std::regex upright("<mstyle mathvariant=\"normal\">(.*?)</mstyle>"),
      greek("<mi>(Γ|Δ|Θ|Λ|Ξ|Π|Σ|Υ|Φ|Ψ|Ω)</mi>");
  std::string text;
  for (std::smatch found; std::regex_search(html, found, upright); html = found.suffix()) {
    const std::string one_word = boost::replace_all_copy(found[1].str(), "</mi><mi>", "");
    text += found.prefix().str() + "<mrow>" +
            boost::replace_all_copy(one_word, "<mi>", "<mi mathvariant=\"normal\">") + "</mrow>";
  }
  return std::regex_replace(text + html, greek, "<mi mathvariant=\"normal\">$1</mi>");
}

// The name of an operator, such as ln, has a thin space beside letters, numbers and bars, and none
// beside signs and parentheses, as in TeX; pandoc leaves it the spaces of a relation.
std::string with_operator_spaces(std::string html) {
  static const std::regex operator_name("<mo>[A-Za-z ]*</mo>"), scripts("<(m(?:su|un|ov)[a-z]*)>$"),
      letter_before("</m(?!o>)[a-z]+>$|form=\"postfix\">[^<]*</mo>$"),
      sign_behind("^(?:<mspace[^>]*></mspace>)*(?:<m[a-z]+>)*<mo[^>]*>(?![|∥A-Za-z<])|^</|^$");
  std::string text;
  for (std::smatch found; std::regex_search(html, found, operator_name);) {
    std::string before = text + found.prefix().str();
    std::string element = found[0].str(), behind = found.suffix().str();
    // With its limits or its exponent.
    if (std::smatch outer; std::regex_search(before, outer, scripts)) {
      const std::string tag = outer[0].str(), whole = tag + element + behind;
      const auto end = end_of_element(whole, 0, outer[1].str());
      behind = whole.substr(end);
      element = whole.substr(0, end);
      before.resize(before.size() - tag.size());
    }
    const auto space = [](bool is_thin) { return is_thin ? "0.167em" : "0em"; };
    const auto at = element.find("<mo>") + 3;
    element.insert(at, fmt::format(" lspace=\"{}\" rspace=\"{}\"",
                                   space(std::regex_search(before, letter_before)),
                                   space(!std::regex_search(behind, sign_behind))));
    const auto done = before.size() + element.find("</mo>", at);
    html = before + element + behind;
    text = html.substr(0, done);
    html.erase(0, done);
  }
  return text + html;
}

// A minus behind a relation, a comma or a parenthesis is that of a number, and stands close to it.
std::string with_signs(const std::string& html) {
  static const std::regex sign(
      "(<mo>(?:[=,:]|&lt;|&gt;|≤|≥|≈|≡|≠|∼|→)</mo>|form=\"prefix\">[^<]*</mo>)<mo>−</mo>");
  return std::regex_replace(html, sign, "$1<mo form=\"prefix\">−</mo>");
}

// Pandoc stretches every parenthesis, and browsers set one that may stretch twice as wide. Around
// what is no higher than a letter with its exponent it need not.
std::string with_plain_fences(std::string_view html) {
  constexpr std::string_view row = "<mrow><mo stretchy=\"true\" form=\"prefix\">";
  std::string text(html);
  for (auto at = text.find(row); at != text.npos; at = text.find(row, at + 1)) {
    const std::size_t size = end_of_element(text, at, "mrow") - at;
    const std::string inside = text.substr(at, size);
    const auto has = [&](const char* element) { return inside.find(element) != inside.npos; };
    if (has("<mfrac") || has("<mtable") || has("<mun") || has("<mover") || has("<msqrt")) continue;
    text.replace(at, size,
                 boost::replace_all_copy(inside, "stretchy=\"true\"", "stretchy=\"false\""));
  }
  // Sizes of \big and its like, which browsers take with a unit alone, and not below an exponent,
  // which then stands at a space of the same height.
  for (const auto& [size, height] :
       {std::pair{"1.2", "0.8"}, {"1.8", "1.1"}, {"2.4", "1.4"}, {"3.0", "1.7"}}) {
    const std::string mo = "<mo minsize=\"" + std::string(size), raised = "<msup>" + mo;
    for (auto at = text.find(raised); at != text.npos; at = text.find(raised, at)) {
      text.erase(at, 6);
      text.insert(text.find("</mo>", at) + 5,
                  fmt::format("<msup><mspace height=\"{}em\" />", height));
    }
    const auto sizes = [number = size](const char* unit, const char* stretches) {
      return fmt::format("minsize=\"{0}{1}\" maxsize=\"{0}{1}\" stretchy=\"{2}\"", number, unit,
                         stretches);
    };
    text = boost::replace_all_copy(text, sizes("", "false"), sizes("em", "true"));
  }
  return text;
}

// Formulas without the names that HTML does not need, and their TeX in an attribute; lines of code
// with their numbers, and without links that nobody can name.
std::string tidied(std::string_view html) {
  constexpr std::string_view math = "<math display=\"", line = "<span id=\"cb";
  constexpr std::string_view annotation = "<annotation encoding=\"application/x-tex\">";
  std::string text;
  while (!html.empty()) {
    const auto at = std::min(html.find(math), html.find(line));
    text += html.substr(0, at);
    if (at == html.npos) break;
    html.remove_prefix(at);
    if (html.starts_with(math)) {
      const std::string_view whole = html.substr(0, html.find("</math>"));
      const std::string fenced = with_plain_fences(between(whole, "<semantics>", annotation));
      std::string body = with_operator_spaces(with_upright_letters(with_signs(fenced)));
      // Rows of a display are as large as a display of one line.
      const bool is_display = whole.starts_with("<math display=\"block");
      if (is_display && body.starts_with("<mtable>")) body.insert(7, " displaystyle=\"true\"");
      // A head of nothing but a formula has no name for a screen reader.
      const bool is_head = text.ends_with("\">") && text.rfind("<th") == text.rfind('<');
      const std::string name = is_head ? fmt::format(" aria-label=\"{}\"", text_of_html(body)) : "";
      text +=
          fmt::format("<math{}{} alttext=\"{}\">{}", is_display ? " display=\"block\"" : "", name,
                      boost::replace_all_copy(
                          std::string(between(whole, annotation, "</annotation>")), "\"", "&quot;"),
                      body);
      html.remove_prefix(whole.size());
    } else {
      const std::string_view id = html.substr(line.size(), html.find("\">") - line.size());
      text +=
          fmt::format("<span class=\"lit-line\" data-line=\"{}\">", id.substr(id.find('-') + 1));
      html.remove_prefix(html.find("</a>") + 4);
    }
  }
  return text;
}

}  // namespace

Page write_page(const PageSources& sources) {
  Expanded document = Expander(sources).expand();
  Page page;
  std::string body = run_pandoc(sources, document, page);
  page.errors.insert(page.errors.begin(), document.errors.begin(), document.errors.end());
  // A listing that is scrolled sideways can be reached by the keyboard.
  body = boost::replace_all_copy(with_captions(tidied(body)),
                                 "<pre class=", "<pre tabindex=\"0\" class=");
  page.title = text_of_html(
      boost::replace_all_copy(std::string(between(body, "<h1>", "</h1>")), "<br />", " "));
  constexpr std::string_view author = "<span class=\"lit-author\">";
  for (auto at = body.find(author); at != body.npos; at = body.find(author, at + 1)) {
    page.authors.push_back(
        text_of_html(between(std::string_view(body).substr(at), author, "</span>")));
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
