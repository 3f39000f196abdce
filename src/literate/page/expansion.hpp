// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "literate/document/names.hpp"
#include "literate/page/latex_numbers.hpp"
#include "literate/page/page_sources.hpp"
#include "literate/prose/quotations.hpp"
#include "literate/prose/statements.hpp"
#include "literate/prose/tex_scanner.hpp"

namespace literate {

/// HTML around a piece of LaTeX. In the LaTeX it is \href{lit:number}{piece}; a block is a center
/// environment that begins with an empty one.
struct PageMark {
  std::string open, close;
  bool is_plain = false;      ///< whether the block's own paragraphs have no element
  std::string language = {};  ///< of a listing, whose code is `open`
  int first_line = 0;         ///< of a listing that has numbers
};

/// A document of which all is expanded that the engine or the document itself defines, so that
/// pandoc need not know it, with marks where HTML goes.
struct Expanded {
  std::string latex;
  std::vector<PageMark> marks;
  std::vector<std::string> figures;             ///< registered ones that it shows
  std::vector<std::string> pictures;            ///< others, as the document names them
  std::vector<std::string> typeset;             ///< environments that LaTeX sets as pictures
  std::vector<std::string> errors;              ///< «file:line:column: what is wrong»
  std::map<std::string, std::string> formulas;  ///< places of formulas, by their TeX without blanks
  std::map<std::string, std::string, std::less<>> commands;  ///< where each was first met
};

/// Reads a document with the scanner of the lint. Throws sys::InputError if the PDF, of which it
/// takes all numbers, is of another state.
class Expander {
 public:
  explicit Expander(const PageSources& sources);
  Expanded expand();

 private:
  struct Macro {
    std::size_t n_arguments = 0;
    bool has_default = false;
    std::string first_default = {}, body = {}, end = {};  ///< `end` of an environment
  };
  struct Theorem {
    std::string name, counter;
    bool is_numbered = true;
  };
  struct Float {
    std::string counter;
    std::size_t mark;
    bool has_caption = false;
    std::string outer = {};  ///< its counter outside a minipage that has another
  };
  struct Row {
    std::string latex, label, tag;
    bool is_numbered = true;
  };
  struct Use {
    std::string id, section;
  };
  /// Authors who stand together in the title, and the lines below them.
  struct AuthorGroup {
    std::vector<std::string> authors = {}, lines = {};  ///< LaTeX
  };
  using Handler = void (Expander::*)(TexScanner& in, const TexToken& token);
  static const std::map<std::string_view, Handler>& commands();
  static const std::map<std::string_view, Handler>& environments();

  // The scanner's tokens, and arguments behind them.
  void read_file(const std::filesystem::path& file);
  void read_preamble(std::string_view text);
  std::filesystem::path file_of(std::string_view name) const;
  void read_all(std::string_view text);
  void read(TexScanner& in, const TexToken& token);
  void verbatim(const TexToken& token);
  void read_command(TexScanner& in, const TexToken& token);
  void read_begin(TexScanner& in, const TexToken& token);
  void read_end(TexScanner& in, const TexToken& token);
  void use_macro(TexScanner& in, const Macro& macro);
  std::string filled(TexScanner& in, const Macro& macro) const;
  std::string_view body_of(TexScanner& in, std::string_view name) const;
  std::string expanded(std::string_view text);
  void emit(std::string_view text);
  void fail(const std::string& message);
  void hold_against(const std::string& key, const std::string& number, const std::string& what);
  std::string place() const;

  // Marks.
  std::size_t mark(std::string open, std::string close = {}, bool is_plain = false);
  std::string marked(std::string open, std::string_view latex, std::string close);
  void begin_block(std::string open, std::string close, bool is_plain = true);
  void end_block();
  void fragment(std::string_view html);
  void listing(std::string code, const std::string& language, int first_line);
  std::string use_id(const std::string& kind, const std::string& name);
  std::string uses(const std::string& kind, const std::string& name) const;
  void finish();

  // Definitions and conditions.
  Macro macro_at(TexScanner& in) const;
  void define(TexScanner&, const TexToken&);
  void define_by_pattern(TexScanner&, const TexToken&);
  void define_environment(TexScanner&, const TexToken&);
  void define_theorem(TexScanner&, const TexToken&);
  void define_operator(TexScanner&, const TexToken&);
  void set_picture(TexScanner&, const TexToken&);
  void document_class(TexScanner&, const TexToken&);
  void package(TexScanner&, const TexToken&);
  void condition(TexScanner&, const TexToken&);
  void letter_region(TexScanner&, const TexToken&);

  // What the engine defines.
  void value(TexScanner&, const TexToken&);
  void raw_value(TexScanner&, const TexToken&);
  void flag(TexScanner&, const TexToken&);
  void modified(TexScanner&, const TexToken&);
  void repository(TexScanner&, const TexToken&);
  void quoted(TexScanner&, const TexToken&);
  void statement(TexScanner&, const TexToken&);
  void claim(TexScanner&, const TexToken&);
  void verdict_sign(TexScanner&, const TexToken&);
  void claim_count(TexScanner&, const TexToken&);
  void finding_says(TexScanner&, const TexToken&);
  void finding(TexScanner&, const TexToken&);
  void findings(TexScanner&, const TexToken&);
  void limit_kind(TexScanner&, const TexToken&);
  void limit(TexScanner&, const TexToken&);
  void sentence(TexScanner&, const TexToken&);
  void ledger(TexScanner&, const TexToken&);
  void index(TexScanner&, const TexToken&);
  void provenance(TexScanner&, const TexToken&);
  void provenance_file(TexScanner&, const TexToken&);
  void table(TexScanner&, const TexToken&);
  void figure(TexScanner&, const TexToken&);
  void picture(TexScanner&, const TexToken&);
  void picture_environment(TexScanner&, const TexToken&);
  void excerpt(TexScanner&, const TexToken&);
  std::string claim_mark(const std::string& id);
  void ledger_part(bool is_cited);

