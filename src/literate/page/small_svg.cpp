// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/small_svg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "literate/text/characters.hpp"

namespace literate {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// A tag, «<name attributes>», «</name>» or «<name attributes/>»; or what stands between two.
struct Piece {
  enum class Kind { opening, closing, empty, other } kind = Kind::other;
  std::string name;
  Attributes attributes;
  std::string text;  ///< of another piece
};

Piece tag_of(std::string_view tag) {
  Piece piece;
  const bool is_closing = tag.starts_with("</");
  const bool is_empty = tag.ends_with("/>");
  std::string_view rest = tag.substr(is_closing ? 2 : 1);
  rest.remove_suffix(is_empty ? 2 : 1);
  const std::size_t name_end = std::min(rest.find_first_of(" \n\t"), rest.size());
  piece.name = rest.substr(0, name_end);
  piece.kind =
      is_closing ? Piece::Kind::closing : (is_empty ? Piece::Kind::empty : Piece::Kind::opening);
  rest.remove_prefix(name_end);
  while (true) {
    const std::size_t begin = rest.find_first_not_of(" \n\t");
    const std::size_t equals = rest.find('=');
    if (begin == std::string_view::npos || equals == std::string_view::npos ||
        equals + 1 >= rest.size())
      break;
    const std::size_t end = rest.find(rest[equals + 1], equals + 2);
    if (end == std::string_view::npos) break;
    piece.attributes.emplace_back(rest.substr(begin, equals - begin),
                                  rest.substr(equals + 2, end - equals - 2));
    rest.remove_prefix(end + 1);
  }
  return piece;
}

std::vector<Piece> pieces_of(std::string_view svg) {
  std::vector<Piece> pieces;
  while (!svg.empty()) {
    const bool is_markup = svg.front() == '<';
    const bool is_tag = is_markup && svg.size() > 1 && svg[1] != '?' && svg[1] != '!';
    const std::size_t end =
        std::min(is_markup ? svg.find('>') : svg.find('<') - 1, svg.size() - 1) + 1;
    const std::string_view part = svg.substr(0, end);
    svg.remove_prefix(end);
    if (is_tag) {
      pieces.push_back(tag_of(part));
    } else if (is_markup ? !part.starts_with("<?xml")
                         : part.find_first_not_of(" \n\t\r") != std::string_view::npos) {
      pieces.push_back(
          {.kind = Piece::Kind::other, .name = {}, .attributes = {}, .text = std::string(part)});
    }
  }
  return pieces;
}

std::string rounded(double number, int n_decimals) {
  std::string text = fmt::format("{:.{}f}", number, n_decimals);
  if (text.find('.') != std::string::npos) {
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

/// Writes each number of a text as `write` does, and everything else as `between` does.
template <typename Write, typename Between>
std::string with_numbers(std::string_view text, Write write, Between between) {
  std::string whole;
  for (std::size_t i = 0; i < text.size();) {
    const bool has_sign = text[i] == '-' && i + 1 < text.size();
    const char first = has_sign ? text[i + 1] : text[i];
    double number = 0;
    const auto [end, error] =
        is_digit(first) || first == '.'
            ? std::from_chars(text.data() + i, text.data() + text.size(), number)
            : std::from_chars_result{text.data() + i, std::errc::invalid_argument};
    if (error == std::errc{}) {
      whole += write(number, whole);
      i = static_cast<std::size_t>(end - text.data());
    } else {
      whole += between(text[i++]);
    }
  }
  return whole;
}

std::string rounded_numbers(std::string_view text, int n_decimals) {
  return with_numbers(
      text, [&](double number, const std::string&) { return rounded(number, n_decimals); },
      [](char c) { return std::string(1, c); });
}

/// «M 1.234 -2 L 3 4 Z M 1.234 -2 » is «M1.23-2L3 4Z»: a step at the end draws nothing.
std::string small_path(std::string_view path, int n_decimals) {
  const std::size_t last = path.find_last_of("MLCZQSTHVA");
  if (last != std::string_view::npos && path[last] == 'M') path = path.substr(0, last);
  return with_numbers(
      path,
      [&](double number, const std::string& before) {
        std::string text = rounded(number, n_decimals);
        const bool follows_number = !before.empty() && is_digit(before.back());
        return follows_number && !text.starts_with('-') ? " " + text : text;
      },
      [](char c) { return c == ' ' || c == ',' || c == '\n' ? std::string() : std::string(1, c); });
}

/// «rgb(100%,0%,20%)» is «#f03».
std::string small_color(const std::string& color) {
  if (!color.starts_with("rgb(") || color.find('%') == std::string::npos) return color;
  std::string hex = "#";
  with_numbers(
      color,
      [&](double share, const std::string&) {
        hex += fmt::format("{:02x}", std::clamp(std::lround(share * 2.55), 0L, 255L));
        return std::string();
      },
      [](char) { return std::string(); });
  if (hex.size() == 7 && hex[1] == hex[2] && hex[3] == hex[4] && hex[5] == hex[6])
    return {'#', hex[1], hex[3], hex[5]};
  return hex.size() == 7 ? hex : color;
}

using Declarations = std::vector<std::pair<std::string, std::string>>;

Declarations declarations_of(std::string_view style) {
  Declarations declarations;
  while (!style.empty()) {
    const std::size_t end = std::min(style.find(';'), style.size());
    std::string_view one = style.substr(0, end);
    style.remove_prefix(std::min(end + 1, style.size()));
    one.remove_prefix(std::min(one.find_first_not_of(" \n"), one.size()));
    const std::size_t colon = one.find(':');
    if (colon != std::string_view::npos)
      declarations.emplace_back(one.substr(0, colon), one.substr(colon + 1));
  }
  return declarations;
}

// What holds where nothing else is said.
const std::map<std::string_view, std::string_view>& initial_values() {
  static const std::map<std::string_view, std::string_view> all{
      {"fill-opacity", "1"},        {"fill-rule", "nonzero"},   {"stroke", "none"},
      {"stroke-dasharray", "none"}, {"stroke-linecap", "butt"}, {"stroke-linejoin", "miter"},
      {"stroke-opacity", "1"},      {"stroke-miterlimit", "4"}, {"stroke-dashoffset", "0"}};
  return all;
}

std::string* find(Attributes& attributes, std::string_view name) {
  const auto found = std::ranges::find(attributes, name, &Attributes::value_type::first);
  return found == attributes.end() ? nullptr : &found->second;
}

/// Whether a group may take these attributes from the one thing in it: its look goes over to what
/// it holds, and no more.
bool is_look(const Attributes& attributes) {
  return !attributes.empty() && std::ranges::all_of(attributes, [](const auto& attribute) {
    if (attribute.first == "transform") return true;
    return attribute.first == "style" &&
           std::ranges::all_of(declarations_of(attribute.second), [](const auto& declaration) {
             return declaration.first.starts_with("fill") ||
                    declaration.first.starts_with("stroke");
           });
  });
}

/// The greatest factor of «matrix(a,b,c,d,e,f)» by which it makes coordinates larger.
double scale_of(const Attributes& attributes) {
  const auto found = std::ranges::find(attributes, "transform", &Attributes::value_type::first);
  double scale = 1;
  int n = 0;
  if (found == attributes.end() || !found->second.starts_with("matrix(")) return scale;
  with_numbers(
      found->second,
      [&](double number, const std::string&) {
        if (n++ < 4) scale = std::max(scale, std::abs(number));
        return std::string();
      },
      [](char) { return std::string(); });
  return scale;
}

void make_small(Piece& piece, const std::set<std::string>& inherited) {
  static constexpr int n_decimals = 2;
  const int n_more = static_cast<int>(std::ceil(std::log10(scale_of(piece.attributes))));
  for (auto& [name, value] : piece.attributes) {
    if (name == "xlink:href") name = "href";
    if (name == "d" && piece.name == "path") value = small_path(value, n_decimals + n_more);
    if ((name == "x" || name == "y") && piece.name == "use")
      value = rounded_numbers(value, n_decimals);
    if (name == "transform") {
      value = with_numbers(
          value, [](double number, const std::string&) { return fmt::format("{:.6g}", number); },
          [](char c) { return std::string(1, c); });
    }
    if (name != "style") continue;
    std::string style;
    for (const auto& [property, said] : declarations_of(value)) {
      const auto initial = initial_values().find(property);
      if (initial != initial_values().end() && initial->second == said &&
          !inherited.contains(property))
        continue;
      style += (style.empty() ? "" : ";") + property + ":" + small_color(said);
    }
    value = style;
  }
  std::erase_if(piece.attributes, [](const auto& attribute) {
    return attribute.first == "xmlns:xlink" ||
           (attribute.first == "style" && attribute.second.empty());
  });
}

std::string text_of(const Attributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes) text += " " + name + "=\"" + value + "\"";
  return text;
}

std::string text_of(const Piece& piece) {
  switch (piece.kind) {
    case Piece::Kind::opening:
      return "<" + piece.name + text_of(piece.attributes) + ">";
    case Piece::Kind::closing:
      return "</" + piece.name + ">";
    case Piece::Kind::empty:
      return "<" + piece.name + text_of(piece.attributes) + "/>";
    case Piece::Kind::other:
      return piece.text;
  }
  return {};
}

/// The properties that groups set, which what they hold may have to set back.
std::set<std::string> inherited_properties(const std::vector<Piece>& pieces) {
  std::set<std::string> properties;
  for (const Piece& piece : pieces) {
    if (piece.kind != Piece::Kind::opening) continue;
    for (const auto& [name, value] : piece.attributes) {
      if (name != "style") continue;
      for (const auto& [property, said] : declarations_of(value)) {
        const auto initial = initial_values().find(property);
        if (initial != initial_values().end() && initial->second != said)
          properties.insert(property);
      }
    }
  }
  return properties;
}

/// A group ends where another of the same look begins.
void join_groups(std::vector<Piece>& pieces) {
  std::vector<Piece> joined;
  std::vector<Attributes> open;
  std::optional<Attributes> closed;
  for (Piece& piece : pieces) {
    const bool is_group = piece.name == "g";
    if (is_group && piece.kind == Piece::Kind::opening) {
      if (closed && *closed == piece.attributes && is_look(piece.attributes)) {
        joined.pop_back();
        open.push_back(*closed);
        closed.reset();
        continue;
      }
      open.push_back(piece.attributes);
    }
    closed.reset();
    if (is_group && piece.kind == Piece::Kind::closing && !open.empty()) {
      closed = std::move(open.back());
      open.pop_back();
    }
    joined.push_back(std::move(piece));
  }
  pieces = std::move(joined);
}

}  // namespace

std::string small_svg(std::string_view svg) {
  std::vector<Piece> pieces = pieces_of(svg);
  const std::set<std::string> inherited = inherited_properties(pieces);
  for (Piece& piece : pieces) make_small(piece, inherited);
  join_groups(pieces);

  std::string text;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto look_of = [&](std::size_t k) {
      Attributes look = pieces[k].attributes;
      std::erase_if(look, [](const auto& attribute) { return attribute.first == "d"; });
      return look;
    };
    const auto is_path = [&](std::size_t k) {
      return k < pieces.size() && pieces[k].name == "path" && pieces[k].kind == Piece::Kind::empty;
    };
    std::size_t end = i + 1;
    if (is_path(i) && is_look(look_of(i))) {
      while (is_path(end) && look_of(end) == look_of(i)) ++end;
    }
    if (end == i + 1) {
      text += text_of(pieces[i]);
      continue;
    }
    text += "<g" + text_of(look_of(i)) + ">";
    for (std::size_t k = i; k < end; ++k) {
      const std::string* const d = find(pieces[k].attributes, "d");
      text += "<path d=\"" + (d == nullptr ? std::string() : *d) + "\"/>";
    }
    text += "</g>";
    i = end - 1;
  }
  return text;
}

}  // namespace literate
