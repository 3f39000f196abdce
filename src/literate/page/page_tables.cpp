// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "literate/page/html_text.hpp"
#include "literate/page/page_numbers.hpp"
#include "literate/page/page_writer.hpp"
#include "literate/text/characters.hpp"

namespace literate {
namespace {

// Whether a piece of HTML shows formulas and nothing else, of which assistive software makes no
// name.
bool is_formula(std::string html) {
  for (auto begin = html.find("<math"); begin != std::string::npos; begin = html.find("<math")) {
    constexpr std::string_view end_tag = "</math>";
    const auto end = html.find(end_tag, begin);
    if (end == std::string::npos) return false;
    html.erase(begin, end + end_tag.size() - begin);
  }
  return text_of_html(html).find_first_not_of(' ') == std::string::npos;
}

// Gives formulas in a heading a name, since assistive software takes none from MathML's elements.
std::string spoken_formulas(const std::string& html) {
  constexpr std::string_view begin_tag = "<math", end_tag = "</math>";
  std::string spoken;
  std::size_t done = 0;
  for (auto begin = html.find(begin_tag); begin != std::string::npos;
       begin = html.find(begin_tag, done)) {
    const auto end = html.find(end_tag, begin) + end_tag.size();
    const std::string name = escape_html(text_of_html(html.substr(begin, end - begin)));
    begin += begin_tag.size();
    spoken += html.substr(done, begin - done) + " aria-label=\"" + name + "\"" +
              html.substr(begin, end - begin);
    done = end;
  }
  return spoken + html.substr(done);
}

using Kind = PageToken::Kind;

std::string_view class_of(char alignment) {
  if (alignment == 'c') return "lit-middle";
  return alignment == 'r' ? "lit-right" : "lit-left";
}

}  // namespace

std::vector<PageWriter::Column> PageWriter::read_columns(const PageTokens& specification) {
  std::vector<Column> columns;
  std::vector<PageToken> rest = reader_.set_aside();
  reader_.push(specification);
  while (std::optional<PageToken> token = reader_.next()) {
    if (!token->is(Kind::character)) continue;
    const char kind = token->text.front();
    if (kind == '@' || kind == '!' || kind == '>' || kind == '<') {
      reader_.argument();
    } else if (kind == 'l' || kind == 'c' || kind == 'r' || kind == 'S') {
      columns.push_back({std::string(class_of(kind)), false});
    } else if (kind == 'p' || kind == 'm' || kind == 'b' || kind == 'X') {
      if (kind != 'X') reader_.argument();
      columns.push_back({"lit-paragraph", true});
    } else if (kind == '*') {
      const int n = std::atoi(reader_.text_argument().c_str());
      const PageTokens repeated = reader_.argument();
      for (int i = 0; i < n; ++i) reader_.push(repeated);
    }
  }
  reader_.take_back(std::move(rest));
  return columns;
}

void PageWriter::tabular(const std::string& name) {
  if (name == "tabular*" || name == "tabularx") reader_.argument();
  reader_.optional_argument();
  const std::vector<Column> columns = read_columns(reader_.argument());
  const PageTokens body = reader_.environment_body(name);
  std::vector<PageToken> rest = reader_.set_aside();
  const std::string table_name = std::exchange(table_name_, {});
  reader_.push(body);
  std::vector<Row> rows = read_rows(columns);
  reader_.take_back(std::move(rest));
  block(table_html(std::move(rows), "lit-table", table_name));
}

void PageWriter::add_cell(Row& row, PageTokens& tokens, const std::vector<Column>& columns) {
  Cell cell;
  std::size_t column = 0;
  for (const Cell& before : row.cells) column += static_cast<std::size_t>(before.span);
  bool is_paragraph = column < columns.size() && columns[column].is_paragraph;
  if (column < columns.size()) cell.css_class = columns[column].css_class;
  const auto first = std::ranges::find_if_not(
      tokens, [](const PageToken& token) { return token.is(Kind::space); });
  const bool is_number = first != tokens.end() && (first->is_command("LiterateCell") ||
                                                   first->is_command("LiterateMarkedCell"));
  if (first != tokens.end() && first->is_command("multicolumn")) {
    std::vector<PageToken> rest = reader_.set_aside();
    reader_.push(PageTokens(first + 1, tokens.end()));
    cell.span = std::max(std::atoi(reader_.text_argument().c_str()), 1);
    const std::vector<Column> own = read_columns(reader_.argument());
    if (!own.empty()) cell.css_class = own.front().css_class;
    is_paragraph = !own.empty() && own.front().is_paragraph;
    tokens = reader_.argument();
    reader_.take_back(std::move(rest));
  }
  cell.is_empty = is_blank(tokens);
  if (!cell.is_empty) {
    cell.html = is_paragraph ? without_paragraph(block_html(tokens)) : inline_html(tokens);
  }
  if (is_number) cell.css_class += " lit-numeric";
  cell.is_empty = cell.html.empty();
  row.cells.push_back(std::move(cell));
  tokens.clear();
}

// Does what a command between cells does; false for one that belongs to the cell.
bool PageWriter::table_command(const PageToken& token, std::vector<Row>& rows, PageTokens& cell) {
  const std::string& name = token.text;
  Row& row = rows.back();
  if (name == "toprule" || name == "bottomrule" || name == "hline" || name == "midrule" ||
      name == "specialrule") {
    reader_.optional_argument();
    const bool is_first_rule = name == "hline" && rows.size() == 1;
    const bool has_head = std::ranges::any_of(rows, &Row::is_head);
    if ((name == "midrule" || name == "hline") && !is_first_rule && !has_head) {
      for (Row& above : rows) above.is_head = !above.cells.empty();
    } else if (name == "midrule" || name == "hline") {
      row.has_rule_above = true;
    }
  } else if (name == "cmidrule" || name == "cline") {
    if (reader_.peek() != nullptr && reader_.peek()->is_character("(")) {
      while (reader_.peek() != nullptr && !reader_.next()->is_character(")")) {
      }
    }
    const std::string range = reader_.text_argument();
    const int first = std::atoi(range.c_str());
    const std::size_t dash = range.find('-');
    const int last = dash == std::string::npos ? first : std::atoi(range.c_str() + dash + 1);
    if (rows.size() > 1) rows[rows.size() - 2].rules_below.emplace_back(first, last);
  } else if (name == "LiterateLongCaption") {
    if (long_caption_ && float_ != nullptr) {
      const PageTokens words = *std::exchange(long_caption_, std::nullopt);
      PageToken caption_token = token;
      caption_token.text = "caption";
      std::vector<PageToken> rest = reader_.set_aside();
      PageToken brace = token;
      brace.kind = Kind::close;
      brace.text = "}";
      reader_.push(brace);
      reader_.push(words);
      brace.kind = Kind::open;
      brace.text = "{";
      reader_.push(brace);
      caption(caption_token);
      reader_.take_back(std::move(rest));
    }
  } else if (name == "endfirsthead") {
    for (Row& above : rows) above.is_head = !above.cells.empty();
  } else if (name == "endhead" || name == "endfoot" || name == "endlastfoot") {
    // What is repeated on each page of paper stands once on a page that is one: rows that were not
    // there when the first head ended are dropped.
    std::erase_if(rows, [](const Row& above) { return !above.is_head; });
    rows.emplace_back();
    cell.clear();
  } else if (name == "addlinespace" || name == "noalign") {
    if (name == "addlinespace")
      reader_.optional_argument();
    else
      reader_.argument();
  } else {
    return false;
  }
  return true;
}

std::vector<PageWriter::Row> PageWriter::read_rows(const std::vector<Column>& columns) {
  std::vector<Row> rows(1);
  PageTokens cell;
  int depth = 0;
  while (std::optional<PageToken> token = reader_.next()) {
    if (token->is(Kind::open)) ++depth;
    if (token->is(Kind::close)) --depth;
    if (depth > 0 || !(token->is(Kind::command) || token->is(Kind::align))) {
      cell.push_back(*std::move(token));
      continue;
    }
    if (token->is_command("begin")) {
      const PageTokens name = reader_.argument();
      const PageTokens inner = reader_.environment_body(latex_of_tokens(name));
      const auto braced = [&](const PageTokens& tokens) {
        PageToken brace = *token;
        brace.kind = Kind::open;
        brace.text = "{";
        cell.push_back(brace);
        cell.insert(cell.end(), tokens.begin(), tokens.end());
        brace.kind = Kind::close;
        brace.text = "}";
        cell.push_back(brace);
      };
      cell.push_back(*token);
      braced(name);
      cell.insert(cell.end(), inner.begin(), inner.end());
      PageToken end_token = *token;
      end_token.text = "end";
      cell.push_back(end_token);
      braced(name);
    } else if (token->is(Kind::align)) {
      add_cell(rows.back(), cell, columns);
    } else if (token->is_command("\\") || token->is_command("tabularnewline")) {
      reader_.star();
      reader_.optional_argument();
      add_cell(rows.back(), cell, columns);
      rows.emplace_back();
    } else if (token->is_command("ifflag")) {
      flag(*token);
    } else if (table_command(*token, rows, cell)) {
      continue;
    } else if (reader_.knows(token->text) && token->text != "LiterateFindingsHead") {
      reader_.expand(token->text);
    } else if (token->is_command("label") && is_blank(cell)) {
      label(*token);
    } else {
      cell.push_back(*std::move(token));
    }
  }
  if (!is_blank(cell)) add_cell(rows.back(), cell, columns);
  std::erase_if(rows, [](const Row& row) { return row.cells.empty(); });
  return rows;
}

std::string PageWriter::table_html(std::vector<Row> rows, const std::string& css_class,
                                   const std::string& name) {
  const auto row_html = [&](const Row& row) {
    std::string html = row.has_rule_above ? "<tr class=\"lit-rule-above\">" : "<tr>";
    int column = 1;
    for (const Cell& cell : row.cells) {
      const bool has_rule = std::ranges::any_of(row.rules_below, [&](const auto& rule) {
        return column >= rule.first && column <= rule.second;
      });
      // A heading without words would be read out as one.
      const bool is_heading = row.is_head && !cell.is_empty;
      std::string attributes =
          " class=\"" + cell.css_class + (has_rule ? " lit-rule-below" : "") + "\"";
      if (cell.span > 1) attributes += fmt::format(" colspan=\"{}\"", cell.span);
      if (is_heading) attributes += cell.span > 1 ? " scope=\"colgroup\"" : " scope=\"col\"";
      html +=
          fmt::format("<{0}{1}>{2}</{0}>", is_heading ? "th" : "td", attributes,
                      is_heading && is_formula(cell.html) ? spoken_formulas(cell.html) : cell.html);
      column += cell.span;
    }
    return html + "</tr>\n";
  };
  std::string head, body;
  for (const Row& row : rows) (row.is_head ? head : body) += row_html(row);
  const std::string data = name.empty() ? "" : " data-table=\"" + escape_html(name) + "\"";
  // What is read out where the table is reached by the keyboard: its caption.
  std::string spoken = name.empty() ? "table" : "table " + escape_html(name);
  if (float_ != nullptr && float_->text >= 0) spoken = mark('a', std::to_string(float_->text));
  return fmt::format(
      "<div class=\"lit-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{}\">\n<table "
      "class=\"{}\"{}>\n{}<tbody>\n{}</tbody>\n</table>\n</div>\n",
      spoken, css_class, data, head.empty() ? "" : "<thead>\n" + head + "</thead>\n", body);
}

// \tab[caption]{name}
void PageWriter::table(const PageToken& token) {
  const auto caption_tokens = reader_.optional_argument();
  const std::string name = reader_.text_argument();
  const auto file = found_file("tables/" + name + ".tex", "");
  if (!file) return complain(token, "{" + name + "}: there is no table of this name");
  const PageTokens tokens = file_tokens(*file, true);
  table_name_ = name;
  if (!caption_tokens) {
    block(block_html(tokens));
  } else {
    long_caption_ = caption_tokens;
    Float contents;
    contents.kind = "table";
    Float* const outside = std::exchange(float_, &contents);
    const std::string table_block = block_html(tokens);
    float_ = outside;
    const std::string id = contents.id < 0 ? "" : " id=\"" + id_mark(contents.id) + "\"";
    block("<figure class=\"lit-table-float\"" + id + ">\n<figcaption>" + contents.caption +
          "</figcaption>\n" + table_block + "</figure>\n");
  }
  table_name_.clear();
}

void PageWriter::noted_table(const PageToken& token) {
  if (token.text == "LiterateNoted") {
    const PageTokens table_tokens = reader_.argument();
    const PageTokens notes = reader_.argument();
    const std::string table_block = block_html(table_tokens);
    block(table_block + "<div class=\"lit-table-notes\">\n" + block_html(notes) + "</div>\n");
    return;
  }
  if (token.text == "LiterateMark") {
    html("<sup>" + inline_html(reader_.argument()) + "</sup>");
    return;
  }
  const PageTokens mark_tokens = reader_.argument();
  const PageTokens words = reader_.argument();
  end_paragraph();
  if (!mark_tokens.empty()) html("<sup>" + inline_html(mark_tokens) + "</sup> ");
  html(inline_html(words));
  end_paragraph();
}

void PageWriter::number_cell(const PageToken& token) {
  const std::string format = reader_.text_argument();
  const PageTokens cell = reader_.argument();
  reader_.argument();
  const std::string mark_html =
      token.text == "LiterateMarkedCell" ? inline_html(reader_.argument()) : "";
  html(number_cell_html(format, latex_of_tokens(cell), mark_html));
}

// What was stated, in the words of \findingsays or those of the ledger.
std::string PageWriter::finding_sentence(const std::string& key, const Claim& claim) {
  const auto said = finding_words_.find(key);
  if (said != finding_words_.end()) return inline_html(said->second);
  const std::string source = inline_html(page_tokens(claim.source));
  return inline_html(page_tokens(claim.sentence)) +
         (source.empty() ? "" : " <span class=\"lit-ledger-source\">(" + source + ")</span>");
}

// The table of what matters most: \finding[where]{id}{what was found}.
void PageWriter::findings(const std::string& name) {
  const PageTokens body = reader_.environment_body(name);
  const std::vector<Column> columns{
      {"lit-paragraph", true}, {"lit-paragraph", true}, {"lit-left", false}, {"lit-left", false}};
  std::vector<PageToken> rest = reader_.set_aside();
  reader_.expand("LiterateFindingsHead");
  std::vector<Row> rows = read_rows(columns);
  for (Row& row : rows) row.is_head = true;
  reader_.push(body);
  while (std::optional<PageToken> token = reader_.next()) {
    if (token->is_command("ifflag")) {
      flag(*token);
      continue;
    }
    if (!token->is_command("finding")) continue;
    const auto where = reader_.optional_argument();
    const std::string key = reader_.text_argument();
    const PageTokens found = reader_.argument();
    const auto claim_found = claims_.find(key);
    if (claim_found == claims_.end()) {
      complain(*token, "{" + key + "}: there is no claim of this name");
      continue;
    }
    Row row;
    row.cells.push_back({.html = finding_sentence(key, claim_found->second),
                         .css_class = "lit-paragraph",
                         .is_empty = false});
    row.cells.push_back(
        {.html = inline_html(found), .css_class = "lit-paragraph", .is_empty = false});
    row.cells.push_back(
        {.html = claim_mark(key, true), .css_class = "lit-left", .is_empty = false});
    row.cells.push_back(
        {.html = where ? inline_html(*where) : "", .css_class = "lit-left", .is_empty = !where});
    rows.push_back(std::move(row));
  }
  reader_.take_back(std::move(rest));
  block(table_html(std::move(rows), "lit-table lit-findings", ""));
}

}  // namespace literate
