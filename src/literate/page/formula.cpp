// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/formula.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "literate/page/html_text.hpp"
#include "literate/page/page_numbers.hpp"
#include "literate/text/characters.hpp"

namespace literate {
namespace {

using Kind = PageToken::Kind;
using enum AtomClass;

std::string element(std::string_view name, const std::string& content,
                    std::string_view attributes = {}) {
  return "<" + std::string(name) + std::string(attributes) + ">" + content + "</" +
         std::string(name) + ">";
}

std::string operator_html(std::string_view character, std::string_view attributes = {}) {
  return element("mo", std::string(character), attributes);
}

std::string space_html(std::string_view width) {
  return "<mspace width=\"" + std::string(width) + "\"></mspace>";
}

// Whether a piece of MathML is one element.
bool is_one_element(std::string_view html) {
  int depth = 0;
  for (std::size_t at = 0; at < html.size(); ++at) {
    if (html[at] != '<') {
      if (depth == 0) return false;
      continue;
    }
    depth += html[at + 1] == '/' ? -1 : 1;
    at = html.find('>', at);
    if (depth == 0) return at + 1 == html.size();
  }
  return false;
}

// The content as one element, in a row if it is several.
std::string as_one(const std::string& html) {
  return is_one_element(html) ? html : element("mrow", html);
}

// Whether a minus behind an atom of this class is a sign and no operation.
bool makes_sign(AtomClass before) {
  return before == binary || before == relation || before == open || before == punctuation ||
         before == function || before == large;
}

bool wants_space_before_function(AtomClass before) {
  return before == ordinary || before == close || before == function;
}

}  // namespace

std::string Formula::mathml(const PageTokens& tokens) {
  std::vector<PageToken> rest = reader_.set_aside();
  reader_.push(tokens);
  std::string html = row([](const PageToken&) { return false; });
  reader_.take_back(std::move(rest));
  return html;
}

std::string Formula::row(const std::function<bool(const PageToken&)>& ends) {
  std::vector<Atom> atoms;
  while (reader_.peek() != nullptr && !ends(*reader_.peek())) {
    if (read_atom(atoms)) {
      if (!atoms.empty() && atoms.back().atom_class != AtomClass::space) read_scripts(atoms.back());
    }
  }
  return joined(atoms);
}

std::string Formula::joined(const std::vector<Atom>& atoms) {
  std::string html;
  std::optional<AtomClass> before;
  for (const Atom& atom : atoms) {
    if (before && atom.atom_class == function && wants_space_before_function(*before)) {
      html += space_html("0.1667em");
    }
    const bool follows_function = before == function;
    if (follows_function && (atom.atom_class == ordinary || atom.atom_class == large)) {
      html += space_html("0.1667em");
    }
    html += atom.html;
    if (atom.atom_class != AtomClass::space) before = atom.atom_class;
  }
  return html;
}

// A group of atoms as one, without a row where it is one element already.
std::string Formula::grouped(const PageTokens& tokens) {
  return as_one(mathml(tokens));
}

std::string Formula::argument() {
  const PageTokens tokens = reader_.argument();
  if (tokens.size() == 1 && tokens.front().is(Kind::command)) {
    // \frac\pi2, and \sqrt\frac12 alike: the command has arguments of its own.
    reader_.push(tokens);
    std::vector<Atom> atoms;
    read_atom(atoms);
    return as_one(joined(atoms));
  }
  return grouped(tokens);
}

// Reads one atom without its scripts; false if what was read prints nothing that could have any.
bool Formula::read_atom(std::vector<Atom>& atoms) {
  PageToken token = *reader_.next();
  switch (token.kind) {
    case Kind::space:
    case Kind::paragraph:
    case Kind::close:
    case Kind::dollar:
      return false;
    case Kind::open: {
      reader_.push(token);
      const PageTokens tokens = reader_.argument();
      reader_.begin_group();
      atoms.push_back({grouped(tokens)});
      reader_.end_group();
      return true;
    }
    case Kind::superscript:
    case Kind::subscript:
      atoms.push_back({"<mrow></mrow>"});
      reader_.push(token);
      return true;
    case Kind::align:
      return false;
    case Kind::parameter:
    case Kind::verbatim:
      surroundings_.complain(token, "is no part of a formula");
      return false;
    case Kind::command:
      return command(token, atoms);
    case Kind::character:
      break;
  }
  if (token.text == "'") {  // a prime without anything before it
    atoms.push_back({"<mrow></mrow>"});
    reader_.push(token);
    return true;
  }
  Atom atom = character(token);
  const bool is_sign = (token.text == "-" || token.text == "+") &&
                       (atoms.empty() || makes_sign(atoms.back().atom_class));
  if (is_sign) {
    atom = {operator_html(token.text == "-" ? "\u2212" : "+", " form=\"prefix\""), ordinary};
  }
  atoms.push_back(std::move(atom));
  return true;
}

Formula::Atom Formula::character(const PageToken& token) {
  const std::string& text = token.text;
  const char first = text.front();
  if (is_digit(first)) return {number(text)};
  if (is_letter(first) || (static_cast<unsigned char>(first) >= 0xC3 && text != "\u00A0")) {
    return letters(alphabet_, {token});
  }
  if (text == "\u00A0") return {space_html("0.25em"), AtomClass::space};
  return operator_atom(text);
}

std::string Formula::number(std::string digits) {
  while (const PageToken* next = reader_.peek()) {
    if (!next->is(Kind::character)) break;
    if (next->text == ".") {
      const PageToken point = *reader_.next();
      const PageToken* behind = reader_.peek();
      const bool goes_on =
          behind != nullptr && behind->is(Kind::character) && is_digit(behind->text.front());
      if (!goes_on) {
        reader_.push(point);
        break;
      }
      digits += '.';
      continue;
    }
    if (!is_digit(next->text.front())) break;
    digits += next->text;
    reader_.next();
  }
  std::string mapped;
  for (const char digit : digits) mapped += math_letter(alphabet_, std::string(1, digit));
  return element("mn", mapped);
}

Formula::Atom Formula::operator_atom(std::string_view character) const {
  static constexpr std::string_view tight = " lspace=\"0em\" rspace=\"0em\"";
  if (character == "-") return {operator_html("\u2212"), binary};
  if (character == "+") return {operator_html("+"), binary};
  if (character == "*") return {operator_html("∗"), binary};
  if (character == "=" || character == ":") return {operator_html(character), relation};
  if (character == "<") return {operator_html("&lt;"), relation};
  if (character == ">") return {operator_html("&gt;"), relation};
  if (character == "(" || character == "[") {
    return {operator_html(character, " stretchy=\"false\""), open};
  }
  if (character == ")" || character == "]") {
    return {operator_html(character, " stretchy=\"false\""), close};
  }
  if (character == "|") {
    return {operator_html("|", " stretchy=\"false\" lspace=\"0em\" rspace=\"0em\"")};
  }
  if (character == "," || character == ";") return {operator_html(character), punctuation};
  if (character == "!") return {operator_html("!", tight), close};
  if (character == "/") return {operator_html("/", tight)};
  return {operator_html(escape_html(character), tight)};
}

Formula::Atom Formula::letters(std::string_view alphabet, const PageTokens& tokens) {
  std::string text;
  bool is_number = true;
  for (const PageToken& token : tokens) {
    text += math_letter(alphabet, token.text);
    is_number = is_number && is_digit(token.text.front());
  }
  if (is_number) return {element("mn", text)};
  const bool is_upright = alphabet == "mathrm" || alphabet == "mathup" || alphabet == "mathit";
  if (is_upright && tokens.size() == 1 && alphabet != "mathit") {
    return {element("mi", text, " mathvariant=\"normal\"")};
  }
  return {element("mi", text)};
}

bool Formula::space(const PageToken& token, std::vector<Atom>& atoms) {
  static const std::unordered_map<std::string_view, std::string_view> widths{
      {",", "0.1667em"},
      {"thinspace", "0.1667em"},
      {":", "0.2222em"},
      {">", "0.2222em"},
      {"medspace", "0.2222em"},
      {";", "0.2778em"},
      {"thickspace", "0.2778em"},
      {"!", "-0.1667em"},
      {"negthinspace", "-0.1667em"},
      {" ", "0.25em"},
      {"quad", "1em"},
      {"qquad", "2em"},
      {"enspace", "0.5em"}};
  const auto found = widths.find(token.text);
  if (found == widths.end()) return false;
  atoms.push_back({space_html(found->second), AtomClass::space});
  return true;
}

// Reads what a command prints; false if nothing that could have scripts.
bool Formula::command(const PageToken& token, std::vector<Atom>& atoms) {
  if (reader_.read_definition(token.text) || reader_.expand(token.text)) return false;
  if (space(token, atoms)) return false;
  if (const auto symbol = math_symbol(token.text)) {
    const bool is_letter_like =
        symbol->atom_class == ordinary && static_cast<unsigned char>(symbol->characters[0]) >= 0xCD;
    if (symbol->atom_class == ordinary && is_letter_like && token.text.size() > 1) {
      const std::string mapped = math_letter(alphabet_, symbol->characters);
      const bool is_capital = symbol->characters >= "Α" && symbol->characters <= "Ω";
      atoms.push_back(
          {element("mi", mapped,
                   is_capital && mapped == symbol->characters ? " mathvariant=\"normal\"" : "")});
    } else if (symbol->atom_class == ordinary) {
      atoms.push_back({operator_html(symbol->characters, " lspace=\"0em\" rspace=\"0em\"")});
    } else if (symbol->atom_class == open || symbol->atom_class == close) {
      atoms.push_back(
          {operator_html(symbol->characters, " stretchy=\"false\""), symbol->atom_class});
    } else {
      const bool has_limits = symbol->atom_class == large && !token.text.ends_with("int");
      atoms.push_back({operator_html(symbol->characters), symbol->atom_class, has_limits});
    }
    return true;
  }
  if (const auto function_name = math_function(token.text)) {
    const std::string name = element(
        function_name->takes_limits ? "mo" : "mi", std::string(function_name->name),
        function_name->takes_limits ? " movablelimits=\"true\" lspace=\"0em\" rspace=\"0em\"" : "");
    atoms.push_back({name, function, function_name->takes_limits});
    return true;
  }
  if (style(token, atoms) || structure(token, atoms) || sized_delimiter(token.text, atoms)) {
    return true;
  }
  static constexpr std::array<std::string_view, 7> silent{
      "nonumber", "notag", "limits", "nolimits", "allowbreak", "nobreak", "relax"};
  if (std::ranges::find(silent, token.text) != silent.end()) return false;
  std::string html;
  if (surroundings_.command(token, html)) {
    if (html.empty()) return false;
    atoms.push_back({element("mtext", html)});
    return true;
  }
  surroundings_.complain(token, "is not known to formulas of the page");
  return false;
}

// Alphabets and sizes.
bool Formula::style(const PageToken& token, std::vector<Atom>& atoms) {
  static constexpr std::array<std::string_view, 12> alphabets{
      "mathrm", "mathbf", "mathit",     "mathcal", "mathbb", "mathfrak",
      "mathsf", "mathtt", "boldsymbol", "bm",      "mathup", "mathnormal"};
  if (std::ranges::find(alphabets, token.text) != alphabets.end()) {
    const PageTokens tokens = reader_.argument();
    const bool is_word = !tokens.empty() && std::ranges::all_of(tokens, [](const PageToken& t) {
      return t.is(Kind::character) && (is_letter(t.text.front()) || is_digit(t.text.front()));
    });
    if (is_word) {
      atoms.push_back(letters(token.text, tokens));
    } else {
      const std::string former = std::exchange(alphabet_, token.text);
      atoms.push_back({grouped(tokens)});
      alphabet_ = former;
    }
    return true;
  }
  if (token.text == "displaystyle" || token.text == "textstyle") {
    const std::string is_display = token.text == "displaystyle" ? "true" : "false";
    std::string rest = row([](const PageToken&) { return false; });
    atoms.push_back({element("mstyle", rest, " displaystyle=\"" + is_display + "\"")});
    return true;
  }
  return false;
}

bool Formula::structure(const PageToken& token, std::vector<Atom>& atoms) {
  const std::string& name = token.text;
  if (name == "frac" || name == "tfrac" || name == "dfrac") {
    const std::string numerator = argument();
    std::string fraction = element("mfrac", numerator + argument());
    if (name != "frac") {
      fraction = element("mstyle", fraction,
                         name == "tfrac" ? " displaystyle=\"false\" scriptlevel=\"+0\""
                                         : " displaystyle=\"true\"");
    }
    atoms.push_back({fraction});
  } else if (name == "binom") {
    const std::string above = argument();
    atoms.push_back({"<mrow><mo>(</mo>" +
                     element("mfrac", above + argument(), " linethickness=\"0\"") +
                     "<mo>)</mo></mrow>"});
  } else if (name == "sqrt") {
    const auto index = reader_.optional_argument();
    const std::string radicand = argument();
    atoms.push_back(
        {index ? element("mroot", radicand + grouped(*index)) : element("msqrt", radicand)});
  } else if (name == "text" || name == "mbox" || name == "textrm" || name == "textup") {
    atoms.push_back({element("mtext", surroundings_.text(reader_.argument()))});
  } else if (name == "textit" || name == "emph") {
    atoms.push_back({element("mtext", "<em>" + surroundings_.text(reader_.argument()) + "</em>")});
  } else if (name == "textbf") {
    atoms.push_back(
        {element("mtext", "<strong>" + surroundings_.text(reader_.argument()) + "</strong>")});
  } else if (name == "operatorname" || name == "mathop" || name == "mathrel" || name == "mathbin" ||
             name == "mathord" || name == "ensuremath" || name == "mathopen" ||
             name == "mathclose" || name == "mathinner") {
    const bool has_limits = name == "operatorname" && reader_.star();
    const PageTokens tokens = reader_.argument();
    const std::string former =
        std::exchange(alphabet_, name == "operatorname" ? "mathrm" : alphabet_);
    const bool is_word = name == "operatorname" && std::ranges::all_of(tokens, [](const auto& t) {
                           return t.is(Kind::character) && is_letter(t.text.front());
                         });
    const std::string html = is_word ? letters("mathrm", tokens).html : grouped(tokens);
    alphabet_ = former;
    AtomClass atom_class = ordinary;
    if (name == "operatorname" || name == "mathop") atom_class = function;
    if (name == "mathrel") atom_class = relation;
    if (name == "mathbin") atom_class = binary;
    if (name == "mathopen") atom_class = open;
    if (name == "mathclose") atom_class = close;
    atoms.push_back({html, atom_class, has_limits});
  } else if (const std::string_view accent = math_accent(name); !accent.empty()) {
    const bool is_wide = name == "overline" || name.starts_with("wide") || name == "overrightarrow";
    const std::string base = argument();
    atoms.push_back({element(
        "mover",
        base + operator_html(accent, is_wide ? " stretchy=\"true\"" : " stretchy=\"false\""),
        " accent=\"true\"")});
  } else if (name == "underline") {
    atoms.push_back({element("munder", argument() + operator_html("_", " stretchy=\"true\""),
                             " accentunder=\"true\"")});
  } else if (name == "underbrace" || name == "overbrace") {
    const bool is_under = name == "underbrace";
    const std::string brace = operator_html(is_under ? "⏟" : "⏞", " stretchy=\"true\"");
    // The label below or above belongs to all that the brace embraces.
    atoms.push_back({element(is_under ? "munder" : "mover", argument() + brace), ordinary, true});
  } else if (name == "overset" || name == "stackrel") {
    const std::string above = argument();
    atoms.push_back({element("mover", argument() + above), relation});
  } else if (name == "underset") {
    const std::string below = argument();
    atoms.push_back({element("munder", argument() + below)});
  } else if (name == "phantom" || name == "hphantom" || name == "vphantom") {
    atoms.push_back({element("mphantom", argument())});
  } else if (name == "not") {
    const PageTokens next = reader_.argument();
    std::string negated = "≠";
    if (!next.empty() && !next.front().is_character("=")) {
      const auto symbol = math_symbol(next.front().text);
      negated = std::string(symbol ? symbol->characters : next.front().text) + "\u0338";
    }
    atoms.push_back({operator_html(negated), relation});
  } else if (name == "left") {
    atoms.push_back(stretched());
  } else if (name == "begin") {
    atoms.push_back({environment(reader_.text_argument())});
  } else if (name == "num") {
    reader_.optional_argument();
    atoms.push_back({number_mathml(reader_.text_argument())});
  } else {
    return false;
  }
  return true;
}

std::string Formula::delimiter() {
  reader_.skip_spaces();
  const std::optional<PageToken> token = reader_.next();
  if (!token || token->text == ".") return "";
  if (token->is(Kind::command)) {
    const auto symbol = math_symbol(token->text);
    if (!symbol) surroundings_.complain(*token, "is no delimiter that the page knows");
    return symbol ? std::string(symbol->characters) : "";
  }
  if (token->text == "<") return "⟨";
  if (token->text == ">") return "⟩";
  return escape_html(token->text);
}

// What stands between \left and \right.
Formula::Atom Formula::stretched() {
  const auto fence = [](const std::string& character, std::string_view form) {
    if (character.empty()) return std::string();
    return operator_html(character, " stretchy=\"true\" symmetric=\"true\" fence=\"true\" form=\"" +
                                        std::string(form) + "\" lspace=\"0em\" rspace=\"0em\"");
  };
  const std::string left = fence(delimiter(), "prefix");
  const std::string inside = row([](const PageToken& token) { return token.is_command("right"); });
  std::string right;
  if (reader_.next()) right = fence(delimiter(), "postfix");
  return {element("mrow", left + inside + right), close};
}

bool Formula::sized_delimiter(std::string_view name, std::vector<Atom>& atoms) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> sizes{
      {{"Bigg", "3em"}, {"bigg", "2.4em"}, {"Big", "1.8em"}, {"big", "1.2em"}}};
  for (const auto& [prefix, size] : sizes) {
    if (!name.starts_with(prefix)) continue;
    const std::string_view side = name.substr(prefix.size());
    if (!side.empty() && side != "l" && side != "r" && side != "m") return false;
    const std::string attributes = " stretchy=\"true\" symmetric=\"true\" minsize=\"" +
                                   std::string(size) + "\" maxsize=\"" + std::string(size) +
                                   "\" lspace=\"0em\" rspace=\"0em\"";
    AtomClass atom_class = ordinary;
    if (side == "l") atom_class = open;
    if (side == "r") atom_class = close;
    atoms.push_back({operator_html(delimiter(), attributes), atom_class});
    return true;
  }
  return false;
}

