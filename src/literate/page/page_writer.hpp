// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "literate/page/formula.hpp"
#include "literate/page/page.hpp"
#include "literate/page/tex_reader.hpp"

namespace literate {

/// Writes one page. Text goes into paragraphs as it comes; what is known only at the end, such as
/// the number behind a \ref, is a mark in the HTML until then.
class PageWriter {
 public:
  explicit PageWriter(const PageSources& sources);

  Page write();

 private:
  using Handler = void (PageWriter::*)(const PageToken&);
  using EnvironmentHandler = void (PageWriter::*)(const std::string&);

  /// What \label names.
  struct Target {
    std::string type;    ///< as cleveref calls it
    std::string number;  ///< HTML
    std::string title;   ///< HTML, for \nameref
    int id = -1;
  };
  struct Use {
    std::string id;
    int section = -1;  ///< the heading it stands under; none before the first
  };
  struct Heading {
    int level;  ///< 0 part, 1 section, 2 subsection, …
    std::string number;
    std::string title;
    int id;
  };
  struct Float {
    std::string kind;
    std::string caption, caption_words;
    int text = -1;  ///< among later_texts_: what describes its pictures
    bool has_content_before = false;
    bool has_floats = false;  ///< with captions of their own, side by side
    int id = -1;
    std::string figure;  ///< the first registered figure that it shows
  };
  struct Claim {
    std::string verdict, number, part, source, sentence;
  };
  struct Theorem {
    std::string title, counter;
  };
  struct Names {
    std::string one, many, capital_one, capital_many;
  };
  struct Column {
    std::string css_class;
    bool is_paragraph = false;
  };
  struct Cell {
    std::string html;
    std::string css_class;
    int span = 1;
    bool is_empty = true;
  };
  struct Row {
    std::vector<Cell> cells;
    bool is_head = false;
    bool has_rule_above = false;
    std::vector<std::pair<int, int>> rules_below;
  };
  /// What is set aside while a part of the page is written by itself.
  struct Aside;

  // page_writer.cpp: reading, and where HTML goes.
  void run();
  void take(const PageToken& token);
  void take_command(const PageToken& token);
  bool ignore(const std::string& name);
  void skip_dimension();
  void text(std::string_view characters);
  void html(std::string_view html);
  void block(std::string_view html);
  void flush();
  void ensure_paragraph();
  void end_paragraph();
  void open_inline(std::string_view tag);
  void close_inlines(std::size_t n_kept);
  void begin_group();
  void end_group();
  std::string inline_html(const PageTokens& tokens);
  std::string block_html(const PageTokens& tokens);
  std::string written(const PageTokens& tokens, bool is_inline);
  std::string plain_text(const PageTokens& tokens);
  void read_preamble_of(const PageTokens& tokens);
  PageTokens file_tokens(const std::string& path, bool is_generated);
  std::optional<std::string> found_file(const std::string& name, std::string_view ending) const;
  void complain(const PageToken& token, const std::string& message);
  int new_id(std::string fallback);
  static std::string id_mark(int id);
  std::string mark(char kind, std::string_view payload) const;
  void set_counter(const std::string& name, int value) { counters_[name] = value; }
  static const std::unordered_map<std::string_view, Handler>& handlers();
  static const std::unordered_map<std::string_view, EnvironmentHandler>& environments();

  // page_text.cpp
  void style_text(const PageToken& token);
  void style_from_here(const PageToken& token);
  void symbol(const PageToken& token);
  void accent(const PageToken& token);
  void line_break(const PageToken& token);
  void boxed(const PageToken& token);
  void rule(const PageToken& token);
  void footnote(const PageToken& token);
  void hyperlink(const PageToken& token);
  void colored(const PageToken& token);
  void number(const PageToken& token);
  void group_command(const PageToken& token);
  void input(const PageToken& token);
  void set_register(const PageToken& token);
  void condition(const PageToken& token);
  void metadata(const PageToken& token);
  void new_environment(const PageToken& token);
  void new_theorem(const PageToken& token);
  void math_operator(const PageToken& token);
  void package(const PageToken& token);
  void verbatim(const PageToken& token);

  // page_blocks.cpp
  void title(const PageToken& token);
  void heading(const PageToken& token);
  void appendix(const PageToken& token);
  void begin(const PageToken& token);
  void end(const PageToken& token);
  void plain_environment(const std::string& name);
  void abstract(const std::string& name);
  void list(const std::string& name);
  void quote(const std::string& name);
  void center(const std::string& name);
  void float_environment(const std::string& name);
  void write_float(const std::string& kind, const PageTokens& body);
  static std::string float_kind(const PageTokens& body, const std::string& otherwise);
  void theorem(const std::string& name);
  void caption(const PageToken& token);
  void label(const PageToken& token);
  std::string contents() const;

  // page_formulas.cpp
  void dollar(const PageToken& token);
  void inline_formula(const PageToken& token);
  void display_formula(const PageToken& token);
  void equation(const std::string& name);
  void equations(const std::string& name);
  std::string formula(const PageTokens& tokens, bool is_display);
  struct EquationNumber;
  EquationNumber take_number(PageTokens& tokens, bool is_numbered);
  bool formula_command(const PageToken& token, std::string& html);