  // The title.
  void metadata(TexScanner&, const TexToken&);
  void title_line(TexScanner&, const TexToken&);
  std::string title_marks(std::string_view labels) const;
  void add_author(std::string_view text, const std::string& marks);
  void author_name(TexScanner&, const TexToken&);
  std::string author_lines() const;
  void title(TexScanner&, const TexToken&);
  void abstract(TexScanner&, const TexToken&);
  bool is_revtex() const { return class_.starts_with("revtex"); }

  // What LaTeX numbers, and what cites it.
  void heading(TexScanner&, const TexToken&);
  void bookmark_setup(TexScanner&, const TexToken&);
  void appendix(TexScanner&, const TexToken&);
  std::string appendix_word(std::string_view heading) const;
  /// REVTeX prints neither «Abstract» nor «References».
  bool has_heads() const { return !is_revtex(); }
  void label(TexScanner&, const TexToken&);
  void reference(TexScanner&, const TexToken&);
  void clever_reference(TexScanner&, const TexToken&);
  void clever_range(TexScanner&, const TexToken&);
  std::string link_to(const std::string& key, const std::string& latex);
  std::string number_of(const std::string& key) const;
  std::vector<std::pair<std::string, bool>> cited_in_order(std::vector<std::string> keys) const;
  void citation(TexScanner&, const TexToken&);
  void bibliography(TexScanner&, const TexToken&);
  void bibliography_items(TexScanner&, const TexToken&);
  void footnote(TexScanner&, const TexToken&);
  void caption(TexScanner&, const TexToken&);
  void subfloat(TexScanner&, const TexToken&);
  void caption_setup(TexScanner&, const TexToken&);
  void item(TexScanner&, const TexToken&);
  void list(TexScanner&, const TexToken&);
  void float_environment(TexScanner&, const TexToken&);
  void theorem(TexScanner&, const TexToken&);
  void proof(TexScanner&, const TexToken&);
  void transparent(TexScanner&, const TexToken&);
  void tabular(TexScanner&, const TexToken&);
  void rows_of_tabular(std::string_view body, const std::vector<std::string>& between);
  void input(TexScanner&, const TexToken&);

  // Formulas and numbers.
  void formula(TexScanner& in, std::string_view end);
  void display(TexScanner&, const TexToken&);
  std::vector<Row> rows_of_display(std::string_view body);
  void show_display(const std::string& environment, std::vector<Row> rows);
  void number(TexScanner&, const TexToken&);
  void ensure_math(TexScanner&, const TexToken&);
  void unit(TexScanner&, const TexToken&);
  void unbroken(const std::string& latex);
  void boxed(TexScanner&, const TexToken&);
  void skip_length(TexScanner&, const TexToken&);
  void rule(TexScanner&, const TexToken&);
  void step_counter(TexScanner&, const TexToken&);
  void set_counter(TexScanner&, const TexToken&);
  void remove_blanks(TexScanner&, const TexToken&);

  const PageSources& sources_;
  nlohmann::json registered_;  ///< names.json
  Names names_;
  LatexNumbers numbers_;
  std::map<std::string, NumberedStatement> statements_;
  std::vector<std::string> claim_order_;
  std::map<std::string, Quotation> quotations_;
  std::map<std::string, Macro, std::less<>> macros_, own_environments_;
  std::map<std::string, Theorem, std::less<>> theorems_;
  std::set<std::string, std::less<>> picture_environments_;
  std::map<std::string, std::string> metadata_, findings_, limits_;
  std::vector<AuthorGroup> author_groups_;
  std::map<std::pair<std::string, std::string>, std::vector<Use>> uses_;
  std::set<std::string> ids_;
  std::vector<std::string> notes_;
  Expanded result_;
  std::string* out_;
  std::string_view file_text_, at_;  ///< the file that is read, and where
  std::string file_name_;
  std::vector<Float> floats_;
  std::vector<std::pair<std::string, int>> lists_;  ///< counters of the open lists, items so far
  std::vector<std::pair<std::string, std::string>> ends_;  ///< what ends the open environments
  std::string section_;
  std::string class_;
  bool is_math_ = false, is_modified_ = false, is_appendix_ = false, is_author_year_ = false,
       has_round_citations_ = false, sorts_citations_ = false, compresses_citations_ = false,
       has_parts_ = false, has_chapters_ = false, has_title_ = false;
  int depth_ = 0, n_notes_among_sources_ = 0;
};

/// A printed quantity, such as «-1.2e-6 lbf/in», as LaTeX for text or for mathematics.
std::string quantity_latex(std::string_view printed, bool is_math);

}  // namespace literate
