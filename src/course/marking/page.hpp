// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>
#include <string>

namespace course {

/// Adds an element with a text to a page.
pugi::xml_node add_element(pugi::xml_node parent, const char* name, const std::string& text);

/// The same with a class.
pugi::xml_node add_element(pugi::xml_node parent, const char* name, const std::string& text,
                           const char* css_class);

/// Begins a page of the course, one file that a phone can show, and returns its body.
pugi::xml_node begin_page(pugi::xml_document& document, const std::string& title);

/// The page as a text.
std::string page_text(const pugi::xml_document& document);

}  // namespace course