  // page_tables.cpp
  void tabular(const std::string& name);
  std::vector<Column> read_columns(const PageTokens& specification);
  std::vector<Row> read_rows(const std::vector<Column>& columns);
  bool table_command(const PageToken& token, std::vector<Row>& rows, PageTokens& cell);
  void add_cell(Row& row, PageTokens& tokens, const std::vector<Column>& columns);
  std::string table_html(std::vector<Row> rows, const std::string& css_class,
                         const std::string& name);
  void table(const PageToken& token);
  void noted_table(const PageToken& token);
  void number_cell(const PageToken& token);
  void findings(const std::string& name);
  std::string finding_sentence(const std::string& key, const Claim& claim);

  // page_names.cpp: the commands of literate.sty.
  void define_name(const PageToken& token);
  void value(const PageToken& token);
  void raw_value(const PageToken& token);
  void flag(const PageToken& token);
  void statement(const PageToken& token);
  void claim(const PageToken& token);
  void finding_says(const PageToken& token);
  void limit_kind(const PageToken& token);
  void claim_count(const PageToken& token);
  void verdict_sign(const PageToken& token);
  void quoted(const PageToken& token);
  void ledger(const PageToken& token);
  void ledger_entry(const PageToken& token);
  void criterion(const PageToken& token);
  std::string limit_kind_html(const std::string& name);
  void value_index(const PageToken& token);
  void index_entry(const PageToken& token);
  void provenance(const PageToken& token);
  void provenance_entry(const PageToken& token);
  void repository(const PageToken& token);
  void figure(const PageToken& token);
  void picture(const PageToken& token);
  void excerpt(const PageToken& token);
  void listing(const PageToken& token);
  std::string claim_mark(const std::string& key, bool is_in_table);
  std::string use(const std::string& what);
  std::string uses_text(const std::string& what) const;
  static std::string sign_of(const std::string& verdict);
  static std::string short_verdict(const std::string& verdict);

  // page_references.cpp
  void reference(const PageToken& token);
  void clever_reference(const PageToken& token);
  void reference_names(const PageToken& token);
  void citation(const PageToken& token);
  void bibliography(const PageToken& token);
  void bibliography_items(const std::string& name);
  void finish_bibliography();
  void name_ids();
  std::string resolved(std::string_view html, int depth = 0) const;
  std::string resolved_mark(char kind, std::string_view payload, int depth) const;
  std::string resolved_clever(std::string_view payload) const;
  std::string resolved_citation(std::string_view payload) const;
  std::string link(const Target& target, const std::string& shown) const;
  Names names_of(const std::string& type) const;
  const Target* find_label(const std::string& key) const;
  std::string head();

  const PageSources& sources_;
  TexReader reader_;
  Formula formula_;
  FormulaSurroundings surroundings_;
  Page page_;
  PageToken author_place_;  ///< the last token that was read from the author's own files

  // What is being written.
  std::string out_;
  std::string text_;
  bool is_inline_ = false;
  bool in_paragraph_ = false;
  bool is_continued_ = false;
  bool is_code_ = false;
  bool is_preamble_ = true;
  bool is_appendix_ = false;
  bool is_in_part_ = false;
  std::vector<std::string> inlines_;
  std::vector<std::size_t> groups_;
  std::vector<std::string> environment_stack_;
  Float* float_ = nullptr;
  std::string table_name_;
  std::optional<PageTokens> long_caption_;
  std::string said_;
  std::string ledger_part_;

  // What the document and the program said.
  std::vector<std::string> files_;
  std::map<std::string, PageTokens> values_, raw_values_, quotations_, quoted_pages_, metadata_;
  std::map<std::string, bool> flags_;
  std::map<std::string, Claim> claims_;
  std::map<std::string, std::string> claim_counts_;
  std::map<std::string, PageTokens> finding_words_;
  std::map<std::string, PageTokens> limit_kinds_{{"derived", {}},    {"from printed digits", {}},
                                                 {"rounding", {}},   {"stated", {}},
                                                 {"convention", {}}, {"regression band", {}}};
  std::map<std::string, Theorem> theorems_;
  std::map<std::string, Names> reference_names_;
  std::set<std::string> package_options_;
  std::map<std::string, int> counters_{{"secnumdepth", 3}, {"tocdepth", 3}};

  // What is known at the end.
  Target target_;
  std::map<std::string, Target> labels_;
  std::vector<std::string> id_fallbacks_, id_labels_, ids_;
  std::vector<Heading> headings_;
  int last_level_ = 0;
  std::map<std::string, std::vector<Use>> uses_;
  std::set<std::string> printed_;  ///< ids that have no number: claim-KEY, val-KEY, figure.NAME
  std::vector<std::string> later_texts_;
  std::vector<std::string> cited_;
  std::vector<std::pair<PageToken, std::string>> wanted_labels_, wanted_citations_;
  std::map<std::string, std::string> bibliography_labels_;
  std::string bibliography_style_ = "plain";
  std::string bibliography_files_;
  std::string bibliography_html_;
  std::string description_;
};

}  // namespace literate
