// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "literate/page/html_text.hpp"
#include "literate/prose/source_label.hpp"
#include "literate/text/characters.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

using Kind = PageToken::Kind;

// Characters that TeX's fonts join: quotation marks and dashes.
std::string with_ligatures(std::string text) {
  text = replaced(std::move(text), "---", "—");
  text = replaced(std::move(text), "--", "–");
  text = replaced(std::move(text), "``", "“");
  text = replaced(std::move(text), "''", "”");
  text = replaced(std::move(text), "`", "‘");
  return replaced(std::move(text), "'", "’");
}

// What a command of LaTeX that says nothing to a page takes with it: s a star, o an argument in
// brackets, m one in braces, d a dimension or number, with or without '='.
const std::unordered_map<std::string_view, std::string_view>& ignored_commands() {
  static const std::unordered_map<std::string_view, std::string_view> all{
      {"pdfinfoomitdate", "d"},
      {"pdftrailerid", "m"},
      {"pdfsuppressptexinfo", "d"},
      {"frenchspacing", ""},
      {"nonfrenchspacing", ""},
      {"setlength", "mm"},
      {"addtolength", "mm"},
      {"captionsetup", "om"},
      {"geometry", "m"},
      {"newgeometry", "m"},
      {"restoregeometry", ""},
      {"pagestyle", "m"},
      {"thispagestyle", "m"},
      {"pagenumbering", "m"},
      {"noindent", ""},
      {"indent", ""},
      {"centering", ""},
      {"raggedright", ""},
      {"raggedcolumns", ""},
      {"flushcolumns", ""},
      {"raggedleft", ""},
      {"tiny", ""},
      {"scriptsize", ""},
      {"footnotesize", ""},
      {"small", ""},
      {"normalsize", ""},
      {"large", ""},
      {"Large", ""},
      {"LARGE", ""},
      {"huge", ""},
      {"Huge", ""},
      {"vspace", "sm"},
      {"vskip", "d"},
      {"smallskip", ""},
      {"medskip", ""},
      {"bigskip", ""},
      {"newpage", ""},
      {"clearpage", ""},
      {"cleardoublepage", ""},
      {"pagebreak", "o"},
      {"nopagebreak", "o"},
      {"linebreak", "o"},
      {"nolinebreak", "o"},
      {"leavevmode", ""},
      {"protect", ""},
      {"relax", ""},
      {"hangindent", "d"},
      {"hangafter", "d"},
      {"parindent", "d"},
      {"parskip", "d"},
      {"sloppy", ""},
      {"fussy", ""},
      {"tableofcontents", ""},
      {"listoffigures", ""},
      {"listoftables", ""},
      {"null", ""},
      {"strut", ""},
      {"selectfont", ""},
      {"fontsize", "mm"},
      {"fontfamily", "m"},
      {"fontseries", "m"},
      {"color", "om"},
      {"/", ""},
      {"@", ""},
      {"nocite", "m"},
      {"phantomsection", ""},
      {"addcontentsline", "mmm"},
      {"markboth", "mm"},
      {"markright", "m"},
      {"FloatBarrier", ""},
      {"columnbreak", ""},
      {"looseness", "d"},
      {"tolerance", "d"},
      {"emergencystretch", "d"},
      {"baselineskip", "d"},
      {"tabcolsep", "d"},
      {"columnsep", "d"},
      {"enlargethispage", "sm"},
      {"widowpenalty", "d"},
      {"interlinepenalty", "d"},
      {"clubpenalty", "d"},
      {"raggedbottom", ""},
      {"flushbottom", ""},
      {"microtypesetup", "m"},
      {"sisetup", "m"},
      {"theoremstyle", "m"},
      {"graphicspath", "m"},
      {"makeatletter", ""},
      {"makeatother", ""},
      {"needspace", "sm"},
      {"attachdata", ""},
      {"balance", ""},
      {"normalfont", ""},
      {"rmfamily", ""},
      {"upshape", ""},
      {"mdseries", ""},
      {"ignorespaces", ""},
      {"unskip", ""},
      {"unboldmath", ""},
      {"boldmath", ""},
      {"onecolumn", ""},
      {"twocolumn", "o"},
      {"newblock", ""},
      {"hypersetup", "m"},
      {"addlinespace", "o"},
      {"arraybackslash", ""},
      {"usetikzlibrary", "m"},
      {"pgfplotsset", "m"},
      {"tikzset", "m"},
      {"lstset", "m"},
      {"lstdefinestyle", "mm"},
      {"definecolor", "mmm"},
      {"AtEndDocument", "m"},
      {"apptocmd", "mmmm"},
      {"pretocmd", "mmmm"},
      {"numberwithin", "mm"},
      {"DeclareUnicodeCharacter", "mm"},
      {"hyphenation", "m"},
      {"setlist", "om"},
      {"titleformat", "smmmmm"},
      {"titlespacing", "smmmm"},
      {"vfill", ""},
      {"crefalias", "mm"},
      {"bfdefault", ""},
      {"nobreak", ""},
      {"penalty", "d"}};
  return all;
}

}  // namespace

