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

std::vector<Expander::Row> Expander::rows_of_display(std::string_view body, bool is_one) {
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
      if (is_one) {
        row.latex += "\\\\";
        continue;
      }
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

void Expander::show_note(std::size_t number, std::string_view latex) {
  emit(marked(fmt::format("<span class=\"lit-note\" id=\"note-{}\" role=\"note\">", number),
              expanded(latex), "</span>"));
}

void Expander::show_caption(const std::string& counter, const Call& call) {
  const bool is_part = counter.starts_with("sub");
  const bool is_first = !floats_.empty() && !floats_.back().has_caption && !is_part;
  if (!floats_.empty()) floats_.back().has_caption = true;
  begin_block(is_first ? "<figcaption>" : "<div class=\"lit-caption\">",
              is_first ? "</figcaption>" : "</div>");
  if (!call.is_starred) {
    const PrintedNumber number = numbers_.take(counter);
    emit(marked("<span class=\"lit-label\">",
                is_part ? "(" + number.number + ")" : number.shown + "~" + number.number,
                is_part ? "</span> " : "</span>: "));
  }
  read_all(call.arguments.back());
  end_block();
}

void Expander::know_numbered() {
  // \bookmarksetup{startatroot}: what follows is in no part.
  know({"bookmarksetup"}, "m", [this](const Call& call) {
    for (const std::string& setting : names_in(call.arguments[0])) {
      if (setting == "startatroot") has_parts_ = false;
    }
  });
  // Levels of headings follow each other, since assistive software reads them so: with parts or
  // chapters a section is deeper than before the first of them.
  static const std::vector<std::string> headings{
      "part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"};
  know({"part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"},
       "om", [this](const Call& call) {
         const std::string& name = call.name;
         const std::string text = expanded(call.arguments[0]);
         // IEEEtran prints no heading of a section in its one appendix.
         if (name == "section" && !call.is_starred && macros_.contains("PageOneAppendix")) return;
         std::string number, printed;
         if (!call.is_starred && numbers_.next(name)) {
           const PrintedNumber found = numbers_.take(name);
           number = found.number;
           const bool has_word = name == "part" || name == "chapter";
           const std::string word = name == "section" ? "\\PageSectionWord{}" : "";
           printed = expanded(has_word ? found.shown + "~" + number
                                       : word + (found.shown.empty() ? number : found.shown));
         }
         const auto level =
             static_cast<std::size_t>(std::ranges::find(headings, name) - headings.begin());
         if (level <= 2) section_ = expanded(number);
         if (level > 4) {
           return emit(
               fmt::format("\n\n{}\\textbf{{{}}} ", printed.empty() ? "" : printed + " ", text));
         }
         has_parts_ = has_parts_ || level == 0;
         has_chapters_ = has_chapters_ || level == 1;
         const std::size_t above = level > 0 && has_parts_ ? 1 : 0;
         const std::size_t depth = above + (level < 2 ? 0 : level - 2 + (has_chapters_ ? 1 : 0));
         const std::string mark =
             printed.empty() ? "" : marked("<span class=\"lit-number\">", printed, "</span>");
         emit(fmt::format("\n\n\\{}{{{} {}}}", headings[depth + 2], mark, text));
         TexScanner behind(call.in.rest());
         behind.skip_blanks();
         if (behind.rest().starts_with("\\label{")) {
           call.in = behind;
           call.in.next();
           const std::string key(argument(call.in));
           if (!number.empty()) hold_against(key, number, "");
           emit("\\label{" + key + "}");
         }
         emit("\n\n");
       });
  know({"label"}, "m", [this](const Call& call) {
    if (is_math_) return;
    const std::string id = fmt::format(" id=\"{}\"", escape_html(call[0]));
    std::string* const open =
        floats_.empty() ? nullptr : &result_.marks[floats_.back().mark - 1].open;
    if (!open || open->find("@id@") == std::string::npos)
      return emit(marked("<span" + id + ">", "", "</span>"));
    boost::replace_all(*open, "@id@", id);
  });
  know({"footnote", "footnotemark", "thanks"}, "o", [this](const Call& call) {
    // REVTeX may print notes among the sources; IEEEtran's notes to the title have no mark.
    const bool is_title = call.name == "thanks";
    const PrintedNumber* const next = numbers_.next("footnote");
    const bool has_number = next && (!is_title || next->number.starts_with('\\'));
    const std::string note = fmt::format("Note{}", n_notes_among_sources_ + 1);
    if (!is_title && numbers_.cites(note)) {
      ++n_notes_among_sources_;
      if (has_number) numbers_.take("footnote");
      argument(call.in);
      return read_all("\\cite{" + note + "}");
    }
    notes_.push_back(call.options[0] ? std::string(call.option())
                     : has_number    ? expanded(numbers_.take("footnote").number)
                                     : "");
    const std::string place = fmt::format("note-{}", notes_.size());
    emit(
        marked(fmt::format("<sup class=\"lit-note-mark\"><a id=\"{0}-mark\" href=\"#{0}\">", place),
               notes_.back(), "</a></sup>"));
    if (call.name != "footnotemark") show_note(notes_.size(), argument(call.in));
  });
  know({"footnotetext"}, "om", [this](const Call& call) {
    const auto mark = call.options[0] ? std::find(notes_.rbegin(), notes_.rend(), call.option())
                                      : notes_.rbegin();
    show_note(static_cast<std::size_t>(notes_.rend() - mark), call.arguments[0]);
  });
  know({"caption"}, "om", [this](const Call& call) {
    show_caption(floats_.empty() ? "figure" : floats_.back().counter, call);
  });
  know({"captionof"}, "mom", [this](const Call& call) { show_caption(call[0], call); });
  // type=figure within a table: this minipage has a figure's caption.
  know({"captionsetup"}, "om", [this](const Call& call) {
    for (const std::string& setting : names_in(call.arguments[0])) {
      if (!setting.starts_with("type=") || floats_.empty()) continue;
      floats_.back().outer = std::exchange(floats_.back().counter, setting.substr(5));
    }
  });
  know({"item"}, "o", [this](const Call& call) {
    const auto given = call.options[0];
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
  know_environments({"enumerate", "itemize", "description"}, "o", [this](const Call& call) {
    const auto depth =
        std::ranges::count_if(lists_, [](const auto& list) { return !list.first.empty(); });
    constexpr const char* counters[] = {"enumi", "enumii", "enumiii", "enumiv"};
    lists_.emplace_back(
        call.name == "enumerate" ? counters[std::min<std::ptrdiff_t>(depth, 3)] : "", 0);
    ends_.emplace_back(call.name, [this, name = call.name] {
      lists_.pop_back();
      emit("\\end{" + name + "}");
    });
    emit(fmt::format("\\begin{{{}}}", call.name));
  });
  const auto begin_float = [this](const Call& call) {
    const bool is_table = call.name.find("table") != std::string::npos;
    const bool is_part = call.name.starts_with("sub");
    begin_block(is_part    ? "<div class=\"lit-subfigure\"@id@>"
                : is_table ? "<figure class=\"lit-table-float\"@id@>"
                           : "<figure class=\"lit-figure\"@id@@name@>",
                is_part ? "</div>" : "</figure>");
    floats_.push_back(
        {.counter = std::string(is_part ? "sub" : "") + (is_table ? "table" : "figure"),
         .mark = result_.marks.size()});
    ends_.emplace_back(call.name, [this] {
      floats_.pop_back();
      end_block();
    });
  };
  know_environments({"figure", "figure*", "table", "table*", "sidewaystable", "sidewaysfigure"},
                    "o", begin_float);
  know_environments({"subfigure", "subtable"}, "om", begin_float);
  know_environments({"wrapfigure"}, "omm", begin_float);
  know({"stepcounter", "refstepcounter"}, "m", [this](const Call& call) {
    macros_["the" + call[0]] = {.body = numbers_.take(call[0]).number};
  });
  // Its number is known again when it is stepped.
  know({"setcounter", "addtocounter"}, "mm",
       [this](const Call& call) { macros_.erase("the" + call[0]); });
  know_environments(
      {"equation", "equation*", "align", "align*", "alignat", "alignat*", "flalign", "flalign*",
       "gather", "gather*", "multline", "multline*", "eqnarray", "eqnarray*", "displaymath"},
      "", [this](const Call& call) {
        std::string_view body = body_of(call.in, call.name);
        const std::string bare = call.name.substr(0, call.name.find('*'));
        const bool is_plain = bare == "equation" || bare == "displaymath";
        const bool is_aligned = bare == "flalign" || bare == "alignat" || bare == "eqnarray";
        if (bare == "alignat") body = body.substr(group_at(body).size());
        std::vector<Row> rows = rows_of_display(body, is_plain || bare == "multline");
        // An equation of its own counts although its \tag is printed instead.
        const std::string counted =
            call.name == "equation" ? "(" + numbers_.take("equation").number + ")" : "";
        for (Row& row : rows) {
          // Its relation has a column of its own.
          if (bare == "eqnarray") {
            const auto behind = row.latex.find('&', row.latex.find('&') + 1);
            if (behind != row.latex.npos) row.latex.erase(behind, 1);
          }
          if (row.tag.empty()) row.tag = counted;
          if (call.is_starred || bare == "displaymath") row.is_numbered = false;
        }
        show_display(is_plain ? "equation" : is_aligned ? "align" : bare, std::move(rows));
        // It steps its counter once more than it prints it, and back again.
        if (bare == "eqnarray") numbers_.take("equation");
      });
}

}  // namespace literate
