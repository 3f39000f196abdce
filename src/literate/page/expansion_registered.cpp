// SPDX-License-Identifier: GPL-3.0-or-later
// What the program registered: values, claims, tables, figures, excerpts.
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <ctime>

#include "literate/document/page_html.hpp"
#include "literate/page/expansion.hpp"
#include "literate/page/html_text.hpp"
#include "literate/prose/recorded_ages.hpp"
#include "literate/prose/restyle.hpp"
#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
using namespace page_reading;
namespace {

std::string_view sign_of(std::string_view verdict) {
  if (verdict == "confirmed") return "✓";
  if (verdict == "refuted") return "✗";
  return verdict == "undecided" ? "?" : "◐";
}

// A day of ISO 8601 in a form of strftime.
std::string day_in_words(const std::string& date, const char* form) {
  std::tm day{};
  if (strptime(date.c_str(), "%Y-%m-%d", &day) == nullptr) return date;
  char text[32];
  return std::string(sys::stripped({text, std::strftime(text, sizeof text, form, &day)}));
}

}  // namespace

std::vector<std::string> Expander::claims_of(bool is_cited) const {
  std::vector<std::string> ids;
  std::ranges::copy_if(claim_order_, std::back_inserter(ids), [&](const std::string& id) {
    return statements_.at(id).statement.source.empty() != is_cited;
  });
  return ids;
}

// What LaTeX sets as a picture, whose words are its source. Captions and labels are the page's own.
void Expander::picture_environment(TexScanner& in, const TexToken& token) {
  const std::string name(token.name);
  const std::string_view body = body_of(in, name);
  std::string drawn, texts;
  bool has_caption = false;
  const char* from = body.data();
  TexScanner parts(body);
  while (const auto part = parts.next()) {
    if (part->name != "caption" && part->name != "label") continue;
    drawn.append(from, part->text.data());
    if (part->name == "caption") option(parts);
    has_caption = has_caption || part->name == "caption";
    argument(parts);
    from = parts.rest().data();
    texts.append(part->text.data(), from);
  }
  drawn.append(from, body.data() + body.size());
  result_.typeset.push_back(fmt::format("{}{}\\end{{{}}}", token.text, drawn, name));
  const std::string image =
      fmt::format("<img class=\"lit-drawing\" src=\"figures/typeset-{}.svg\" alt=\"{}\">",
                  result_.typeset.size(), escape_html(result_.typeset.back()));
  begin_block(has_caption ? "<figure class=\"lit-figure\"@id@>" : "",
              has_caption ? "</figure>" : "");
  if (has_caption) {
    floats_.push_back({.counter = numbers_.captioned(name), .mark = result_.marks.size()});
  }
  fragment(image);
  read_all(texts);
  if (has_caption) floats_.pop_back();
  end_block();
}