struct PageWriter::Aside {
  std::string out, text;
  bool is_inline, in_paragraph, is_continued, is_code;
  std::vector<std::string> inlines;
  std::vector<std::size_t> groups;
  std::vector<PageToken> pending;
};

PageWriter::PageWriter(const PageSources& sources)
    : sources_(sources),
      formula_(reader_, surroundings_),
      surroundings_{.text = [this](const PageTokens& tokens) { return inline_html(tokens); },
                    .command = [this](const PageToken& token,
                                      std::string& html) { return formula_command(token, html); },
                    .complain = [this](const PageToken& token,
                                       const std::string& message) { complain(token, message); }} {
  static constexpr std::string_view defaults = R"(%
\newcommand\LiterateCitedName{Statements of others}%
\newcommand\LiterateOwnName{Statements of this document}%
\newcommand\LiterateFindingsHead{statement & found here & verdict & section}%
\newcommand\LiterateContinued{}%
\newcommand\papercommit{unknown}\newcommand\paperdate{unknown}\newcommand\paperday{unknown}%
\newcommand\ifpapermodified[2]{#2}\newcommand\today{\paperdate}%
\newcommand\abstractname{Abstract}\newcommand\refname{References}\newcommand\partname{Part}%
\newcommand\figurename{Figure}\newcommand\tablename{Table}\newcommand\lstlistingname{Listing}%
\newcommand\contentsname{Contents}\newcommand\proofname{Proof}\newcommand\bibname{References}%
)";
  read_preamble_of(page_tokens(defaults));
}

Page PageWriter::write() {
  read_preamble_of(page_tokens(sources_.repository));
  read_preamble_of(file_tokens((sources_.generated / "values.tex").string(), true));
  read_preamble_of(page_tokens(sources_.statements));
  read_preamble_of(page_tokens(sources_.restyled));
  reader_.push(file_tokens(sources_.main_file, false));
  run();
  end_paragraph();
  finish_bibliography();
  name_ids();
  const std::string body = resolved(out_);
  page_.html = head();
  page_.html += "<body>\n<a class=\"lit-skip\" href=\"#main\">Skip to the text</a>\n" + contents() +
                "<main id=\"main\">\n" + body + "</main>\n<!--lit:data-->\n</body>\n</html>\n";
  return std::move(page_);
}

// Runs definitions outside the document: what they print is lost.
void PageWriter::read_preamble_of(const PageTokens& tokens) {
  const bool was_preamble = std::exchange(is_preamble_, true);
  std::vector<PageToken> rest = reader_.set_aside();
  reader_.push(tokens);
  run();
  reader_.take_back(std::move(rest));
  is_preamble_ = was_preamble;
}

void PageWriter::run() {
  while (std::optional<PageToken> token = reader_.next()) {
    if (token->file >= 0) author_place_ = *token;
    take(*token);
  }
}

void PageWriter::take(const PageToken& token) {
  switch (token.kind) {
    case Kind::command:
      return take_command(token);
    case Kind::character:
    case Kind::space:
      return text(token.text);
    case Kind::paragraph:
      end_paragraph();
      is_continued_ = false;
      return;
    case Kind::open:
      return begin_group();
    case Kind::close:
      return end_group();
    case Kind::dollar:
      return dollar(token);
    case Kind::verbatim:
      return verbatim(token);
    case Kind::align:
    case Kind::superscript:
    case Kind::subscript:
    case Kind::parameter:
      complain(token, "stands outside of what it belongs to");
  }
}

