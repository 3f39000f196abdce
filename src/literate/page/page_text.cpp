// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "literate/page/html_text.hpp"
#include "literate/page/page_numbers.hpp"
#include "literate/page/page_writer.hpp"
#include "literate/text/characters.hpp"

namespace literate {
namespace {

using Kind = PageToken::Kind;

// What letters with accents are: the accent's command, and pairs of letter and result.
struct Accent {
  std::string_view name, letters, combining;
};
constexpr std::array<Accent, 12> accents{{
    {"\"", "aäeëiïoöuüyÿAÄEËIÏOÖUÜ", "\u0308"},
    {"'", "aáeéiíoóuúyýcćnńAÁEÉIÍOÓUÚ", "\u0301"},
    {"`", "aàeèiìoòuùAÀEÈIÌOÒUÙ", "\u0300"},
    {"^", "aâeêiîoôuûAÂEÊIÎOÔUÛ", "\u0302"},
    {"~", "aãnñoõAÃNÑOÕ", "\u0303"},
    {"c", "cçsşCÇSŞ", "\u0327"},
    {"v", "cčsšzžeěrřCČSŠZŽ", "\u030C"},
    {"H", "oőuűOŐUŰ", "\u030B"},
    {"=", "aāeēiīoōuū", "\u0304"},
    {".", "zżZŻ", "\u0307"},
    {"u", "aăgğ", "\u0306"},
    {"r", "aåuůAÅ", "\u030A"},
}};

// The characters of a UTF-8 text, one by one.
std::vector<std::string> characters_of(std::string_view text) {
  std::vector<std::string> all;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) all.emplace_back();
    all.back() += c;
  }
  return all;
}

std::string css_length(std::string length) {
  std::erase(length, ' ');
  const std::size_t unit = length.find_first_not_of("-+.0123456789");
  if (unit == std::string::npos) return "0";
  const std::string name = length.substr(unit);
  const std::string digits = length.substr(0, unit);
  if (name == "pt" || name == "cm" || name == "mm" || name == "in" || name == "em" ||
      name == "ex") {
    return digits + name;
  }
  if (name.ends_with("width")) {
    return fmt::format("{}%", 100 * (digits.empty() ? 1 : std::atof(digits.c_str())));
  }
  return "1em";
}

}  // namespace

void PageWriter::style_text(const PageToken& token) {
  static const std::unordered_map<std::string_view, std::string_view> tags{
      {"textbf", "strong"},
      {"textit", "em"},
      {"textsl", "em"},
      {"emph", "em"},
      {"texttt", "code"},
      {"textsf", "span class=\"lit-sans\""},
      {"textsc", "span class=\"lit-small-caps\""},
      {"underline", "u"},
      {"textsuperscript", "sup"},
      {"textsubscript", "sub"},
      {"textrm", ""},
      {"textup", ""},
      {"textmd", ""},
      {"textnormal", ""},
      {"text", ""},
      {"ensuremath", ""},
      {"uline", "u"}};
  const std::string_view tag = tags.at(token.text);
  const PageTokens tokens = reader_.argument();
  if (token.text == "ensuremath") return html(formula(tokens, false));
  begin_group();
  if (!tag.empty()) open_inline(tag);
  is_code_ = is_code_ || tag == "code";
  PageToken close = token;
  close.kind = Kind::close;
  close.text = "}";
  reader_.push(close);
  reader_.push(tokens);
}

void PageWriter::style_from_here(const PageToken& token) {
  static const std::unordered_map<std::string_view, std::string_view> tags{
      {"bfseries", "strong"},
      {"bf", "strong"},
      {"itshape", "em"},
      {"it", "em"},
      {"em", "em"},
      {"slshape", "em"},
      {"ttfamily", "code"},
      {"tt", "code"},
      {"sffamily", "span class=\"lit-sans\""},
      {"scshape", "span class=\"lit-small-caps\""}};
  const std::string_view tag = tags.at(token.text);
  open_inline(tag);
  is_code_ = is_code_ || tag == "code";
}