std::vector<std::vector<PageTokens>> formula_rows(const PageTokens& tokens) {
  std::vector<std::vector<PageTokens>> rows{{{}}};
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const PageToken& token = tokens[i];
    if (token.is(Kind::open) || token.is_command("begin")) ++depth;
    if (token.is(Kind::close) || token.is_command("end")) --depth;
    if (depth == 0 && token.is(Kind::align)) {
      rows.back().emplace_back();
    } else if (depth == 0 && (token.is_command("\\") || token.is_command("cr"))) {
      // A space that is asked for behind the row, as \\[4pt], is no part of the next.
      if (i + 1 < tokens.size() && tokens[i + 1].is_character("[")) {
        while (i + 1 < tokens.size() && !tokens[i + 1].is_character("]")) ++i;
        ++i;
      }
      rows.push_back({{}});
    } else {
      rows.back().back().push_back(token);
    }
  }
  if (rows.back().size() == 1 && is_blank(rows.back().front())) rows.pop_back();
  return rows;
}

std::string Formula::environment(const std::string& name) {
  struct Fences {
    std::string_view left, right;
  };
  static const std::unordered_map<std::string_view, Fences> fences{
      {"matrix", {"", ""}},      {"pmatrix", {"(", ")"}}, {"bmatrix", {"[", "]"}},
      {"Bmatrix", {"{", "}"}},   {"vmatrix", {"|", "|"}}, {"Vmatrix", {"‖", "‖"}},
      {"smallmatrix", {"", ""}}, {"array", {"", ""}},     {"cases", {"{", ""}},
      {"aligned", {"", ""}},     {"split", {"", ""}},     {"gathered", {"", ""}},
      {"alignedat", {"", ""}},   {"dcases", {"{", ""}}};
  std::string columns;
  if (name == "array" || name == "alignedat") {
    reader_.optional_argument();
    columns = reader_.text_argument();
  } else if (name == "aligned" || name == "gathered") {
    reader_.optional_argument();
  }
  const PageTokens body = reader_.environment_body(name);
  const auto found = fences.find(name);
  if (found == fences.end()) {
    PageToken place;
    if (!body.empty()) place = body.front();
    place.text = name;
    surroundings_.complain(place, "is no environment that formulas of the page know");
    return "";
  }
  const bool is_aligned = name == "aligned" || name == "split" || name == "alignedat";
  const bool is_cases = name == "cases" || name == "dcases";
  std::erase_if(columns, [](char c) { return c != 'l' && c != 'c' && c != 'r'; });
  std::string rows;
  for (const std::vector<PageTokens>& cells : formula_rows(body)) {
    std::string row_html;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::string align = "center";
      if (is_aligned) align = i % 2 == 0 ? "right" : "left";
      if (is_cases) align = "left";
      if (i < columns.size() && name == "array") {
        align = columns[i] == 'l' ? "left" : (columns[i] == 'r' ? "right" : "center");
      }
      std::string css = "text-align:" + align;
      if (is_aligned) {
        css += i % 2 == 0 ? ";padding-right:0" : ";padding-left:0";
      }
      // Behind the sign of a row that is aligned at it, an operation is one and no sign.
      const std::string before = is_aligned && i % 2 == 1 ? "<mi></mi>" : "";
      row_html += element("mtd", before + mathml(cells[i]), " style=\"" + css + "\"");
    }
    rows += element("mtr", row_html);
  }
  const bool is_display = is_aligned || name == "gathered" || name == "dcases";
  const std::string table = element("mtable", rows, is_display ? " displaystyle=\"true\"" : "");
  const auto fence = [](std::string_view character, std::string_view form) {
    return character.empty()
               ? std::string()
               : operator_html(character, " stretchy=\"true\" form=\"" + std::string(form) + "\"");
  };
  return element(
      "mrow", fence(found->second.left, "prefix") + table + fence(found->second.right, "postfix"));
}