void PageWriter::take_command(const PageToken& token) {
  const std::string& name = token.text;
  // What the engine or the page itself does comes first only where the document did not redefine
  // it.
  if (name != "begin" && name != "end" && reader_.expand(name)) return;
  if (reader_.read_definition(name)) return;
  if (is_preamble_ && (name == "newtheorem" || name == "title")) flush();
  const auto handler = handlers().find(name);
  if (handler != handlers().end()) return (this->*handler->second)(token);
  if (ignore(name)) return;
  complain(token, "is not known to the page");
}

bool PageWriter::ignore(const std::string& name) {
  const auto found = ignored_commands().find(name);
  if (found == ignored_commands().end()) return false;
  for (const char kind : found->second) {
    if (kind == 's') reader_.star();
    if (kind == 'o') reader_.optional_argument();
    if (kind == 'm') reader_.argument();
    if (kind == 'd') skip_dimension();
  }
  return true;
}

// Reads «=1.5em plus 2pt», or a register.
void PageWriter::skip_dimension() {
  reader_.skip_spaces();
  if (reader_.peek() != nullptr && reader_.peek()->is_character("=")) reader_.next();
  reader_.skip_spaces();
  bool has_digits = false;
  while (const PageToken* next = reader_.peek()) {
    const char c = next->text.empty() ? ' ' : next->text.front();
    if (next->is(Kind::character) && (is_digit(c) || c == '.' || c == '-' || c == '+')) {
      has_digits = true;
      reader_.next();
    } else {
      break;
    }
  }
  if (reader_.peek() != nullptr && reader_.peek()->is(Kind::command) && !has_digits) {
    reader_.next();
    return;
  }
  static constexpr std::array<std::string_view, 9> units{"pt", "em", "ex", "cm", "mm",
                                                         "in", "bp", "pc", "sp"};
  std::vector<PageToken> letters;
  while (letters.size() < 2 && reader_.peek() != nullptr && reader_.peek()->is(Kind::character) &&
         is_letter(reader_.peek()->text.front())) {
    letters.push_back(*reader_.next());
  }
  const bool is_unit = letters.size() == 2 &&
                       std::ranges::find(units, letters[0].text + letters[1].text) != units.end();
  if (!is_unit) {
    for (auto letter = letters.rbegin(); letter != letters.rend(); ++letter) reader_.push(*letter);
  }
  if (reader_.peek() != nullptr && reader_.peek()->is(Kind::command) && has_digits && !is_unit &&
      letters.empty() && reader_.peek()->text.ends_with("width")) {
    reader_.next();
  }
}

void PageWriter::text(std::string_view characters) {
  if (is_preamble_) return;
  const bool is_blank = characters == " ";
  if (is_blank && !in_paragraph_ && !is_inline_) return;
  ensure_paragraph();
  text_ += characters;
}

void PageWriter::html(std::string_view html) {
  if (is_preamble_ || html.empty()) return;
  ensure_paragraph();
  flush();
  out_ += html;
}

void PageWriter::block(std::string_view html) {
  if (is_preamble_) return;
  if (is_inline_) {
    flush();
    out_ += html;
    return;
  }
  end_paragraph();
  out_ += html;
  is_continued_ = false;
}

void PageWriter::flush() {
  if (text_.empty()) return;
  out_ += escape_html(is_code_ ? text_ : with_ligatures(std::move(text_)));
  text_.clear();
}

void PageWriter::ensure_paragraph() {
  if (in_paragraph_ || is_inline_) return;
  out_ += is_continued_ ? "<p class=\"lit-continued\">" : "<p>";
  for (const std::string& tag : inlines_) out_ += "<" + tag + ">";
  in_paragraph_ = true;
  is_continued_ = false;
}

void PageWriter::end_paragraph() {
  if (is_inline_) return text(" ");
  if (!in_paragraph_) return;
  flush();
  for (auto tag = inlines_.rbegin(); tag != inlines_.rend(); ++tag) {
    out_ += "</" + tag->substr(0, tag->find(' ')) + ">";
  }
  while (out_.ends_with(' ')) out_.pop_back();
  out_ += "</p>\n";
  in_paragraph_ = false;
}

void PageWriter::open_inline(std::string_view tag) {
  if (is_preamble_) return;
  flush();
  inlines_.emplace_back(tag);
  if (in_paragraph_ || is_inline_) out_ += "<" + std::string(tag) + ">";
}

