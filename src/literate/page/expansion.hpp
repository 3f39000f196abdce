// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "literate/document/names.hpp"
#include "literate/page/latex_numbers.hpp"
#include "literate/prose/statements.hpp"
#include "literate/prose/tex_scanner.hpp"

namespace literate {

/// What a page is made of.
struct PageSources {
  std::filesystem::path document;   ///< folder of the LaTeX document
  std::string main_file;            ///< in it
  std::filesystem::path generated;  ///< what `compute` and `draw` wrote
  std::filesystem::path aux;        ///< of the PDF, with all its numbers
  std::filesystem::path engine;     ///< folder with filter.lua
  std::filesystem::path build;      ///< folder for the files that pandoc reads
  std::string known = {};           ///< definitions for what LaTeX does and a page does not
  std::string repository = {};      ///< the state of the repository, \LiterateRepository
};

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

/// Reads a document with the scanner of the lint. Most of what it knows is defined in known.tex, by
/// the commands that this class adds to TeX's own:
///
/// - \PageMark{open}{close}{LaTeX}, and the environment PageBlock{open}{close}, are HTML around
///   LaTeX; paragraphs in PageBlock* have elements of their own;
/// - \PageDefine{name}{LaTeX} and \PageUse[otherwise]{name} are a macro with any letters in its
///   name; \PageNames{1}{LaTeX}{\a\b} are macros of that many arguments;
/// - \PageIf{text}{LaTeX} is the LaTeX unless the text is empty;
/// - \PageNumber{counter} is the next number of the PDF, \PageBeside{bbl} a file beside its .aux.
///
/// Throws sys::InputError if the PDF, of which it takes all numbers, is of another state.
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
  /// A command or the beginning of an environment as it stands in the text, which goes on in `in`.
  struct Call {
    TexScanner& in;
    std::string name;  ///< of a command without its star, of an environment with it
    bool is_starred;
    std::vector<std::string_view> arguments = {};
    std::vector<std::optional<std::string_view>> options = {};

    std::string operator[](std::size_t i) const { return std::string(arguments[i]); }
    std::string_view option(std::size_t i = 0) const { return options[i].value_or(""); }
  };
  using Handler = std::function<void(const Call& call)>;
  struct Construct {
    std::string_view form;  ///< its arguments in their order, «o» in brackets and «m» others
    Handler handler;
  };
  using Constructs = std::map<std::string, Construct, std::less<>>;

  // The scanner's tokens.
  void read_file(const std::filesystem::path& file);
  void read_preamble(std::string_view text);
  std::filesystem::path file_of(std::string_view name) const;
  void read_all(std::string_view text);
  void read(TexScanner& in, const TexToken& token);
  void verbatim(const TexToken& token);
  void read_command(TexScanner& in, const TexToken& token);
  void read_begin(TexScanner& in, const TexToken& token);
  bool begin_environment(TexScanner& in, const TexToken& token);
  void read_end(const TexToken& token);
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

  // Each adds what it knows of to the commands and environments.
  void know_definitions();
  void know_registered();
  void know_title();
  void know_numbered();
  void know_references();
  void know_quantities();
  using NameList = std::initializer_list<std::string_view>;
  void know(const NameList& names, std::string_view form, const Handler& handler) {
    for (const std::string_view name : names) commands_[std::string(name)] = {form, handler};
  }
  void know_in_preamble(const NameList& names, std::string_view form, const Handler& handler) {
    know(names, form, handler);
    definitions_.insert(names);
  }
  void know_environments(const NameList& names, std::string_view form, const Handler& handler) {
    for (const std::string_view name : names) environments_[std::string(name)] = {form, handler};
  }
  static void call(const Construct& construct, TexScanner& in, const TexToken& token);

  static Macro macro_of(const Call& call);
  void define(const std::string& name, Macro macro);
  void begin_group() { groups_.emplace_back(); }
  void end_group();
  std::string typed_number(std::string_view latex);
  void require_default_options(const Call& call);
  std::optional<bool> compared(TexScanner& in, std::string_view kind);
  std::vector<std::string> claims_of(bool is_cited) const;
  void picture_environment(TexScanner& in, const TexToken& token);
  std::string title_marks(std::string_view labels) const;
  std::string author_lines() const;
  bool is_revtex() const { return class_.starts_with("revtex"); }
  void formula(TexScanner& in, std::string_view end);
  void show_note(std::size_t number, std::string_view latex);
  void show_caption(const std::string& counter, const Call& call);
  std::vector<Row> rows_of_display(std::string_view body, bool is_one = false);
  void show_display(const std::string& environment, std::vector<Row> rows);
  std::string link_to(const std::string& key, const std::string& latex);
  std::string number_of(const std::string& key) const;
  std::vector<std::pair<std::string, bool>> cited_in_order(std::vector<std::string> keys) const;

  const PageSources& sources_;
  Constructs commands_, environments_;
  std::set<std::string_view> definitions_;  ///< commands that count in the preamble
  std::vector<std::string> limits_;         ///< letters of the ledger's limits as they were read
  std::set<std::string> listed_;            ///< whether ledger and index are shown: claim-, val-
  nlohmann::json registered_;               ///< names.json
  Names names_;
  LatexNumbers numbers_;
  std::map<std::string, NumberedStatement> statements_;
  std::vector<std::string> claim_order_;
  std::map<std::string, Macro, std::less<>> macros_, own_environments_;
  /// What the open groups of LaTeX have defined anew, as it was before.
  std::vector<std::map<std::string, std::optional<Macro>>> groups_;
  std::set<std::string, std::less<>> picture_environments_;
  std::vector<AuthorGroup> author_groups_;
  std::vector<std::string> authors_;  ///< their names alone, LaTeX
  std::map<std::pair<std::string, std::string>, std::vector<Use>> uses_;
  std::vector<std::string> notes_;
  Expanded result_;
  std::string* out_;
  std::string_view file_text_, at_;  ///< the file that is read, and where
  std::string file_name_;
  std::vector<Float> floats_;
  std::vector<std::pair<std::string, int>> lists_;  ///< counters of the open lists, items so far
  std::vector<std::pair<std::string, std::function<void()>>> ends_;  ///< of the open environments
  std::string section_;
  std::string class_;
  bool is_math_ = false, is_author_year_ = false, sorts_citations_ = false,
       compresses_citations_ = false, has_parts_ = false, has_chapters_ = false;
  int depth_ = 0, n_notes_among_sources_ = 0;
};

/// A printed quantity, such as «-1.2e-6 lbf/in», as LaTeX for text or for mathematics.
std::string quantity_latex(std::string_view printed, bool is_math);

namespace page_reading {

/// The next argument without its braces; of an argument without braces its one character or
/// command.
std::string_view argument(TexScanner& in);

/// An argument in brackets; none if there is no bracket, over at most one line end.
std::optional<std::string_view> option(TexScanner& in);

/// The names between commas or other separators, without blanks.
std::vector<std::string> names_in(std::string_view text, char separator = ',');

}  // namespace page_reading
}  // namespace literate