std::string Formula::primes() {
  std::string text;
  while (reader_.peek() != nullptr && reader_.peek()->is_character("'")) {
    text += "′";
    reader_.next();
  }
  return text.empty() ? text : operator_html(text, " lspace=\"0em\" rspace=\"0em\"");
}

void Formula::read_scripts(Atom& atom) {
  std::string below, above;
  while (reader_.peek() != nullptr) {
    const PageToken& next = *reader_.peek();
    if (next.is(Kind::space)) {
      reader_.next();
    } else if (next.is_command("limits") || next.is_command("nolimits")) {
      atom.takes_limits = next.is_command("limits");
      reader_.next();
    } else if (next.is_character("'")) {
      above += primes();
    } else if (next.is(Kind::superscript)) {
      reader_.next();
      above += argument();
    } else if (next.is(Kind::subscript)) {
      reader_.next();
      below += argument();
    } else {
      break;
    }
  }
  if (below.empty() && above.empty()) return;
  if (!above.empty()) above = as_one(above);
  std::string base = atom.html.empty() ? "<mrow></mrow>" : atom.html;
  // Browsers give a delimiter its size in a row alone.
  if (base.starts_with("<mo stretchy=\"true\"")) base = element("mrow", base);
  const bool is_limits = atom.takes_limits;
  if (above.empty()) {
    atom.html = element(is_limits ? "munder" : "msub", base + below);
  } else if (below.empty()) {
    atom.html = element(is_limits ? "mover" : "msup", base + above);
  } else {
    atom.html = element(is_limits ? "munderover" : "msubsup", base + below + above);
  }
}

}  // namespace literate
