// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "literate/page/html_text.hpp"
#include "literate/text/characters.hpp"

namespace literate {
namespace {

constexpr std::string_view thin = "\u202F";
constexpr std::string_view minus = "\u2212";
constexpr std::string_view digit_space = "\u2007";
constexpr std::string_view point_space = "\u2008";
constexpr std::string_view sign_space = "\u2007\u2005";  // a minus of the page's font is as wide
constexpr std::size_t n_grouped = 5;                     // so many digits are grouped

struct NumberParts {
  std::string sign, whole, decimals, uncertainty, exponent_sign, exponent;
  bool has_exponent = false;
};

// Takes what a number may begin with from the front of a text.
class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : rest_(text) {}

  std::optional<NumberParts> read() {
    NumberParts parts;
    parts.sign = sign();
    parts.whole = digits();
    if (take('.')) {
      parts.decimals = digits();
      if (parts.decimals.empty()) return std::nullopt;
    }
    if (take('(')) {
      parts.uncertainty = "(" + digits() + ")";
      if (parts.uncertainty == "()" || !take(')')) return std::nullopt;
    }
    if (take('e') || take('E')) {
      parts.has_exponent = true;
      parts.exponent_sign = sign();
      parts.exponent = digits();
      if (parts.exponent.empty()) return std::nullopt;
    }
    if (!rest_.empty()) return std::nullopt;
    return parts;
  }

 private:
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::string sign() {
    if (take('-')) return "-";
    return take('+') ? "+" : "";
  }
  std::string digits() {
    const auto end = std::ranges::find_if_not(rest_, is_digit);
    const std::string found(rest_.begin(), end);
    rest_.remove_prefix(found.size());
    return found;
  }

  std::string_view rest_;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::string grouped(std::string_view digits, bool from_left) {
  if (digits.size() < n_grouped) return std::string(digits);
  const std::size_t first = from_left ? 3 : (digits.size() - 1) % 3 + 1;
  std::string text(digits.substr(0, first));
  for (std::size_t i = first; i < digits.size(); i += 3) {
    text += thin;
    text += digits.substr(i, 3);
  }
  return text;
}

std::string signed_text(std::string_view sign) {
  return std::string(sign == "-" ? minus : sign);
}

std::string mantissa(const NumberParts& parts) {
  std::string text = grouped(parts.whole, false);
  if (!parts.decimals.empty()) text += "." + grouped(parts.decimals, true);
  return text + parts.uncertainty;
}

std::string repeated(std::string_view text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

int n_breaks(int n_digits) {
  return n_digits < static_cast<int>(n_grouped) ? 0 : (n_digits - 1) / 3;
}

int length(std::string_view text) {
  return static_cast<int>(text.size());
}

int count(std::string_view digits) {
  int n = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), n);
  return n;
}

}  // namespace

std::string number_html(std::string_view number) {
  const std::optional<NumberParts> parts = NumberReader(trimmed(number)).read();
  if (!parts) return escape_html(number);
  std::string text = signed_text(parts->sign);
  const bool has_mantissa = !parts->whole.empty() || !parts->decimals.empty();
  if (has_mantissa) text += mantissa(*parts);
  if (!parts->has_exponent) return text;
  if (has_mantissa) text += std::string(thin) + "×" + std::string(thin);
  return text + "10<sup>" + signed_text(parts->exponent_sign) + parts->exponent + "</sup>";
}

std::string unit_html(std::string_view unit) {
  std::string html;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit.substr(i).starts_with("\\percent")) {
      html += '%';
      i += std::string_view("\\percent").size() - 1;
    } else if (unit[i] == '\\' && i + 1 < unit.size()) {
      html += escape_html(unit.substr(++i, 1));
    } else if (unit[i] == '.') {
      html += thin;
    } else if (unit[i] == '^') {
      const bool has_braces = unit.substr(i + 1).starts_with('{');
      std::size_t end = i + 1 + (has_braces ? 1 : 0);
      std::string power;
      for (; end < unit.size() && (unit[end] == '-' || is_digit(unit[end])); ++end) {
        power += unit[end] == '-' ? std::string(minus) : std::string(1, unit[end]);
      }
      html += "<sup>" + power + "</sup>";
      i = end - (has_braces ? 0 : 1);
    } else if (unit[i] == '~') {
      html += "\u00A0";
    } else {
      html += escape_html(unit.substr(i, 1));
    }
  }
  return html;
}

std::string quantity_html(std::string_view number, std::string_view unit) {
  return number_html(number) + std::string(thin) + unit_html(unit);
}

std::string number_cell_html(std::string_view format, std::string_view number,
                             std::string_view mark) {
  const std::optional<NumberParts> parts = NumberReader(trimmed(number)).read();
  const std::optional<NumberParts> widest = NumberReader(trimmed(format)).read();
  if (!parts || !widest) return escape_html(number);
  const int whole = count(widest->whole);
  const int decimals = count(widest->decimals);
  const int missing = whole - length(parts->whole);
  std::string html = repeated(digit_space, missing);
  if (missing > 0 && whole >= static_cast<int>(n_grouped) && parts->whole.size() < 4) html += thin;
  if (!widest->sign.empty() && parts->sign.empty()) html += sign_space;
  html += signed_text(parts->sign) + mantissa(*parts);
  if (!parts->has_exponent) html += mark;
  if (decimals > 0 && parts->decimals.empty()) html += point_space;
  html += repeated(digit_space, decimals - length(parts->decimals));
  html += repeated(thin, n_breaks(decimals) - n_breaks(length(parts->decimals)));
  if (!parts->has_exponent) return html;
  const bool pads_sign = !widest->exponent_sign.empty() && parts->exponent_sign.empty();
  html += std::string(thin) + "×" + std::string(thin) + "10<sup>" +
          signed_text(parts->exponent_sign) + parts->exponent;
  html += repeated(digit_space, count(widest->exponent) - length(parts->exponent));
  if (pads_sign) html += sign_space;
  return html + "</sup>" + std::string(mark);
}

std::string number_mathml(std::string_view number) {
  const std::optional<NumberParts> parts = NumberReader(trimmed(number)).read();
  if (!parts) return "<mtext>" + escape_html(number) + "</mtext>";
  std::string row;
  if (parts->sign == "-") row += "<mo form=\"prefix\">\u2212</mo>";
  const bool has_mantissa = !parts->whole.empty() || !parts->decimals.empty();
  if (has_mantissa) row += "<mn>" + mantissa(*parts) + "</mn>";
  if (parts->has_exponent) {
    if (has_mantissa) row += "<mo>×</mo>";
    const std::string sign = parts->exponent_sign == "-" ? "<mo form=\"prefix\">\u2212</mo>" : "";
    row += "<msup><mn>10</mn><mrow>" + sign + "<mn>" + parts->exponent + "</mn></mrow></msup>";
  }
  return "<mrow>" + row + "</mrow>";
}

}  // namespace literate
