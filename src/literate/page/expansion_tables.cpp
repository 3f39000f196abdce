// SPDX-License-Identifier: GPL-3.0-or-later
// Tables that the author types.
#include <fmt/core.h>

#include <algorithm>

#include "literate/page/expansion.hpp"
#include "literate/page/expansion_reading.hpp"
#include "literate/text/characters.hpp"
#include "system/lines.hpp"

namespace literate {
using namespace page_reading;

// pandoc takes only letters for columns. What stands between two of them, as the point of r@{.}l,
// joins their cells.
void Expander::tabular(TexScanner& in, const TexToken& token) {
  const std::string name(token.name);
  option(in);
  if (name == "tabular*" || name == "tabularx") argument(in);
  std::string columns;
  std::vector<std::string> between;  // before the second column, the third, …
  const std::string given(expanded(argument(in)));
  TexScanner form(given);
  std::string pending;
  const std::function<void(std::string_view)> read_form = [&](std::string_view text) {
    TexScanner letters(text);
    while (!letters.rest().empty()) {
      const char c = letters.skip(1).front();
      if (c == '*') {
        const int n = std::stoi(std::string(argument(letters)));
        const std::string repeated(argument(letters));
        for (int i = 0; i < n; ++i) read_form(repeated);
      } else if (c == '@' || c == '!') {
        const std::string_view joint = argument(letters);
        if (c == '@' && !joint.empty() && joint.front() != '\\' && !sys::stripped(joint).empty())
          pending = joint;
      } else if (c == '>' || c == '<') {
        argument(letters);
      } else if (is_letter(c)) {
        const bool has_width = c == 'p' || c == 'm' || c == 'b' || c == 'w';
        if (has_width) argument(letters);
        if (!columns.empty()) between.push_back(pending);
        if (columns.empty() || pending.empty()) columns += (c == 'r' || c == 'c') ? c : 'l';
        pending.clear();
      }
    }
  };
  read_form(given);
  std::string body(body_of(in, name));
  begin_block("<div class=\"lit-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"table\">",
              "</div>");
  emit("\\begin{tabular}{" + columns + "}");
  rows_of_tabular(body, between);
  emit("\\end{tabular}");
  end_block();
}

void Expander::rows_of_tabular(std::string_view body, const std::vector<std::string>& between) {
  TexScanner in(body);
  std::size_t column = 0;
  int depth = 0;
  while (const auto token = in.next()) {
    if (token->kind == TexKind::open) ++depth;
    if (token->kind == TexKind::close) --depth;
    if (token->name == "multicolumn") {
      const auto n = static_cast<std::size_t>(std::stoul(std::string(argument(in))));
      std::string form(argument(in));
      std::size_t joined = 0;
      for (std::size_t i = column; i + 1 < column + n && i < between.size(); ++i)
        joined += between[i].empty() ? 0U : 1U;
      std::erase_if(form, [](char c) { return c != 'l' && c != 'c' && c != 'r'; });
      emit(fmt::format("\\multicolumn{{{}}}{{{}}}{{{}}}", n - joined, form.empty() ? "l" : form,
                       expanded(argument(in))));
      column += n - 1;
      if (joined == 0 && column < between.size() && !between[column].empty()) {
        fail("a cell behind \\multicolumn is joined to it by @{…}, which the page cannot show");
      }
    } else if (token->text == "\\\\" && depth == 0) {
      option(in);
      emit("\\\\\n");
      column = 0;
    } else if (token->name == "cmidrule" || token->name == "cline" ||
               token->name == "addlinespace") {
      const std::string_view trim = group_at(in.rest(), '(', ')');
      in.skip(trim.size());
      if (token->name == "addlinespace")
        option(in);
      else
        argument(in);
    } else if (token->kind == TexKind::text && depth == 0) {
      std::string_view text = token->text;
      for (auto at = text.find('&'); at != text.npos; at = text.find('&')) {
        const bool is_joined = column < between.size() && !between[column].empty();
        emit(is_joined ? sys::stripped(text.substr(0, at)) : text.substr(0, at));
        if (is_joined) {
          while (out_->ends_with(' ')) out_->pop_back();
          read_all(between[column]);
        } else {
          emit("&");
        }
        ++column;
        text.remove_prefix(at + 1);
        if (is_joined) text.remove_prefix(std::min(text.find_first_not_of(" \n"), text.size()));
      }
      emit(text);
    } else {
      read(in, *token);
    }
  }
}

}  // namespace literate