void PageWriter::symbol(const PageToken& token) {
  static const std::unordered_map<std::string_view, std::string_view> symbols{
      {"%", "%"},
      {"&", "&"},
      {"#", "#"},
      {"_", "_"},
      {"$", "$"},
      {"{", "{"},
      {"}", "}"},
      {" ", " "},
      {",", "\u202F"},
      {"thinspace", "\u202F"},
      {":", " "},
      {";", " "},
      {"!", ""},
      {"-", "\u00AD"},
      {"quad", "\u2003"},
      {"qquad", "\u2003\u2003"},
      {"enspace", "\u2002"},
      {"hfill", " "},
      {"percent", "%"},
      {"ldots", "…"},
      {"dots", "…"},
      {"textellipsis", "…"},
      {"textendash", "–"},
      {"textemdash", "—"},
      {"textbar", "|"},
      {"textless", "<"},
      {"textgreater", ">"},
      {"textunderscore", "_"},
      {"textbackslash", "\\"},
      {"textasciicircum", "\u005E"},
      {"textasciitilde", "~"},
      {"textbullet", "•"},
      {"textdegree", "°"},
      {"textmu", "µ"},
      {"textonehalf", "½"},
      {"textonequarter", "¼"},
      {"textthreequarters", "¾"},
      {"texttimes", "×"},
      {"textpm", "±"},
      {"textperiodcentered", "·"},
      {"textquoteleft", "‘"},
      {"textquoteright", "’"},
      {"textquotedblleft", "“"},
      {"textquotedblright", "”"},
      {"textbraceleft", "{"},
      {"textbraceright", "}"},
      {"textsection", "§"},
      {"S", "§"},
      {"P", "¶"},
      {"copyright", "©"},
      {"textcopyright", "©"},
      {"textregistered", "®"},
      {"texttrademark", "™"},
      {"pounds", "£"},
      {"euro", "€"},
      {"texteuro", "€"},
      {"ss", "ß"},
      {"o", "ø"},
      {"O", "Ø"},
      {"l", "ł"},
      {"L", "Ł"},
      {"ae", "æ"},
      {"AE", "Æ"},
      {"oe", "œ"},
      {"OE", "Œ"},
      {"aa", "å"},
      {"AA", "Å"},
      {"i", "ı"},
      {"j", "ȷ"},
      {"and", ", "},
      {"dag", "†"},
      {"ddag", "‡"},
      {"LaTeX", "LaTeX"},
      {"TeX", "TeX"},
      {"BibTeX", "BibTeX"},
      {"slash", "/"},
      {"textquotesingle", "\u02B9"},
      {"textasteriskcentered", "∗"},
      {"textminus", "\u2212"},
      {"guillemotleft", "«"},
      {"guillemotright", "»"},
      {"checkmark", "✓"}};
  if (token.text == "allowbreak") return html("<wbr>");
  text(symbols.at(token.text));
}

void PageWriter::accent(const PageToken& token) {
  std::string letter = plain_text(reader_.argument());
  if (letter == "ı") letter = "i";
  const auto* const found = std::ranges::find(accents, token.text, &Accent::name);
  const std::vector<std::string> pairs = characters_of(found->letters);
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    if (pairs[i] == letter) return text(pairs[i + 1]);
  }
  text(letter + std::string(found->combining));
}

void PageWriter::line_break(const PageToken&) {
  reader_.star();
  reader_.optional_argument();
  html("<br>");
}

// Boxes: what is in them, without breaks between lines.
void PageWriter::boxed(const PageToken& token) {
  if (token.text == "hspace") {
    reader_.star();
    reader_.argument();
    return text(" ");
  }
  if (token.text == "raisebox") reader_.argument();
  std::string width;
  for (int i = 0; i < 3; ++i) {
    const auto option = reader_.optional_argument();
    if (i == 0 && option && token.text == "makebox") width = css_length(latex_of_tokens(*option));
  }
  if (token.text == "parbox") reader_.argument();
  if (token.text == "scalebox" || token.text == "rotatebox") reader_.argument();
  if (token.text == "resizebox") {
    reader_.argument();
    reader_.argument();
  }
  const std::string content = inline_html(reader_.argument());
  if (!width.empty()) {
    return html("<span class=\"lit-box\" style=\"display:inline-block;min-width:" + width + "\">" +
                content + "</span>");
  }
  if (content.empty()) return;
  const bool is_text = token.text == "parbox";
  html(is_text ? content : "<span class=\"lit-nowrap\">" + content + "</span>");
}

void PageWriter::rule(const PageToken&) {
  reader_.optional_argument();
  const std::string width = css_length(plain_text(reader_.argument()));
  const std::string height = css_length(plain_text(reader_.argument()));
  html(
      fmt::format("<span class=\"lit-rule\" style=\"display:inline-block;background:currentColor;"
                  "width:{};height:{}\"></span>",
                  width, height));
}

