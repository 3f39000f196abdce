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
  know({"val"}, [this](TexScanner& in, const TexToken&) {
    const std::string options(option(in).value_or(""));
    const std::string key(argument(in));
    if (!names_.values.contains(key)) return fail(fmt::format("unknown value '{}'", key));
    std::string printed = registered_.at("values").at(key).at("printed");
    if (!options.empty()) {
      try {
        printed = restyled(names_.numbers.at(key), options).printed();
      } catch (const std::exception& error) {
        return fail(error.what());
      }
    }
    printed = boost::replace_all_copy(printed, "\\%", "%");
    const bool is_number = names_.numbers.contains(key);
    const std::string latex =
        is_number ? quantity_latex(printed, is_math_) : expanded(escape_latex(printed));
    const std::string id = use_id("val", key);
    if (is_math_) return emit(latex);
    emit(marked(fmt::format("<span class=\"lit-value lit-nowrap\" data-key=\"{}\" id=\"{}\">"
                            "<a href=\"#val-{}\">",
                            key, id, key),
                latex, "</a></span>"));
  });
  know({"rawval"}, [this](TexScanner& in, const TexToken&) {
    const std::string options(option(in).value_or(""));
    const std::string key(argument(in));
    const auto number = names_.numbers.find(key);
    if (number == names_.numbers.end()) return fail(fmt::format("unknown number '{}'", key));
    uses_[{"val", key}].push_back({"", section_});  // TeX may want digits, where no link can stand
    try {
      emit(bare_digits(options.empty() ? number->second.number
                                       : restyled_number(number->second, options)));
    } catch (const std::exception& error) {
      fail(error.what());
    }
  });
  // \LiterateRepository{commit}{true}{2026-11-22T10:00:00Z}
  know({"LiterateRepository"}, [this](TexScanner& in, const TexToken&) {
    macros_["papercommit"] = {.body = std::string(argument(in))};
    macros_["ifpapermodified"] = {.n_arguments = 2, .body = argument(in) == "true" ? "#1" : "#2"};
    const std::string date(argument(in));
    macros_["paperdate"] = {.body = date};
    macros_["paperday"] = {.body = day_in_words(date, "%e %B %Y")};
    if (macros_["paperday"].body != date)
      macros_["today"] = {.body = day_in_words(date, "%B %e, %Y")};
  });
  // A link to the entry of the ledger, with the sign of the verdict.
  know({"claim"}, [this](TexScanner& in, const TexToken&) {
    const std::string id(argument(in));
    const auto statement = statements_.find(id);
    if (statement == statements_.end()) return fail(fmt::format("unknown claim '{}'", id));
    const std::string found = names_.claims.at(id).found;
    const std::string number = statement->second.number;
    emit(marked(
        fmt::format("<a class=\"lit-claim\" id=\"{}\" data-claim=\"{}\" data-verdict=\"{}\" "
                    "aria-label=\"claim {}, {}\" href=\"#claim-{}\"><span aria-hidden=\"true\">{}"
                    "</span> ",
                    use_id("claim", id), id, one_word(found), number, found, id, sign_of(found)),
        number, "</a>"));
  });
  know({"verdictsign"}, [this](TexScanner& in, const TexToken&) {
    const std::string verdict(argument(in));
    emit(marked(
        fmt::format(
            "<span class=\"lit-sign\" data-verdict=\"{}\" role=\"img\" aria-label=\"{}\">{}</span>",
            one_word(verdict), verdict, sign_of(verdict)),
        "", ""));
  });
  know({"claimcount"}, [this](TexScanner& in, const TexToken&) {
    const std::vector<std::string> ids = claims_of(argument(in) == "cited");
    const std::string_view verdict = argument(in);
    emit(std::to_string(std::ranges::count_if(ids, [&](const std::string& id) {
      const NamedClaim& claim = names_.claims.at(id);
      if (verdict == "unexpected") return claim.found != claim.expected;
      return verdict == "all" || claim.found == verdict;
    })));
  });
  know_environments({"findings"}, [this](TexScanner& in, const TexToken& token) {
    const std::string_view body = body_of(in, token.name);
    std::string heads = macros_.at("LiterateFindingsHead").body;
    for (auto at = heads.find('&'); at != heads.npos; at = heads.find('&', at)) {
      heads.replace(at, 1, "</tex></th><th scope=\"col\"><tex>");
    }
    fragment(
        "<div class=\"lit-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"findings\"><table "
        "class=\"lit-table lit-findings\"><thead><tr><th scope=\"col\"><tex>" +
        boost::replace_all_copy(heads, "<th scope=\"col\"><tex> </tex></th>", "<td></td>") +
        "</tex></th></tr></thead><tbody><tex>" + std::string(body) +
        "</tex></tbody></table></div>");
  });
  // \PageLedger{cited}: the entries of claims that a source makes, or of the document's own.
  know({"PageLedger"}, [this](TexScanner& in, const TexToken&) {
    const bool is_cited = argument(in) == "cited";
    listed_.insert("claim-");
    const RecordedAges ages(sources_.document, names_);
    for (const std::string& id : claims_of(is_cited)) {
      std::string html = sys::read_file(sources_.generated / "page/claims" / (id + ".html"));
      const std::vector<std::string>& of_limits = ages.of(id);
      for (std::size_t i = 0; i < of_limits.size(); ++i) {
        const std::string& age = of_limits[i];
        boost::replace_all(html, fmt::format("@age:{}@", i + 1),
                           age.empty() ? "" : fmt::format(", <strong>limit {}</strong>", age));
      }
      fragment(lettered(boost::replace_all_copy(html, "@origin@", is_cited ? "paper" : "ours"),
                        limits_));
    }
  });
  know({"PageFile"}, [this](TexScanner& in, const TexToken&) {
    const std::string file(argument(in));
    if (file == "index.html") listed_.insert("val-");
    const std::string html = sys::read_file(sources_.generated / "page" / file);
    fragment(file == "limits.html" ? in_order(html, limits_) : html);
  });
  know({"tab"}, [this](TexScanner& in, const TexToken&) {
    const auto long_caption = option(in);
    const std::string name(argument(in));
    if (!names_.tables.contains(name)) return fail(fmt::format("unknown table '{}'", name));
    use_id("table", name);
    const bool breaks = long_caption && !long_caption->empty();
    const PrintedNumber* const next = numbers_.next("table");
    if (breaks) {
      read_all(fmt::format("\\begin{{table}}\\caption{{{}}}", *long_caption));
    } else if (floats_.empty() && next && next->environment == "longtable") {
      numbers_.take("table");  // a table over pages counts even without a caption
    }
    std::string html = sys::read_file(sources_.generated / "page/tables" / (name + ".html"));
    fragment(boost::replace_all_copy(html, "@use@", uses_[{"table", name}].back().id));
    if (breaks) read_all("\\end{table}");
  });
  know({"fig"}, [this](TexScanner& in, const TexToken&) {
    option(in);
    const std::string name(argument(in));
    if (!names_.figures.contains(name)) return fail(fmt::format("unknown figure '{}'", name));
    result_.figures.push_back(name);
    read_all(
        fmt::format("\\PageDrawing{{id=\"{}\" data-drawing=\"{}\" "
                    "src=\"figures/{}.svg\" alt=\"@alt@figure {}\"}}",
                    use_id("figure", name), name, name, name));
    for (const Float& outer : floats_) {
      boost::replace_all(result_.marks[outer.mark - 1].open, "@name@",
                         fmt::format(" data-figure=\"{}\"", name));
    }
  });
  know({"includegraphics"}, [this](TexScanner& in, const TexToken&) {
    option(in);
    const std::string name(argument(in));
    if (!fs::is_regular_file(sources_.document / name)) {
      return fail(fmt::format("unknown picture '{}'", name));
    }
    result_.pictures.push_back(name);
    read_all(fmt::format("\\PageDrawing{{src=\"pictures/{0}\" alt=\"@alt@picture {0}\"}}",
                         escape_html(name)));
  });
  know({"excerpt"}, [this](TexScanner& in, const TexToken&) {
    const auto said = option(in);
    const std::string name(argument(in));
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
    if (said) read_all(std::string(*said) + ". ");
    const std::string lines =
        first == last ? fmt::format("line~{}", first) : fmt::format("lines~{}--{}", first, last);
    emit(marked(fmt::format("<code>{}</code>", escape_html(file)), ", ", ""));
    std::string address;
    if (macros_.contains("LiterateSourceUrl")) {
      address =
          expanded(fmt::format("\\LiterateSourceUrl{{\\papercommit}}{{{}}}{{{}}}", file, first));
    }
    emit(address.empty() ? lines : fmt::format("\\href{{{}}}{{{}}}", address, lines));
    end_block();
    listing(sys::read_file(sources_.generated / "excerpts" / (name + ".txt")),
            facts.value("language", ""), first);
    end_block();
  });
}

}  // namespace literate
