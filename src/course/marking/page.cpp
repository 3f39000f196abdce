// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/page.hpp"

#include <sstream>

namespace course {
namespace {

constexpr const char* page_style = R"(
body { max-width: 46rem; margin: 0 auto; padding: 1rem; font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.4rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
pre { overflow-x: auto; padding: .6rem; background: #f3f3f3; font-size: .8rem; }
table { width: 100%; border-collapse: collapse; }
th { text-align: left; font-weight: 600; padding: .35rem .5rem .35rem 0; }
td { padding: .35rem .5rem .35rem 0; border-top: 1px solid #ddd; vertical-align: top; }
td:last-child, th:last-child { text-align: right; white-space: nowrap; }
.lost { color: #9a1c1c; } .note { color: #555; font-size: .9rem; }
figure { margin: 1rem 0; } svg { width: 100%; height: auto; }
)";

}  // namespace

pugi::xml_node add_element(pugi::xml_node parent, const char* name, const std::string& text) {
  pugi::xml_node node = parent.append_child(name);
  node.text().set(text.c_str());
  return node;
}

pugi::xml_node add_element(pugi::xml_node parent, const char* name, const std::string& text,
                           const char* css_class) {
  pugi::xml_node node = add_element(parent, name, text);
  node.append_attribute("class") = css_class;
  return node;
}

pugi::xml_node begin_page(pugi::xml_document& document, const std::string& title) {
  document.append_child(pugi::node_doctype).set_value("html");
  pugi::xml_node html = document.append_child("html");
  html.append_attribute("lang") = "en";
  pugi::xml_node head = html.append_child("head");
  head.append_child("meta").append_attribute("charset") = "utf-8";
  pugi::xml_node viewport = head.append_child("meta");
  viewport.append_attribute("name") = "viewport";
  viewport.append_attribute("content") = "width=device-width, initial-scale=1";
  add_element(head, "title", title);
  add_element(head, "style", page_style);
  return html.append_child("body");
}

std::string page_text(const pugi::xml_document& document) {
  std::ostringstream stream;
  // The raw format adds no spaces to the lines of <pre>, which a browser would show. Elements
  // without content get an end tag, since HTML would take <p/> for an open element.
  document.save(stream, "",
                pugi::format_raw | pugi::format_no_declaration | pugi::format_no_empty_element_tags,
                pugi::encoding_utf8);
  return stream.str() + "\n";
}

}  // namespace course