void PageWriter::footnote(const PageToken&) {
  reader_.optional_argument();
  const PageTokens tokens = reader_.argument();
  if (is_preamble_) return;
  const int n = ++counters_["footnote"];
  html(
      fmt::format("<sup class=\"lit-note-mark\"><a id=\"noteref-{0}\" href=\"#note-{0}\" "
                  "aria-label=\"footnote {0}\">{0}</a></sup>",
                  n));
  html(
      fmt::format("<span class=\"lit-note\" id=\"note-{0}\" role=\"note\"><span "
                  "class=\"lit-number\">{0}</span> {1}</span>",
                  n, inline_html(tokens)));
}

void PageWriter::hyperlink(const PageToken& token) {
  const std::string address =
      token.text == "doi" ? "https://doi.org/" + reader_.text_argument() : reader_.text_argument();
  const std::string shown = token.text == "href" ? inline_html(reader_.argument())
                                                 : "<code>" + escape_html(address) + "</code>";
  html("<a class=\"lit-link\" href=\"" + escape_html(replaced(address, "\\", "")) + "\">" + shown +
       "</a>");
}

void PageWriter::colored(const PageToken& token) {
  reader_.optional_argument();
  reader_.argument();
  if (token.text == "colorbox" || token.text == "textcolor") {
    const PageTokens tokens = reader_.argument();
    PageToken brace = token;
    brace.kind = Kind::close;
    brace.text = "}";
    reader_.push(brace);
    reader_.push(tokens);
    begin_group();
  }
}

void PageWriter::number(const PageToken& token) {
  reader_.optional_argument();
  std::string shown;
  if (token.text == "num") {
    shown = number_html(reader_.text_argument());
  } else if (token.text == "unit" || token.text == "si") {
    shown = unit_html(reader_.text_argument());
  } else {
    const std::string number = reader_.text_argument();
    shown = quantity_html(number, reader_.text_argument());
  }
  html("<span class=\"lit-nowrap\">" + shown + "</span>");
}

void PageWriter::group_command(const PageToken& token) {
  if (token.text == "par") {
    end_paragraph();
    is_continued_ = false;
  } else if (token.text == "begingroup" || token.text == "bgroup") {
    begin_group();
  } else {
    end_group();
  }
}

void PageWriter::input(const PageToken& token) {
  const std::string name = reader_.text_argument();
  if (token.text == "InputIfFileExists") {
    const PageTokens yes = reader_.argument();
    const PageTokens no = reader_.argument();
    reader_.push(found_file(name, ".tex") ? yes : no);
    if (!found_file(name, ".tex")) return;
  }
  const std::optional<std::string> file = found_file(name, ".tex");
  if (!file) return complain(token, "finds no file '" + name + "'");
  const bool is_generated = file->starts_with(sources_.generated.string());
  reader_.push(file_tokens(
      is_generated ? *file
                   : std::filesystem::path(*file).lexically_relative(sources_.document).string(),
      is_generated));
}

void PageWriter::set_register(const PageToken& token) {
  const std::string name = reader_.text_argument();
  if (token.text == "newcounter") {
    counters_[name] = 0;
    reader_.optional_argument();
    return;
  }
  if (token.text == "stepcounter" || token.text == "refstepcounter") {
    ++counters_[name];
    return;
  }
  const int value = std::atoi(reader_.text_argument().c_str());
  counters_[name] = token.text == "addtocounter" ? counters_[name] + value : value;
}

