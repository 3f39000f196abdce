// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/expansion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>

#include "literate/page/html_text.hpp"
#include "literate/prose/document_files.hpp"
#include "literate/prose/quotations.hpp"
#include "literate/prose/tex_commands.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;

namespace page_reading {

std::string_view argument(TexScanner& in) {
  in.skip_blanks();
  if (const std::string_view group = group_at(in.rest()); !group.empty()) {
    in.skip(group.size());
    return group.substr(1, group.size() - 2);
  }
  if (in.rest().starts_with('\\')) return in.next()->text;
  std::size_t n = in.rest().empty() ? 0 : 1;
  while (n > 0 && n < in.rest().size() && (in.rest()[n] & 0xc0) == 0x80) ++n;
  return in.skip(n);
}

std::optional<std::string_view> option(TexScanner& in) {
  std::size_t at = std::min(in.rest().find_first_not_of(" \t"), in.rest().size());
  if (in.rest().substr(at).starts_with('\n')) {
    at = std::min(in.rest().find_first_not_of(" \t", at + 1), in.rest().size());
  }
  const std::string_view group = group_at(in.rest().substr(at), '[', ']');
  if (group.empty()) return std::nullopt;
  in.skip(at + group.size());
  return group.substr(1, group.size() - 2);
}

std::vector<std::string> names_in(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.emplace_back(sys::stripped(text.substr(0, end)));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace page_reading
using namespace page_reading;

Expander::Expander(const PageSources& sources)
    : sources_(sources),
      registered_(nlohmann::json::parse(sys::read_file(sources.generated / "names.json"))),
      names_(read_names(sources.generated / "names.json")),
      numbers_(sources.aux),
      out_(&result_.latex) {
  const auto say = [&](const char* kind, const std::string& name, std::string latex) {
    macros_[fmt::format("{}:{}", kind, name)] = {.body = std::move(latex)};
  };
  for (const auto& statement : numbered_statements(statements_below(sources.document), names_)) {
    const auto& [id, source] = std::tie(statement.statement.id, statement.statement.source);
    claim_order_.push_back(id);
    say("claim", id, statement.number);
    say("sentence", id, statement.statement.sentence);
    say("source", id, source.empty() ? "" : "(" + source + ")");
    statements_.emplace(id, statement);
  }
  for (const Quotation& quotation : read_quotations(sources.document)) {
    say("quotation", quotation.id, words_latex(quotation));
    say("page", quotation.id, "p.~" + escape_latex(quotation.page));
  }
  know_definitions();
  know_registered();
  know_title();
  know_numbered();
  know_references();
  know_quantities();
  for (const auto& [flag, is_set] : names_.flags) {
    macros_["flag:" + flag] = {.n_arguments = 2, .body = is_set ? "#1" : "#2"};
  }
}

Expanded Expander::expand() {
  read_preamble(sources_.known);
  const fs::path main = sources_.document / sources_.main_file;
  const std::string text = sys::read_file(main);
  const auto begin = text.find("\\begin{document}");
  if (begin == text.npos) {
    throw sys::InputError(fmt::format("'{}' has no \\begin{{document}}", main.string()));
  }
  read_preamble(std::string_view(text).substr(0, begin));
  if (fs::exists(sources_.document / "page.tex")) {
    read_preamble(sys::read_file(sources_.document / "page.tex"));
  }
  if (!sources_.repository.empty()) read_all(sources_.repository);
  if (registered_.contains("case_name")) {
    const auto name = registered_.at("case_name").get<std::string>();
    macros_["papercase"] = {.body = escape_latex(name)};
  }
  *out_ = "\\begin{document}\n";
  read_file(main);
  *out_ += "\n\\end{document}\n";
  if (const std::string left = numbers_.left(); !left.empty()) {
    result_.errors.push_back(fmt::format("{}/{}:1:1: the PDF has more numbers than the page: {}",
                                         source_label(sources_.document), sources_.main_file,
                                         left));
  }
  finish();
  return std::move(result_);
}

void Expander::read_file(const fs::path& file) {
  // TeX ends the last line of a file.
  std::string text = sys::read_file(file);
  if (!text.ends_with('\n')) text += '\n';
  const auto outer = std::tuple(file_text_, at_, file_name_);
  file_text_ = at_ = text;
  file_name_ =
      source_label(sources_.document) + "/" + file.lexically_relative(sources_.document).string();
  const auto begin = text.find("\\begin{document}");
  try {
    read_all(begin == text.npos ? std::string_view(text) : std::string_view(text).substr(begin));
  } catch (const sys::InputError& error) {
    const std::string message = error.what();
    const bool has_place = message.find(".tex:") != message.npos;
    throw sys::InputError(has_place ? message : place() + ": " + message);
  }
  std::tie(file_text_, at_, file_name_) = outer;
}

// Of the preamble only definitions count: pandoc is told nothing of it.
void Expander::read_preamble(std::string_view text) {
  TexScanner in(text);
  while (const auto token = in.next()) {
    if (token->kind != TexKind::command) continue;
    const auto macro = macros_.find(token->name);
    if (macro != macros_.end() && macro->second.body.starts_with("\\PageDefine")) {
      read_preamble(filled(in, macro->second));
    } else if (token->name == "input") {
      const fs::path file = file_of(argument(in));
      if (fs::is_regular_file(file)) read_preamble(sys::read_file(file));
    } else if (definitions_.contains(token->name)) {
      call(commands_.find(token->name)->second, in, *token);
    }
  }
}

fs::path Expander::file_of(std::string_view name) const {
  fs::path file = sources_.document / std::string(name);
  if (!fs::is_regular_file(file)) file += ".tex";
  return file;
}

void Expander::read_all(std::string_view text) {
  constexpr int deepest = 200;
  if (++depth_ > deepest) throw sys::InputError(place() + ": a command contains itself");
  TexScanner in(text);
  while (const auto token = in.next()) read(in, *token);
  --depth_;
}

void Expander::read(TexScanner& in, const TexToken& token) {
  const char* begin = token.text.data();
  if (begin >= file_text_.data() && begin < file_text_.data() + file_text_.size()) at_ = token.text;
  // Of what was generated, or stands in a definition, the author knows the line that asked for it.
  const bool has_name = token.kind == TexKind::command || token.kind == TexKind::begin ||
                        token.kind == TexKind::symbol;
  if (has_name && !result_.commands.contains(token.text)) {
    result_.commands.emplace(token.text, place());
  }
  switch (token.kind) {
    case TexKind::comment:
      // A comment ends its line, and the blanks before the next.
      in.skip(in.rest().starts_with('\n') ? 1 : 0);
      in.skip(std::min(in.rest().find_first_not_of(" \t"), in.rest().size()));
      return;
    case TexKind::begin:
      return read_begin(in, token);
    case TexKind::end:
      return read_end(token);
    case TexKind::dollar:
      if (is_math_) return emit(token.text);  // within \text
      return formula(in, token.text);
    case TexKind::symbol:
      if (token.text == "\\(") return formula(in, "\\)");
      if (token.text == "\\[") return formula(in, "\\]");
      if (token.text == "\\\\" && !is_math_) {
        option(in);
        return emit("\\\\ ");
      }
      if (token.text == "\\/" || token.text == "\\-" || token.text == "\\@") return;
      return emit(token.text);
    case TexKind::command:
      return read_command(in, token);
    case TexKind::verbatim:
      return verbatim(token);
    case TexKind::open:
      begin_group();
      return emit(token.text);
    case TexKind::close:
      end_group();
      return emit(token.text);
    default:
      emit(token.text);
  }
}

// \\begin{lstlisting}[language=C] … \\end{lstlisting}, \\begin{verbatim}, \\verb, and what is no
// text.
void Expander::verbatim(const TexToken& token) {
  if (token.name == "comment") return;
  if (const auto open = token.text.find('{');
      token.text.find('\\', 1) < token.text.size() &&
      (token.name == "href" || token.name == "url" || token.name == "nolinkurl")) {
    const std::string_view address = token.text.substr(open + 1, token.text.size() - open - 2);
    return emit(fmt::format("\\{}{{{}}}", token.name, expanded(address)));
  }
  if (token.name != "lstlisting") return emit(token.text);
  std::string_view code = token.text.substr(token.text.find('}') + 1);
  const std::string_view options = group_at(code, '[', ']');
  code.remove_prefix(std::min(code.find('\n', options.size()), code.size() - 1) + 1);
  code = code.substr(0, code.rfind("\\end"));
  std::string language;
  for (const std::string& setting : names_in(options.substr(0, options.size() - 1))) {
    const auto at = setting.find("language=");
    if (at < 2) language = setting.substr(at + 9);
  }
  listing(std::string(code), language, 0);
}

void Expander::read_command(TexScanner& in, const TexToken& token) {
  if (const auto macro = macros_.find(token.name); macro != macros_.end()) {
    if (macro->second.n_arguments == 0) {
      const auto n = std::min(in.rest().find_first_not_of(" \t"), in.rest().size());
      if (!in.rest().substr(n).starts_with('\n')) in.skip(n);
    }
    return read_all(filled(in, macro->second));
  }
  if (const auto known = commands_.find(token.name); known != commands_.end()) {
    return call(known->second, in, token);
  }
  // An assignment to a length or a number of LaTeX, such as \hangindent=1em.
  if (!is_math_ && in.rest().starts_with('=')) {
    in.skip(std::min(in.rest().find_first_of(" \t\n\\", 1), in.rest().size()));
    return;
  }
  emit(token.text);
}

void Expander::call(const Construct& construct, TexScanner& in, const TexToken& token) {
  const std::string_view marked = token.kind == TexKind::begin ? token.name : token.text;
  Call call{.in = in, .name = std::string(token.name), .is_starred = marked.ends_with('*')};
  for (const char kind : construct.form) {
    if (kind == 'o') {
      call.options.push_back(option(in));
    } else {
      call.arguments.push_back(argument(in));
    }
  }
  construct.handler(call);
}

void Expander::read_begin(TexScanner& in, const TexToken& token) {
  begin_group();
  const std::size_t n_open = ends_.size();
  if (begin_environment(in, token) && ends_.size() == n_open) end_group();
}

// Returns whether the environment has a form of its own; without an entry in ends_ it is read to
// its end.
bool Expander::begin_environment(TexScanner& in, const TexToken& token) {
  if (picture_environments_.contains(token.name)) {
    picture_environment(in, token);
    return true;
  }
  if (const auto own = own_environments_.find(token.name); own != own_environments_.end()) {
    const Macro macro = own->second;
    ends_.emplace_back(token.name, [this, end = macro.end] { read_all(end); });
    read_all(filled(in, macro));
    return true;
  }
  if (const auto known = environments_.find(token.name); known != environments_.end()) {
    call(known->second, in, token);
    return true;
  }
  emit(token.text);
  return false;
}

void Expander::read_end(const TexToken& token) {
  // An environment of the document's own may end others, which it began.
  const auto open = std::find_if(ends_.rbegin(), ends_.rend(),
                                 [&](const auto& begun) { return begun.first == token.name; });
  const bool is_own = own_environments_.contains(token.name);
  if (open == ends_.rend() || (open != ends_.rbegin() && !is_own)) {
    emit(token.text);
    return end_group();
  }
  const std::function<void()> end = open->second;
  ends_.erase(std::next(open).base());
  end();
  end_group();
}

std::string Expander::filled(TexScanner& in, const Macro& macro) const {
  std::vector<std::string> arguments;
  if (macro.has_default) {
    const auto given = option(in);
    arguments.emplace_back(given ? *given : macro.first_default);
  }
  while (arguments.size() < macro.n_arguments) arguments.emplace_back(argument(in));
  return literate::filled(macro.body, arguments);
}

std::string_view Expander::body_of(TexScanner& in, std::string_view name) const {
  const std::string_view text = in.rest();
  for (int depth = 1; auto token = in.next();) {
    if (token->name != name) continue;
    if (token->kind == TexKind::begin) ++depth;
    if (token->kind == TexKind::end && --depth == 0) {
      return text.substr(0, static_cast<std::size_t>(token->text.data() - text.data()));
    }
  }
  throw sys::InputError(fmt::format("{}: \\begin{{{}}} has no end", place(), name));
}

std::string Expander::expanded(std::string_view text) {
  std::string latex;
  std::string* outer = std::exchange(out_, &latex);
  read_all(text);
  out_ = outer;
  return latex;
}

// Letters behind the name of a command would become part of it.
void Expander::emit(std::string_view text) {
  if (text.empty()) return;
  std::size_t end = out_->size();
  while (end > 0 && is_letter((*out_)[end - 1])) --end;
  const bool ends_in_command = end > 0 && end < out_->size() && (*out_)[end - 1] == '\\' &&
                               !(end > 1 && (*out_)[end - 2] == '\\');
  if (ends_in_command && is_letter(text.front())) *out_ += ' ';
  *out_ += text;
}

std::string Expander::place() const {
  if (file_text_.empty()) return file_name_;
  const TexPlace place = place_in(file_text_, at_);
  return fmt::format("{}:{}:{}", file_name_, place.line, place.column);
}

void Expander::fail(const std::string& message) {
  result_.errors.push_back(fmt::format("{}: {}", place(), message));
}

// What cites a number and what prints it cannot differ; a class may cite more than it prints.
void Expander::hold_against(const std::string& key, const std::string& number,
                            const std::string& what) {
  const std::string& known = numbers_.label(key).number;
  // A class may put that of the section in front, as REVTeX does: «II A» for subsection A.
  const bool has_prefix = known.ends_with(number) && known.size() > number.size();
  const char before = has_prefix ? known[known.size() - number.size() - 1] : '\0';
  if (known == number || (has_prefix && !is_letter(before) && !is_digit(before))) return;
  fail(fmt::format(
      "{}'{}' has the number {} in the PDF and {} here: the PDF was made from another state of the "
      "document",
      what, key, known, number));
}

std::size_t Expander::mark(std::string open, std::string close, bool is_plain) {
  result_.marks.push_back({std::move(open), std::move(close), is_plain});
  return result_.marks.size();
}

std::string Expander::marked(std::string open, std::string_view latex, std::string close) {
  return fmt::format("\\href{{lit:{}}}{{{}}}", mark(std::move(open), std::move(close)), latex);
}

void Expander::begin_block(std::string open, std::string close, bool is_plain) {
  emit(fmt::format("\n\n\\begin{{center}}\\href{{lit:{}}}{{}}",
                   mark(std::move(open), std::move(close), is_plain)));
}

void Expander::end_block() {
  emit("\\end{center}\n\n");
}

// HTML that the engine wrote from what was registered; LaTeX in it stands in <tex></tex>.
void Expander::fragment(std::string_view html) {
  constexpr std::string_view open = "<tex>", close = "</tex>";
  begin_block("", "");
  while (!html.empty()) {
    const auto begin = html.find(open);
    emit(marked(std::string(html.substr(0, begin)), "", ""));
    if (begin == html.npos) break;
    html.remove_prefix(begin + open.size());
    const auto end = html.find(close);
    read_all(html.substr(0, end));
    html.remove_prefix(end + close.size());
  }
  end_block();
}

// pandoc's own reader of lstlisting takes a comment in the first line for LaTeX's.
void Expander::listing(std::string code, const std::string& language, int first_line) {
  begin_block(std::move(code), "");
  result_.marks.back().language = language.empty() ? "text" : language;
  result_.marks.back().first_line = first_line;
  end_block();
}

std::string Expander::use_id(const std::string& kind, const std::string& name) {
  std::vector<Use>& uses = uses_[{kind, name}];
  // Nothing within a formula can be linked to.
  uses.push_back(
      {is_math_ ? "" : fmt::format("use-{}-{}-{}", kind, name, uses.size() + 1), section_});
  return uses.back().id;
}

// «used in § 2, § 3», a link to the first use in each section unless it stands in a formula.
std::string Expander::uses(const std::string& kind, const std::string& name) const {
  const auto found = uses_.find({kind, name});
  if (found == uses_.end()) return "<span class=\"lit-uses\">not used</span>";
  std::string html, last;
  for (const Use& use : found->second) {
    if (!html.empty() && use.section == last) continue;
    last = use.section;
    if (!html.empty()) html += ", ";
    const std::string place = last.empty() ? "the text" : "§\u00a0" + last;
    html += use.id.empty() ? place
                           : fmt::format("<a class=\"lit-ref\" href=\"#{}\">{}</a>",
                                         escape_html(use.id), place);
  }
  return "<span class=\"lit-uses\">used in " + html + "</span>";
}

// What is known only at the end: who uses a name, and whether a link has its target.
void Expander::finish() {
  constexpr std::string_view begin = "@uses:";
  for (PageMark& mark : result_.marks) {
    for (auto at = mark.open.find(begin); at != std::string::npos; at = mark.open.find(begin)) {
      const auto end = mark.open.find('@', at + 1);
      const std::string name = mark.open.substr(at + begin.size(), end - at - begin.size());
      const auto colon = name.find(':');
      mark.open.replace(at, end + 1 - at, uses(name.substr(0, colon), name.substr(colon + 1)));
    }
    for (const std::string kind : {"claim-", "val-"}) {
      const auto link = mark.open.find(" href=\"#" + kind);
      if (link == std::string::npos || listed_.contains(kind)) continue;
      mark.open.erase(link, mark.open.find('"', link + 8) + 1 - link);
    }
    for (const char* place : {"@id@", "@name@"}) boost::replace_all(mark.open, place, "");
  }
}

}  // namespace literate
