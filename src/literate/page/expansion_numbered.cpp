// SPDX-License-Identifier: GPL-3.0-or-later
// What LaTeX numbers: headings, notes, captions, lists and formulas.
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>

#include "literate/page/expansion.hpp"
#include "literate/page/html_text.hpp"
#include "system/error.hpp"
#include "system/text.hpp"

namespace literate {
using namespace page_reading;

void Expander::formula(TexScanner& in, std::string_view end) {
  const std::string_view text = in.rest();
  while (const auto token = in.next()) {
    const bool is_end =
        token->text == end && (token->kind == TexKind::dollar || token->kind == TexKind::symbol);
    if (!is_end) continue;
    const std::string_view body =
        text.substr(0, static_cast<std::size_t>(token->text.data() - text.data()));
    if (end == "\\]" || end == "$$") {
      std::vector<Row> rows = rows_of_display(body);
      for (Row& row : rows) row.is_numbered = false;
      return show_display("equation", std::move(rows));
    }
    is_math_ = true;
    const std::string latex = expanded(body);
    is_math_ = false;
    result_.formulas.emplace(without_blanks(latex), place());
    return emit("$" + latex + "$");
  }
  throw sys::InputError(fmt::format("{}: a formula has no end", place()));
}

std::vector<Expander::Row> Expander::rows_of_display(std::string_view body) {
  std::vector<Row> rows(1);
  const bool outer = std::exchange(is_math_, true);
  std::string* const out = out_;
  out_ = &rows.back().latex;
  TexScanner in(body);
  for (int depth = 0; auto token = in.next();) {
    Row& row = rows.back();
    if (token->kind == TexKind::begin) ++depth;
    if (token->kind == TexKind::end) --depth;
    if (token->text == "\\\\" && depth == 0) {
      option(in);
      rows.emplace_back();
      // The vector may have moved its rows.
      out_ = &rows.back().latex;
    } else if (token->name == "label") {
      row.label = argument(in);
    } else if (token->name == "tag") {
      const bool is_bare = token->text.ends_with('*');
      const std::string tag(argument(in));
      row.tag = is_bare ? tag : "(" + tag + ")";
    } else if (token->name == "nonumber" || token->name == "notag") {
      row.is_numbered = false;
    } else {
      read(in, *token);
    }
  }
  out_ = out;
  is_math_ = outer;
  if (rows.size() > 1 && sys::stripped(rows.back().latex).empty()) rows.pop_back();
  return rows;
}

void Expander::show_display(const std::string& environment, std::vector<Row> rows) {
  std::string latex, numbers;
  bool has_numbers = false;
  for (Row& row : rows) {
    latex += (latex.empty() ? "" : "\\\\\n") + row.latex;
    if (row.tag.empty() && row.is_numbered) {
      row.tag = "(" + numbers_.take("equation").number + ")";
    }
    if (!row.label.empty()) {
      const std::string& known = numbers_.label(row.label).number;
      if (row.tag != "(" + known + ")") hold_against(row.label, row.tag, "equation ");
    }
    has_numbers = has_numbers || !row.tag.empty();
    const std::string id =
        row.label.empty() ? "" : fmt::format(" id=\"{}\"", escape_html(row.label));
    const char* kind = row.tag.empty() ? "" : " class=\"lit-equation-number\"";
    numbers += marked(fmt::format("<span{}{}>", kind, id), row.tag, "</span>");
  }
  result_.formulas.emplace(without_blanks(latex), place());
  const bool is_plain = environment == "equation" && rows.size() == 1;
  const std::string formula =
      is_plain ? "\\[" + latex + "\\]"
               : fmt::format("\\begin{{{0}*}}{1}\\end{{{0}*}}", environment, latex);
  begin_block("<div class=\"lit-equation\" tabindex=\"0\" role=\"group\" aria-label=\"formula\">",
              "</div>");
  emit(formula);
  if (has_numbers) emit(marked("<span class=\"lit-equation-numbers\">", numbers, "</span>"));
  end_block();
}

void Expander::know_numbered() {
  // \bookmarksetup{startatroot}: what follows is in no part.
  know({"bookmarksetup"}, [this](TexScanner& in, const TexToken&) {
    for (const std::string& setting : names_in(argument(in))) {
      if (setting == "startatroot") has_parts_ = false;
    }
  });
  // Levels of headings follow each other, since assistive software reads them so: with parts or
  // chapters a section is deeper than before the first of them.
  know({"part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"},
       [this](TexScanner& in, const TexToken& token) {
         static const std::vector<std::string> names{"part",        "chapter",       "section",
                                                     "subsection",  "subsubsection", "paragraph",
                                                     "subparagraph"};
         const std::string name(token.name);
         const bool is_starred = token.text.ends_with('*');
         option(in);
         const std::string text = expanded(argument(in));
         // IEEEtran prints no heading of a section in its one appendix.
         if (name == "section" && !is_starred && macros_.contains("PageOneAppendix")) return;
         std::string number, printed;
         if (!is_starred && numbers_.next(name)) {
           const PrintedNumber found = numbers_.take(name);
           number = found.number;
           const bool has_word = name == "part" || name == "chapter";
           const std::string word = name == "section" ? "\\PageSectionWord{}" : "";
           printed = expanded(has_word ? found.shown + "~" + number
                                       : word + (found.shown.empty() ? number : found.shown));
         }
         const auto level =
             static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
         if (level <= 2) section_ = expanded(number);
         if (level > 4) {
           return emit(
               fmt::format("\n\n{}\\textbf{{{}}} ", printed.empty() ? "" : printed + " ", text));
         }
         has_parts_ = has_parts_ || level == 0;
         has_chapters_ = has_chapters_ || level == 1;
         const std::size_t above = level == 0 ? 0 : (has_parts_ ? 1 : 0);
         const std::size_t depth = above + (level < 2 ? 0 : level - 2 + (has_chapters_ ? 1 : 0));
         const std::string mark =
             printed.empty() ? "" : marked("<span class=\"lit-number\">", printed, "</span>");
         emit(fmt::format("\n\n\\{}{{{} {}}}", names[depth + 2], mark, text));
         TexScanner behind(in.rest());
         behind.skip_blanks();
         if (behind.rest().starts_with("\\label{")) {
           in = behind;
           in.next();
           const std::string key(argument(in));
           if (!number.empty()) hold_against(key, number, "");
           emit("\\label{" + key + "}");
         }
         emit("\n\n");
       });
  know({"label"}, [this](TexScanner& in, const TexToken&) {
    const std::string key(argument(in));
    if (is_math_) return;
    const std::string id = fmt::format(" id=\"{}\"", escape_html(key));
    if (!floats_.empty()) {
      std::string& open = result_.marks[floats_.back().mark - 1].open;
      if (open.find("@id@") != std::string::npos) {
        open = boost::replace_all_copy(open, "@id@", id);
        return;
      }
    }
    emit(marked("<span" + id + ">", "", "</span>"));
  });
  know({"footnote", "footnotemark", "footnotetext", "thanks"}, [this](TexScanner& in,
                                                                      const TexToken& token) {
    const auto given = option(in);
    std::size_t note_number = notes_.size();
    if (token.name == "footnotetext") {
      const auto mark = given ? std::find(notes_.rbegin(), notes_.rend(), *given) : notes_.rbegin();
      note_number = static_cast<std::size_t>(notes_.rend() - mark);
    } else {
      // REVTeX may print notes among the sources; IEEEtran's notes to the title have no mark.
      const bool is_title = token.name == "thanks";
      const bool has_number = numbers_.next("footnote") &&
                              (!is_title || numbers_.next("footnote")->number.starts_with('\\'));
      const std::string note = fmt::format("Note{}", n_notes_among_sources_ + 1);
      if (!is_title && numbers_.cites(note)) {
        ++n_notes_among_sources_;
        if (has_number) numbers_.take("footnote");
        argument(in);
        return read_all("\\cite{" + note + "}");
      }
      const std::string number = given        ? std::string(*given)
                                 : has_number ? expanded(numbers_.take("footnote").number)
                                              : "";
      notes_.push_back(number);
      note_number = notes_.size();
      const std::string place = fmt::format("note-{}", note_number);
      emit(marked(
          fmt::format("<sup class=\"lit-note-mark\"><a id=\"{0}-mark\" href=\"#{0}\">", place),
          number, "</a></sup>"));
    }
    if (token.name == "footnotemark") return;
    const std::string text = expanded(argument(in));
    emit(marked(fmt::format("<span class=\"lit-note\" id=\"note-{}\" role=\"note\">", note_number),
                text, "</span>"));
  });
  know({"caption", "captionof"}, [this](TexScanner& in, const TexToken& token) {
    const bool is_starred = token.text.ends_with('*');
    std::string counter = floats_.empty() ? "figure" : floats_.back().counter;
    if (token.name == "captionof") counter = argument(in);
    option(in);
    const std::string_view text = argument(in);
    const bool is_first =
        !floats_.empty() && !floats_.back().has_caption && !counter.starts_with("sub");
    begin_block(is_first ? "<figcaption>" : "<div class=\"lit-caption\">",
                is_first ? "</figcaption>" : "</div>");
    if (!floats_.empty()) floats_.back().has_caption = true;
    if (!is_starred) {
      const PrintedNumber number = numbers_.take(counter);
      const std::string shown = counter.starts_with("sub") ? "(" + number.number + ")"
                                                           : number.shown + "~" + number.number;
      emit(marked("<span class=\"lit-label\">", shown,
                  counter.starts_with("sub") ? "</span> " : "</span>: "));
    }
    read_all(text);
    end_block();
  });
  // type=figure within a table: this minipage has a figure's caption.
  know({"captionsetup"}, [this](TexScanner& in, const TexToken&) {
    option(in);
    for (const std::string& setting : names_in(argument(in))) {
      if (!setting.starts_with("type=") || floats_.empty()) continue;
      floats_.back().outer = std::exchange(floats_.back().counter, setting.substr(5));
    }
  });
  know({"item"}, [this](TexScanner& in, const TexToken&) {
    const auto given = option(in);
    const bool is_described = !ends_.empty() && ends_.back().first == "description";
    if (given && is_described) return emit("\\item[" + expanded(*given) + "] ");
    emit("\\item ");
    if (lists_.empty()) return;
    auto& [counter, n] = lists_.back();
    if (counter.empty() && !given) return;
    const std::string shown = given ? std::string(*given) : numbers_.take(counter).shown;
    if (shown != std::to_string(++n) + ".") {
      emit(marked("<span class=\"lit-item\">", expanded(shown), "</span> "));
    }
  });
  know_environments(
      {"enumerate", "itemize", "description"}, [this](TexScanner& in, const TexToken& token) {
        option(in);
        const auto depth =
            std::ranges::count_if(lists_, [](const auto& list) { return !list.first.empty(); });
        const bool is_numbered = token.name == "enumerate";
        constexpr const char* counters[] = {"enumi", "enumii", "enumiii", "enumiv"};
        lists_.emplace_back(is_numbered ? counters[std::min<std::ptrdiff_t>(depth, 3)] : "", 0);
        ends_.emplace_back(token.name, "list");
        emit(fmt::format("\\begin{{{}}}", token.name));
      });
  know_environments({"figure", "figure*", "table", "table*", "wrapfigure", "subfigure", "subtable",
                     "sidewaystable", "sidewaysfigure"},
                    [this](TexScanner& in, const TexToken& token) {
                      const std::string name(token.name);
                      option(in);
                      if (name == "wrapfigure" || name.starts_with("sub")) argument(in);
                      if (name == "wrapfigure") argument(in);
                      const bool is_table = name.find("table") != name.npos;
                      const bool is_part = name.starts_with("sub");
                      begin_block(is_part ? "<div class=\"lit-subfigure\"@id@>"
                                          : fmt::format("<figure class=\"lit-{}\"@id@{}>",
                                                        is_table ? "table-float" : "figure",
                                                        is_table ? "" : "@name@"),
                                  is_part ? "</div>" : "</figure>");
                      floats_.push_back({.counter = std::string(is_part ? "sub" : "") +
                                                    (is_table ? "table" : "figure"),
                                         .mark = result_.marks.size()});
                      ends_.emplace_back(name, "float");
                    });
  know({"stepcounter", "refstepcounter"}, [this](TexScanner& in, const TexToken&) {
    const std::string counter(argument(in));
    macros_["the" + counter] = {.body = numbers_.take(counter).number};
  });
  // Its number is known again when it is stepped.
  know({"setcounter", "addtocounter"}, [this](TexScanner& in, const TexToken&) {
    macros_.erase("the" + std::string(argument(in)));
    argument(in);
  });
  know_environments(
      {"equation", "equation*", "align", "align*", "alignat", "alignat*", "flalign", "flalign*",
       "gather", "gather*", "multline", "multline*", "eqnarray", "eqnarray*", "displaymath"},
      [this](TexScanner& in, const TexToken& token) {
        const std::string name(token.name);
        std::string_view body = body_of(in, name);
        std::string bare = name.ends_with('*') ? name.substr(0, name.size() - 1) : name;
        if (bare == "alignat") body = body.substr(group_at(body).size());
        std::vector<Row> rows = rows_of_display(body);
        // An equation of its own counts although its \\tag is printed instead.
        const bool is_counted = name == "equation";
        const std::string counted = is_counted ? numbers_.take("equation").number : "";
        const bool has_one_number =
            bare == "equation" || bare == "multline" || bare == "displaymath";
        if (has_one_number) {
          Row whole = rows.front();
          for (std::size_t i = 1; i < rows.size(); ++i) {
            whole.latex += "\\\\" + rows[i].latex;
            if (!rows[i].tag.empty()) whole.tag = rows[i].tag;
            if (!rows[i].label.empty()) whole.label = rows[i].label;
          }
          rows = {whole};
        }
        for (Row& row : rows) {
          // Its relation has a column of its own.
          if (bare == "eqnarray") {
            const auto behind = row.latex.find('&', row.latex.find('&') + 1);
            if (behind != row.latex.npos) row.latex.erase(behind, 1);
          }
          if (is_counted && row.tag.empty()) row.tag = "(" + counted + ")";
          if (bare != name || bare == "displaymath") row.is_numbered = false;
        }
        if (bare == "displaymath") bare = "equation";
        if (bare == "flalign" || bare == "alignat" || bare == "eqnarray") bare = "align";
        show_display(bare, std::move(rows));
        // It steps its counter once more than it prints it, and back again.
        if (name.starts_with("eqnarray")) numbers_.take("equation");
      });
}

}  // namespace literate