// Numbers and lengths with a number in them are compared; what else TeX can ask, a page cannot
// answer.
void PageWriter::condition(const PageToken& token) {
  const std::string& name = token.text;
  bool holds = name == "iftrue";
  if (name == "ifdim" || name == "ifnum") {
    std::string asked;
    while (reader_.peek() != nullptr) {
      const PageToken next = *reader_.next();
      if (next.is(Kind::command)) {
        if (next.text == "relax") break;
        if (reader_.expand(next.text)) continue;
        const auto handler = handlers().find(next.text);
        if (next.text == "rawval" && handler != handlers().end()) {
          reader_.push(next);
          reader_.next();
          const PageTokens key = reader_.argument();
          const auto found = raw_values_.find(latex_of_tokens(key));
          if (found != raw_values_.end()) asked += latex_of_tokens(found->second);
          continue;
        }
        reader_.push(next);
        break;
      }
      if (!next.is(Kind::character) && !next.is(Kind::space)) {
        reader_.push(next);
        break;
      }
      asked += next.text;
      // The second length ends with its unit.
      const std::size_t relation = asked.find_first_of("<>=");
      const bool has_unit =
          relation != std::string::npos && asked.size() > relation + 3 &&
          (asked.ends_with("pt") || asked.ends_with("cm") || asked.ends_with("mm"));
      if (name == "ifdim" && has_unit) break;
      if (name == "ifnum" && relation != std::string::npos && asked.size() > relation + 1 &&
          next.is(Kind::space)) {
        break;
      }
    }
    const std::size_t relation = asked.find_first_of("<>=");
    if (relation == std::string::npos) {
      complain(token, "asks what the page cannot answer");
    } else {
      const double left = std::atof(asked.c_str());
      const double right = std::atof(asked.c_str() + relation + 1);
      holds = asked[relation] == '<' ? left < right
                                     : (asked[relation] == '>' ? left > right : left == right);
    }
  } else if (name != "iftrue" && name != "iffalse") {
    complain(token, "asks what the page cannot answer");
  }
  PageTokens yes, no;
  PageTokens* branch = &yes;
  int depth = 0;
  while (std::optional<PageToken> next = reader_.next()) {
    if (next->is(Kind::command)) {
      const bool opens = next->text.starts_with("if") && next->text != "ifflag" &&
                         next->text != "ifpapermodified" && next->text != "iff";
      if (opens) ++depth;
      if (next->text == "fi" && depth-- == 0) break;
      if (next->text == "else" && depth == 0) {
        branch = &no;
        continue;
      }
    }
    branch->push_back(*std::move(next));
  }
  reader_.push(holds ? yes : no);
}

void PageWriter::metadata(const PageToken& token) {
  if (token.text == "author") reader_.optional_argument();
  metadata_[token.text] = reader_.argument();
}

void PageWriter::new_environment(const PageToken&) {
  reader_.star();
  const std::string name = reader_.text_argument();
  PageMacro begin;
  if (const auto n = reader_.optional_argument()) {
    const int n_arguments = std::atoi(latex_of_tokens(*n).c_str());
    for (int i = 1; i <= n_arguments; ++i) {
      begin.pattern.push_back({.kind = Kind::parameter, .text = std::to_string(i)});
    }
    begin.default_value = reader_.optional_argument();
  }
  begin.body = reader_.argument();
  const PageMacro end{.pattern = {}, .body = reader_.argument()};
  reader_.define(name, std::move(begin));
  reader_.define("end" + name, end);
}

void PageWriter::new_theorem(const PageToken&) {
  const bool has_no_number = reader_.star();
  const std::string name = reader_.text_argument();
  const auto shared = reader_.optional_argument();
  const std::string title = plain_text(reader_.argument());
  reader_.optional_argument();
  std::string counter = shared ? latex_of_tokens(*shared) : name;
  if (has_no_number) counter.clear();
  theorems_[name] = {title, counter};
  if (!reference_names_.contains(name)) {
    std::string small = title;
    if (!small.empty() && small[0] >= 'A' && small[0] <= 'Z') small[0] += 'a' - 'A';
    reference_names_[name] = {small, small + "s", title, title + "s"};
  }
}

void PageWriter::math_operator(const PageToken& token) {
  const bool has_limits = reader_.star();
  const PageTokens name = reader_.argument();
  PageTokens body = page_tokens(has_limits ? "\\operatorname*" : "\\operatorname");
  PageToken brace = token;
  brace.kind = Kind::open;
  brace.text = "{";
  body.push_back(brace);
  const PageTokens shown = reader_.argument();
  body.insert(body.end(), shown.begin(), shown.end());
  brace.kind = Kind::close;
  brace.text = "}";
  body.push_back(brace);
  if (name.size() == 1) reader_.define(name.front().text, {.pattern = {}, .body = body});
}

void PageWriter::package(const PageToken&) {
  const auto options = reader_.optional_argument();
  const std::string name = reader_.text_argument();
  reader_.optional_argument();
  if (name != "cleveref" || !options) return;
  std::string rest = latex_of_tokens(*options);
  std::erase(rest, ' ');
  for (const char* option : {"capitalise", "capitalize", "noabbrev"}) {
    if (rest.find(option) != std::string::npos) package_options_.insert(option);
  }
}

void PageWriter::verbatim(const PageToken& token) {
  if (token.text == "comment") return;
  if (token.text == "verb") return html("<code>" + escape_html(token.body) + "</code>");
  std::string body = token.body;
  if (body.starts_with("[")) body.erase(0, body.find(']') + 1);
  body.erase(0, std::min(body.find_first_not_of('\n'), body.size()));
  block("<pre class=\"lit-verbatim\" tabindex=\"0\"><code>" + escape_html(body) +
        "</code></pre>\n");
}

}  // namespace literate
