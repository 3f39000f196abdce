// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "literate/page/html_text.hpp"
#include "literate/page/page_writer.hpp"
#include "literate/text/characters.hpp"

namespace literate {
namespace {

using Kind = PageToken::Kind;

std::string roman(int n) {
  static constexpr std::array<std::pair<int, std::string_view>, 9> digits{{{100, "C"},
                                                                           {90, "XC"},
                                                                           {50, "L"},
                                                                           {40, "XL"},
                                                                           {10, "X"},
                                                                           {9, "IX"},
                                                                           {5, "V"},
                                                                           {4, "IV"},
                                                                           {1, "I"}}};
  std::string text;
  for (const auto& [value, digit] : digits) {
    for (; n >= value; n -= value) text += digit;
  }
  return text;
}

// A heading's words as an id: «The finite-element model» is the-finite-element-model.
std::string slug(std::string_view title) {
  std::string id;
  for (const char c : title) {
    if (is_letter(c) || is_digit(c)) {
      id += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!id.empty() && id.back() != '-') {
      id += '-';
    }
  }
  while (id.ends_with('-')) id.pop_back();
  return id.empty() ? "section" : id;
}

constexpr std::array<std::string_view, 6> level_names{"part",          "section",   "subsection",
                                                      "subsubsection", "paragraph", "subparagraph"};

}  // namespace

void PageWriter::title(const PageToken&) {
  std::string html =
      "<header class=\"lit-title\">\n<h1>" + inline_html(metadata_["title"]) + "</h1>\n";
  const std::string authors = inline_html(metadata_["author"]);
  if (!authors.empty()) html += "<p class=\"lit-authors\">" + authors + "</p>\n";
  const std::string date =
      inline_html(metadata_.contains("date") ? metadata_["date"] : page_tokens("\\today"));
  if (!date.empty()) html += "<p class=\"lit-date\">" + date + "</p>\n";
  block(html + "<!--lit:cite-->\n</header>\n");
}

void PageWriter::heading(const PageToken& token) {
  const int level =
      static_cast<int>(std::ranges::find(level_names, token.text) - level_names.begin());
  const bool has_star = reader_.star();
  reader_.optional_argument();
  const PageTokens tokens = reader_.argument();
  if (is_preamble_) return;
  end_paragraph();
  const std::string title = inline_html(tokens);
  const std::string name(level_names[static_cast<std::size_t>(level)]);
  std::string number;
  if (!has_star && level <= counters_["secnumdepth"]) {
    const int n = ++counters_[name];
    if (level > 0) {
      for (std::size_t below = static_cast<std::size_t>(level) + 1; below < level_names.size();
           ++below) {
        counters_[std::string(level_names[below])] = 0;
      }
    }
    if (level == 0) {
      number = roman(n);
    } else if (level == 1) {
      number = is_appendix_ ? std::string(1, static_cast<char>('A' + n - 1)) : std::to_string(n);
    } else {
      const int section = counters_["section"];
      number = is_appendix_ ? std::string(1, static_cast<char>('A' + section - 1))
                            : std::to_string(section);
      for (int above = 2; above <= level; ++above) {
        number += "." + std::to_string(
                            counters_[std::string(level_names[static_cast<std::size_t>(above)])]);
      }
    }
  }
  if (level == 0) is_in_part_ = true;
  // Levels of HTML: no step downwards is greater than one, as assistive software asks.
  const int wanted = level == 0 ? 2 : level + (is_in_part_ ? 2 : 1);
  const int depth = std::min({wanted, last_level_ + 1, 6});
  last_level_ = std::max(depth, 2);
  const int html_level = std::max(depth, 2);
  const int id = new_id(slug(text_of_html(title)));
  const std::string type = is_appendix_ && level == 1 ? "appendix" : name;
  target_ = {type, number, title, id};
  headings_.push_back({level, number, title, id});
  const std::string printed_number =
      number.empty() ? ""
                     : "<span class=\"lit-number\">" +
                           (level == 0 ? inline_html(page_tokens("\\partname")) + " " : "") +
                           number + "</span> ";
  block(fmt::format("<h{0} id=\"{1}\" class=\"lit-{2}\">{3}{4}</h{0}>\n", html_level, id_mark(id),
                    name, printed_number, title));
}

void PageWriter::appendix(const PageToken&) {
  is_appendix_ = true;
  is_in_part_ = false;
  counters_["section"] = counters_["subsection"] = 0;
}

void PageWriter::begin(const PageToken& token) {
  const std::string name = reader_.text_argument();
  if (name == "document") {
    is_preamble_ = false;
    last_level_ = 1;
    if (const auto own = found_file("page.tex", "")) {
      read_preamble_of(file_tokens("page.tex", false));
      is_preamble_ = false;
    }
    return;
  }
  const auto handler = environments().find(name);
  if (reader_.knows(name) && handler == environments().end()) {
    environment_stack_.push_back(name);
    begin_group();
    reader_.expand(name);
    return;
  }
  if (theorems_.contains(name)) return theorem(name);
  if (handler != environments().end()) return (this->*handler->second)(name);
  PageToken place = token;
  place.text = "begin{" + name + "}";
  complain(place, "is not known to the page");
  plain_environment(name);
}

void PageWriter::end(const PageToken& token) {
  const std::string name = reader_.text_argument();
  if (name == "document") {
    reader_.set_aside();
    return;
  }
  if (!environment_stack_.empty() && environment_stack_.back() == name) {
    environment_stack_.pop_back();
    PageToken close = token;
    close.kind = Kind::close;
    close.text = "}";
    reader_.push(close);
    reader_.expand("end" + name);
    return;
  }
  complain(token, "{" + name + "} ends what did not begin");
}

// An environment that only sets what is in it otherwise on paper.
void PageWriter::plain_environment(const std::string& name) {
  if (name == "multicols") {
    reader_.argument();
    reader_.optional_argument();
  } else if (name == "minipage") {
    for (int i = 0; i < 3; ++i) reader_.optional_argument();
    reader_.argument();
  }
  const PageTokens body = reader_.environment_body(name);
  const auto is_said = [&](std::string_view command) {
    return std::ranges::any_of(body,
                               [&](const PageToken& token) { return token.is_command(command); });
  };
  // A figure beside a table: what has its own caption and label is by itself.
  if (float_ != nullptr && name == "minipage" && is_said("caption") && is_said("label")) {
    float_->has_floats = true;
    return write_float(float_kind(body, float_->kind), body);
  }
  block(block_html(body));
}

void PageWriter::abstract(const std::string& name) {
  const std::string body = block_html(reader_.environment_body(name));
  description_ = body;
  last_level_ = std::max(last_level_, 2);
  block("<section class=\"lit-abstract\">\n<h2>" + inline_html(page_tokens("\\abstractname")) +
        "</h2>\n" + body + "</section>\n");
}

void PageWriter::list(const std::string& name) {
  reader_.optional_argument();
  PageTokens body = reader_.environment_body(name);
  const std::string_view tag = name == "itemize" ? "ul" : (name == "enumerate" ? "ol" : "dl");
  std::vector<PageToken> rest = reader_.set_aside();
  reader_.push(body);
  std::string items;
  const int depth = ++counters_["@enumeration"];
  int n = 0;
  // The tokens of each item, up to the next \item outside braces and inner environments.
  std::optional<PageTokens> label_tokens;
  PageTokens item;
  bool has_item = false;
  const auto finish = [&] {
    if (!has_item) return;
    const Target outside = target_;
    const int number = new_id("item");
    if (tag == "ol") target_ = {"item", std::to_string(++n), "", number};
    const std::string content = without_paragraph(block_html(item));
    const bool is_named = !id_labels_[static_cast<std::size_t>(number)].empty();
    const std::string id = is_named ? " id=\"" + id_mark(number) + "\"" : "";
    if (tag == "dl") {
      items += "<dt>" + (label_tokens ? inline_html(*label_tokens) : "") + "</dt><dd>" + content +
               "</dd>\n";
    } else {
      const std::string label_html =
          label_tokens ? "<span class=\"lit-item-label\">" + inline_html(*label_tokens) + "</span> "
                       : "";
      items += "<li" + id + (label_tokens ? " class=\"lit-labelled\">" : ">") + label_html +
               content + "</li>\n";
    }
    target_ = outside;
    item.clear();
  };
  int braces = 0, inner = 0;
  while (std::optional<PageToken> token = reader_.next()) {
    if (token->is(Kind::open)) ++braces;
    if (token->is(Kind::close)) --braces;
    if (token->is_command("begin")) ++inner;
    if (token->is_command("end")) --inner;
    const bool is_outside = braces == 0 && inner == 0;
    if (is_outside && token->is_command("item")) {
      finish();
      has_item = true;
      label_tokens = reader_.optional_argument();
      continue;
    }
    if (is_outside && token->is_command("ifflag")) {
      flag(*token);
      continue;
    }
    if (has_item) item.push_back(*std::move(token));
  }
  finish();
  reader_.take_back(std::move(rest));
  counters_["@enumeration"] = depth - 1;
  block(fmt::format("<{0}>\n{1}</{0}>\n", tag, items));
}

void PageWriter::quote(const std::string& name) {
  block("<blockquote>\n" + block_html(reader_.environment_body(name)) + "</blockquote>\n");
}

void PageWriter::center(const std::string& name) {
  block("<div class=\"lit-center\">\n" + block_html(reader_.environment_body(name)) + "</div>\n");
}

void PageWriter::float_environment(const std::string& name) {
  reader_.optional_argument();
  if (name.starts_with("wrap")) {
    reader_.argument();
    reader_.argument();
  }
  const bool is_table = name.find("table") != std::string::npos;
  write_float(is_table ? "table" : "figure", reader_.environment_body(name));
}

// The kind that \captionsetup{type=…} says, if it says one.
std::string PageWriter::float_kind(const PageTokens& body, const std::string& otherwise) {
  const std::string latex = latex_of_tokens(body);
  for (const std::string kind : {"figure", "table"}) {
    if (latex.find("type=" + kind) != std::string::npos) return kind;
  }
  return otherwise;
}

void PageWriter::write_float(const std::string& kind, const PageTokens& body) {
  Float contents;
  contents.kind = kind;
  Float* const outside = std::exchange(float_, &contents);
  const Target outer_target = target_;
  contents.text = static_cast<int>(later_texts_.size());
  later_texts_.emplace_back();
  const std::string html = block_html(body);
  later_texts_[static_cast<std::size_t>(contents.text)] = contents.caption_words;
  float_ = outside;
  target_ = outer_target;
  is_continued_ = false;
  if (contents.has_floats && contents.caption.empty()) return block(html);
  const std::string id = contents.id < 0 ? "" : " id=\"" + id_mark(contents.id) + "\"";
  const std::string data =
      contents.figure.empty() ? "" : " data-figure=\"" + escape_html(contents.figure) + "\"";
  const std::string caption_html =
      contents.caption.empty() ? "" : "<figcaption>" + contents.caption + "</figcaption>\n";
  block(fmt::format("<figure class=\"{}\"{}{}>\n{}{}{}</figure>\n",
                    kind == "table" ? "lit-table-float" : "lit-figure", id, data,
                    contents.has_content_before ? "" : caption_html, html,
                    contents.has_content_before ? caption_html : ""));
}

void PageWriter::theorem(const std::string& name) {
  const Theorem known = theorems_[name];
  const auto note = reader_.optional_argument();
  std::string number;
  if (!known.counter.empty()) number = std::to_string(++counters_["@theorem " + known.counter]);
  const int id = new_id(name + (number.empty() ? "" : "-" + number));
  const Target outside = std::exchange(target_, Target{name, number, known.title, id});
  const std::string head = "<strong>" + known.title + (number.empty() ? "" : " " + number) +
                           "</strong>" + (note ? " (" + inline_html(*note) + ")" : "") + ". ";
  std::string content = block_html(reader_.environment_body(name));
  content = content.starts_with("<p>") ? "<p>" + head + content.substr(3)
                                       : "<p>" + head + "</p>\n" + content;
  target_ = outside;
  block(fmt::format("<div class=\"lit-theorem\" id=\"{}\">\n{}</div>\n", id_mark(id), content));
}

void PageWriter::caption(const PageToken& token) {
  const bool has_star = reader_.star();
  reader_.optional_argument();
  const PageTokens tokens = reader_.argument();
  if (float_ == nullptr) return complain(token, "stands in no figure or table");
  flush();
  float_->has_content_before =
      in_paragraph_ || !text_of_html(out_).empty() || out_.find("<img") != std::string::npos;
  const std::string name =
      plain_text(page_tokens(float_->kind == "table" ? "\\tablename" : "\\figurename"));
  std::string shown_label;
  if (!has_star) {
    const std::string number = std::to_string(++counters_[float_->kind]);
    float_->id = new_id(float_->kind + "-" + number);
    target_ = {float_->kind, number, "", float_->id};
    shown_label = "<span class=\"lit-label\">" + name + " " + number + "</span>: ";
  }
  const std::string words = inline_html(tokens);
  target_.title = words;
  float_->caption_words = words;
  float_->caption = shown_label + words;
}

void PageWriter::label(const PageToken&) {
  const std::string key = reader_.text_argument();
  if (is_preamble_) return;
  labels_[key] = target_;
  if (target_.id >= 0) {
    std::string& name = id_labels_[static_cast<std::size_t>(target_.id)];
    if (name.empty()) name = key;
  }
}

// The contents: parts, sections, and subsections within them.
std::string PageWriter::contents() const {
  std::string html = "<nav id=\"contents\" aria-label=\"Contents\">\n<ol>\n";
  static constexpr std::array<std::string_view, 3> classes{"lit-toc-part", "lit-toc-section",
                                                           "lit-toc-subsection"};
  for (const Heading& heading : headings_) {
    if (heading.level > 2) continue;
    const std::string number =
        heading.number.empty() ? "" : "<span class=\"lit-number\">" + heading.number + "</span> ";
    html += fmt::format("<li class=\"{}\"><a href=\"#{}\">{}{}</a></li>\n",
                        classes[static_cast<std::size_t>(heading.level)],
                        ids_[static_cast<std::size_t>(heading.id)], number,
                        without_links(resolved(heading.title)));
  }
  return html + "</ol>\n</nav>\n";
}

}  // namespace literate