void Expander::know_registered() {
  know({"val"}, "om", [this](const Call& call) {
    const std::string options(call.option()), key = call[0];
    if (!names_.values.contains(key)) return fail(fmt::format("unknown value '{}'", key));
    std::string printed = registered_.at("values").at(key).at("printed");
    if (!options.empty()) {
      try {
        printed = restyled(names_.numbers.at(key), options).printed();
      } catch (const std::exception& error) {
        return fail(error.what());
      }
    }
    boost::replace_all(printed, "\\%", "%");
    const std::string latex = names_.numbers.contains(key) ? quantity_latex(printed, is_math_)
                                                           : expanded(escape_latex(printed));
    const std::string id = use_id("val", key);
    if (is_math_) return emit(latex);
    emit(marked(fmt::format("<span class=\"lit-value lit-nowrap\" data-key=\"{0}\" id=\"{1}\">"
                            "<a href=\"#val-{0}\">",
                            key, id),
                latex, "</a></span>"));
  });
  know({"rawval"}, "om", [this](const Call& call) {
    const std::string options(call.option()), key = call[0];
    const auto number = names_.numbers.find(key);
    if (number == names_.numbers.end()) return fail(fmt::format("unknown number '{}'", key));
    try {
      emit(bare_digits(options.empty() ? number->second.number
                                       : restyled_number(number->second, options)));
    } catch (const std::exception& error) {
      fail(error.what());
    }
  });
  // \LiterateRepository{commit}{true}{2026-11-22T10:00:00Z}
  know({"LiterateRepository"}, "mmm", [this](const Call& call) {
    macros_["papercommit"] = {.body = call[0]};
    macros_["ifpapermodified"] = {.n_arguments = 2, .body = call[1] == "true" ? "#1" : "#2"};
    macros_["paperdate"] = {.body = call[2]};
    const std::string day = day_in_words(call[2], "%e %B %Y");
    macros_["paperday"] = {.body = day};
    if (day != call[2]) macros_["today"] = {.body = day_in_words(call[2], "%B %e, %Y")};
  });
  // A link to the entry of the ledger, with the sign of the verdict.
  know({"claim"}, "m", [this](const Call& call) {
    const std::string id = call[0];
    const auto statement = statements_.find(id);
    if (statement == statements_.end()) return fail(fmt::format("unknown claim '{}'", id));
    const std::string& found = names_.claims.at(id).found;
    const std::string& number = statement->second.number;
    emit(marked(
        fmt::format("<a class=\"lit-claim\" id=\"{}\" data-claim=\"{}\" data-verdict=\"{}\" "
                    "aria-label=\"claim {}, {}\" href=\"#claim-{}\"><span aria-hidden=\"true\">{}"
                    "</span> ",
                    use_id("claim", id), id, one_word(found), number, found, id, sign_of(found)),
        number, "</a>"));
  });
  know({"verdictsign"}, "m", [this](const Call& call) {
    emit(marked(
        fmt::format(
            "<span class=\"lit-sign\" data-verdict=\"{}\" role=\"img\" aria-label=\"{}\">{}</span>",
            one_word(call[0]), call[0], sign_of(call[0])),
        "", ""));
  });
  know({"claimcount"}, "mm", [this](const Call& call) {
    const std::vector<std::string> ids = claims_of(call[0] == "cited");
    emit(std::to_string(std::ranges::count_if(ids, [&](const std::string& id) {
      const NamedClaim& claim = names_.claims.at(id);
      if (call[1] == "unexpected") return claim.found != claim.expected;
      return call[1] == "all" || claim.found == call[1];
    })));
  });
  know_environments({"findings"}, "", [this](const Call& call) {
    std::string html =
        "<div class=\"lit-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"findings\"><table "
        "class=\"lit-table lit-findings\"><thead><tr>";
    for (const std::string& head : names_in(macros_.at("LiterateFindingsHead").body, '&')) {
      html += head.empty() ? "<td></td>" : "<th scope=\"col\"><tex>" + head + "</tex></th>";
    }
    fragment(html + "</tr></thead><tbody><tex>" + std::string(body_of(call.in, call.name)) +
             "</tex></tbody></table></div>");
  });
  // \PageLedger{cited}: the entries of claims that a source makes, or of the document's own.
  know({"PageLedger"}, "m", [this](const Call& call) {
    const bool is_cited = call[0] == "cited";
    listed_.insert("claim-");
    const RecordedAges ages(sources_.document, names_);
    for (const std::string& id : claims_of(is_cited)) {
      std::string html = sys::read_file(sources_.generated / "page/claims" / (id + ".html"));
      boost::replace_all(html, "@origin@", is_cited ? "paper" : "ours");
      std::size_t i = 0;
      for (const std::string& age : ages.of(id)) {
        boost::replace_all(html, fmt::format("@age:{}@", ++i),
                           age.empty() ? "" : fmt::format(", <strong>limit {}</strong>", age));
      }
      fragment(lettered(html, limits_));
    }
  });
  know({"PageFile"}, "m", [this](const Call& call) {
    if (call[0] == "index.html") listed_.insert("val-");
    const std::string html = sys::read_file(sources_.generated / "page" / call[0]);
    fragment(call[0] == "limits.html" ? in_order(html, limits_) : html);
  });
  know({"tab"}, "om", [this](const Call& call) {
    const std::string name = call[0];
    if (!names_.tables.contains(name)) return fail(fmt::format("unknown table '{}'", name));
    use_id("table", name);
    const bool breaks = !call.option().empty();
    const PrintedNumber* const next = numbers_.next("table");
    if (breaks) {
      read_all(fmt::format("\\begin{{table}}\\caption{{{}}}", call.option()));
    } else if (floats_.empty() && next && next->environment == "longtable") {
      // A table over pages counts even without a caption; another outside a float does not.
      const auto long_tables = registered_.at("long_tables").get<std::set<std::string>>();
      if (long_tables.contains(name)) numbers_.take("table");
    }
    const std::string html = sys::read_file(sources_.generated / "page/tables" / (name + ".html"));
    fragment(boost::replace_all_copy(html, "@use@", uses_[{"table", name}].back().id));
    if (breaks) read_all("\\end{table}");
  });
  know({"fig"}, "om", [this](const Call& call) {
    const std::string name = call[0];
    if (!names_.figures.contains(name)) return fail(fmt::format("unknown figure '{}'", name));
    result_.figures.push_back(name);
    read_all(
        fmt::format("\\PageDrawing{{id=\"{0}\" data-drawing=\"{1}\" "
                    "src=\"figures/{1}.svg\" alt=\"@alt@figure {1}\"}}",
                    use_id("figure", name), name));
    for (const Float& outer : floats_) {
      boost::replace_all(result_.marks[outer.mark - 1].open, "@name@",
                         fmt::format(" data-figure=\"{}\"", name));
    }
  });
  know({"includegraphics"}, "om", [this](const Call& call) {
    const std::string name = call[0];
    if (!fs::is_regular_file(sources_.document / name)) {
      return fail(fmt::format("unknown picture '{}'", name));
    }
    result_.pictures.push_back(name);
    read_all(fmt::format("\\PageDrawing{{src=\"pictures/{0}\" alt=\"@alt@picture {0}\"}}",
                         escape_html(name)));
  });
  know({"excerpt"}, "om", [this](const Call& call) {
    const std::string name = call[0];
    if (!names_.excerpts.contains(name)) return fail(fmt::format("unknown excerpt '{}'", name));
    const nlohmann::json& facts = registered_.at("excerpts").at(name);
    const std::string file = facts.at("file");
    const int first = facts.at("first_line"), last = facts.at("last_line");
    const PrintedNumber number = numbers_.take("lstlisting");
    begin_block(
        fmt::format("<figure class=\"lit-listing\" id=\"lst:{}\" data-listing=\"{}:{}-{}\">", name,
                    escape_html(file), first, last),
        "</figure>");
    begin_block("<figcaption>", "</figcaption>");
    emit(marked("<span class=\"lit-label\">", number.shown + "~" + number.number, "</span>: "));
    if (call.options[0]) read_all(std::string(call.option()) + ". ");
    emit(marked(fmt::format("<code>{}</code>", escape_html(file)), ", ", ""));
    const std::string lines =
        first == last ? fmt::format("line~{}", first) : fmt::format("lines~{}--{}", first, last);
    const std::string address =
        macros_.contains("LiterateSourceUrl")
            ? expanded(fmt::format("\\LiterateSourceUrl{{\\papercommit}}{{{}}}{{{}}}", file, first))
            : "";
    emit(address.empty() ? lines : fmt::format("\\href{{{}}}{{{}}}", address, lines));
    end_block();
    listing(sys::read_file(sources_.generated / "excerpts" / (name + ".txt")),
            facts.value("language", ""), first);
    end_block();
  });
}

}  // namespace literate