void PageWriter::close_inlines(std::size_t n_kept) {
  if (inlines_.size() <= n_kept) return;
  flush();
  for (; inlines_.size() > n_kept; inlines_.pop_back()) {
    const std::string& tag = inlines_.back();
    if (in_paragraph_ || is_inline_) out_ += "</" + tag.substr(0, tag.find(' ')) + ">";
  }
  is_code_ = std::ranges::find(inlines_, "code") != inlines_.end();
}

void PageWriter::begin_group() {
  reader_.begin_group();
  groups_.push_back(inlines_.size());
}

void PageWriter::end_group() {
  reader_.end_group();
  if (groups_.empty()) return;
  close_inlines(groups_.back());
  groups_.pop_back();
}

std::string PageWriter::inline_html(const PageTokens& tokens) {
  return written(tokens, true);
}

std::string PageWriter::block_html(const PageTokens& tokens) {
  return written(tokens, false);
}

std::string PageWriter::written(const PageTokens& tokens, bool is_inline) {
  const bool was_preamble = std::exchange(is_preamble_, false);
  Aside aside{.out = std::exchange(out_, {}),
              .text = std::exchange(text_, {}),
              .is_inline = std::exchange(is_inline_, is_inline),
              .in_paragraph = std::exchange(in_paragraph_, false),
              .is_continued = std::exchange(is_continued_, false),
              .is_code = std::exchange(is_code_, false),
              .inlines = std::exchange(inlines_, {}),
              .groups = std::exchange(groups_, {}),
              .pending = reader_.set_aside()};
  reader_.push(tokens);
  reader_.begin_group();
  run();
  if (!is_inline_) end_paragraph();
  flush();
  close_inlines(0);
  while (!groups_.empty()) end_group();
  reader_.end_group();
  std::string html = std::exchange(out_, std::move(aside.out));
  text_ = std::move(aside.text);
  is_inline_ = aside.is_inline;
  in_paragraph_ = aside.in_paragraph;
  is_continued_ = aside.is_continued;
  is_code_ = aside.is_code;
  inlines_ = std::move(aside.inlines);
  groups_ = std::move(aside.groups);
  reader_.take_back(std::move(aside.pending));
  is_preamble_ = was_preamble;
  if (is_inline) {
    while (html.ends_with(' ')) html.pop_back();
    html.erase(0, std::min(html.find_first_not_of(' '), html.size()));
  }
  return html;
}

std::string PageWriter::plain_text(const PageTokens& tokens) {
  return text_of_html(inline_html(tokens));
}

std::optional<std::string> PageWriter::found_file(const std::string& name,
                                                  std::string_view ending) const {
  for (const fs::path& folder : {sources_.document, sources_.generated}) {
    for (const std::string& file : {name, name + std::string(ending)}) {
      if (fs::is_regular_file(folder / file)) return (folder / file).string();
    }
  }
  return std::nullopt;
}

PageTokens PageWriter::file_tokens(const std::string& path, bool is_generated) {
  const std::string file = is_generated ? path : (sources_.document / path).string();
  int index = -1;
  if (!is_generated) {
    index = static_cast<int>(files_.size());
    files_.push_back(path);
  }
  return page_tokens(sys::read_file(file), index, is_generated);
}

void PageWriter::complain(const PageToken& token, const std::string& message) {
  if (is_preamble_) return;
  const std::string what = (token.is(Kind::command) ? "\\" : "") + token.text;
  // What a generated file says is told where the document uses it.
  const PageToken& where = token.file >= 0 ? token : author_place_;
  std::string place = sources_.main_file;
  if (where.file >= 0) {
    place = fmt::format("{}/{}:{}:{}", source_label(sources_.document),
                        files_[static_cast<std::size_t>(where.file)], where.line, where.column);
  }
  const std::string_view blank = message.starts_with('{') ? "" : " ";
  page_.errors.push_back(fmt::format("{}: {}{}{}", place, what, blank, message));
}

int PageWriter::new_id(std::string fallback) {
  id_fallbacks_.push_back(std::move(fallback));
  id_labels_.emplace_back();
  return static_cast<int>(id_fallbacks_.size()) - 1;
}

std::string PageWriter::id_mark(int id) {
  return "\x01i" + std::to_string(id) + "\x02";
}

std::string PageWriter::mark(char kind, std::string_view payload) const {
  return "\x01" + std::string(1, kind) + std::string(payload) + "\x02";
}

Page write_page(const PageSources& sources) {
  return PageWriter(sources).write();
}

}  // namespace literate
