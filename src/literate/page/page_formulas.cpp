// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "literate/page/html_text.hpp"
#include "literate/page/page_writer.hpp"

namespace literate {
namespace {

// Begins the box of a displayed formula. It scrolls where the formula is wider than the window, and
// so the keyboard has to come to it.
std::string equation_box(const std::string& id, const std::string& number) {
  const std::string name = number.empty() ? "Formula" : "Equation (" + text_of_html(number) + ")";
  return "<div class=\"lit-equation\"" + id + " tabindex=\"0\" role=\"group\" aria-label=\"" +
         escape_html(name) + "\">";
}

using Kind = PageToken::Kind;

std::string trimmed(std::string text) {
  text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

// Without \label, \tag and \nonumber.
void remove_number(PageTokens& tokens) {
  PageTokens kept;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const PageToken& token = tokens[i];
    if (token.is_command("nonumber") || token.is_command("notag")) continue;
    if (!token.is_command("label") && !token.is_command("tag")) {
      kept.push_back(token);
      continue;
    }
    int depth = 0;
    while (++i < tokens.size()) {
      if (tokens[i].is(Kind::open)) ++depth;
      if (tokens[i].is(Kind::close) && --depth == 0) break;
    }
  }
  tokens = std::move(kept);
}

}  // namespace

/// The number of a displayed formula, and the id that a \label or the number gives it.
struct PageWriter::EquationNumber {
  std::string html;  ///< without parentheses; empty if there is none
  int id = -1;
};

std::string PageWriter::formula(const PageTokens& tokens, bool is_display) {
  std::string mathml = formula_.mathml(tokens);
  // A sign by itself, «≤», has no room around it, as in LaTeX.
  constexpr std::string_view sign = "<mo>";
  if (mathml.starts_with(sign) && mathml.find('<', sign.size()) + 5 == mathml.size()) {
    mathml.replace(0, sign.size(), "<mo lspace=\"0em\" rspace=\"0em\">");
  }
  return fmt::format("<math{} alttext=\"{}\">{}</math>", is_display ? " display=\"block\"" : "",
                     escape_html(trimmed(replaced(latex_of_tokens(tokens), "\n\n", " "))), mathml);
}

bool PageWriter::formula_command(const PageToken& token, std::string& html) {
  if (token.text == "label") {
    label(token);
    return true;
  }
  if (token.text == "ifflag") {
    flag(token);
    return true;
  }
  const auto handler = handlers().find(token.text);
  if (handler == handlers().end()) return false;
  // The command reads its own arguments, so it runs where the formula is read, and its output is
  // taken.
  const std::string out = std::exchange(out_, {});
  const std::string former_text = std::exchange(text_, {});
  const bool was_inline = std::exchange(is_inline_, true);
  (this->*handler->second)(token);
  flush();
  html = std::exchange(out_, out);
  text_ = former_text;
  is_inline_ = was_inline;
  return true;
}

// Between one dollar and the next, or two and two.
void PageWriter::dollar(const PageToken& token) {
  PageTokens tokens;
  int depth = 0;
  while (std::optional<PageToken> next = reader_.next()) {
    if (next->is(Kind::open)) ++depth;
    if (next->is(Kind::close)) --depth;
    if (depth == 0 && next->is(Kind::dollar)) break;
    tokens.push_back(*std::move(next));
  }
  if (is_preamble_) return;
  if (token.text == "$") return html(formula(tokens, false));
  block(equation_box({}, {}) + formula(tokens, true) + "</div>\n");
  is_continued_ = true;
}

void PageWriter::inline_formula(const PageToken&) {
  PageTokens tokens;
  while (std::optional<PageToken> next = reader_.next()) {
    if (next->is_command(")")) break;
    tokens.push_back(*std::move(next));
  }
  html(formula(tokens, false));
}

void PageWriter::display_formula(const PageToken&) {
  PageTokens tokens;
  while (std::optional<PageToken> next = reader_.next()) {
    if (next->is_command("]")) break;
    tokens.push_back(*std::move(next));
  }
  if (is_preamble_) return;
  block(equation_box({}, {}) + formula(tokens, true) + "</div>\n");
  is_continued_ = true;
}

// Takes \label, \tag and \nonumber out of a row.
PageWriter::EquationNumber PageWriter::take_number(PageTokens& tokens, bool is_numbered) {
  std::vector<PageToken> rest = reader_.set_aside();
  reader_.push(tokens);
  PageTokens kept;
  std::vector<std::string> keys;
  std::optional<std::string> tag;
  while (std::optional<PageToken> token = reader_.next()) {
    if (token->is_command("label")) {
      keys.push_back(reader_.text_argument());
    } else if (token->is_command("tag")) {
      reader_.star();
      tag = inline_html(reader_.argument());
    } else if (token->is_command("nonumber") || token->is_command("notag")) {
      is_numbered = false;
    } else {
      kept.push_back(*std::move(token));
    }
  }
  reader_.take_back(std::move(rest));
  tokens = std::move(kept);
  if (!is_numbered && !tag) return {};
  EquationNumber number;
  number.html = tag ? *tag : std::to_string(++counters_["equation"]);
  number.id = new_id("equation-" + text_of_html(number.html));
  const Target outside = std::exchange(target_, Target{"equation", number.html, "", number.id});
  for (const std::string& key : keys) {
    labels_[key] = target_;
    std::string& name = id_labels_[static_cast<std::size_t>(number.id)];
    if (name.empty()) name = key;
  }
  target_ = outside;
  return number;
}

void PageWriter::equation(const std::string& name) {
  PageTokens tokens = reader_.environment_body(name);
  const EquationNumber number = take_number(tokens, !name.ends_with('*') && name != "displaymath");
  const std::string id = number.id < 0 ? "" : " id=\"" + id_mark(number.id) + "\"";
  const std::string printed =
      number.html.empty() ? "" : "<span class=\"lit-equation-number\">(" + number.html + ")</span>";
  block(equation_box(id, number.html) + formula(tokens, true) + printed + "</div>\n");
  is_continued_ = true;
}

// Rows that are aligned at &, each with its number.
void PageWriter::equations(const std::string& name) {
  if (name.starts_with("alignat")) reader_.argument();
  const bool is_numbered = !name.ends_with('*');
  const bool is_centered = name.starts_with("gather") || name.starts_with("multline");
  const PageTokens body = reader_.environment_body(name);
  const std::vector<std::vector<PageTokens>> rows = formula_rows(body);
  std::size_t n_columns = 1;
  for (const auto& row : rows) n_columns = std::max(n_columns, row.size());
  const bool is_one_number = name.starts_with("multline");
  std::string html;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    PageTokens all;
    for (const PageTokens& cell : rows[i]) all.insert(all.end(), cell.begin(), cell.end());
    const bool wants_number = is_numbered && (!is_one_number || i + 1 == rows.size());
    const EquationNumber number = take_number(all, wants_number);
    std::vector<PageTokens> cells = rows[i];
    std::ranges::for_each(cells, remove_number);
    html += "<tr" + (number.id < 0 ? "" : " id=\"" + id_mark(number.id) + "\"") + ">";
    for (std::size_t column = 0; column < n_columns; ++column) {
      const bool is_left = column % 2 == 1;
      const std::string_view css =
          is_centered ? "lit-middle" : (is_left ? "lit-left" : "lit-right");
      std::string content;
      if (column < cells.size() && !is_blank(cells[column])) {
        PageTokens cell = cells[column];
        // Behind the place of alignment a sign of relation or operation has its spaces.
        if (is_left)
          cell.insert(cell.begin(),
                      {{.kind = Kind::open, .text = "{"}, {.kind = Kind::close, .text = "}"}});
        content = fmt::format("<math displaystyle=\"true\" alttext=\"{}\">{}</math>",
                              escape_html(trimmed(latex_of_tokens(cells[column]))),
                              formula_.mathml(cell));
      }
      html += fmt::format("<td class=\"{}\">{}</td>", css, content);
    }
    html += "<td class=\"lit-equation-number\">" +
            (number.html.empty() ? "" : "(" + number.html + ")") + "</td></tr>\n";
  }
  block(equation_box({}, {}) + "<table class=\"lit-aligned\" role=\"presentation\">\n" + html +
        "</table></div>\n");
  is_continued_ = true;
}

}  // namespace literate
