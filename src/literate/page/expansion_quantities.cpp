// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with their units, as siunitx prints them, and the tables and boxes that an author types.
#include <fmt/core.h>

#include <boost/algorithm/string/replace.hpp>

#include "literate/page/expansion.hpp"
#include "literate/tables/column_writer.hpp"
#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
using namespace page_reading;
namespace {

std::string power_of(std::string exponent, bool is_math) {
  return is_math ? "^{" + exponent + "}"
                 : "\\textsuperscript{" + boost::replace_all_copy(exponent, "-", "−") + "}";
}

/// A unit as plain_unit() writes it, with raised powers: «m s⁻¹», «m^(1/2)».
std::string unit_with_powers(std::string_view unit, bool is_math) {
  static const sys::Pattern power(R"(((?:⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)+)|\^\(([^)]*)\))");
  constexpr std::string_view raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const auto plain = [&](std::string_view text) {
    const std::string escaped = escape_bookmark(text);
    return is_math && !escaped.empty() ? "\\text{" + escaped + "}" : escaped;
  };
  std::string text;
  for (const sys::Pattern::Match& found : power.all_in(unit)) {
    std::string exponent = found.str(1) + found.str(2);
    boost::replace_all(exponent, "⁻", "-");
    for (int digit = 0; digit < 10; ++digit) {
      boost::replace_all(exponent, raised[digit], std::to_string(digit));
    }
    text += plain(found.before) + power_of(exponent, is_math);
    unit = found.rest;
  }
  return text + plain(unit);
}

// A unit of siunitx with a solidus, as the PDF has it: \joule\per\mole\per\kelvin is J/(mol K).
std::string unit_with_solidus(const std::string& unit) {
  static const sys::Pattern factor(
      R"(\s*(\\per(?![A-Za-z])\s*)?((?:\\(?:yocto|zepto|atto|femto|pico|nano|micro|milli|centi|deci|)"
      R"(deca|hecto|kilo|mega|giga|tera|peta|exa|zetta|yotta|square|cubic)(?![A-Za-z])\s*)*)"
      R"((?:\\[A-Za-z]+|[^\\]+)\s*(?:\\(?:squared|cubed)(?![A-Za-z])|\\tothe\{[^}]*\})?))");
  std::string above, below;
  int n_below = 0;
  for (const sys::Pattern::Match& found : factor.all_in(unit)) {
    const bool is_below = !found.parts[1].empty();
    n_below += is_below ? 1 : 0;
    std::string& part = is_below ? below : above;
    part += (part.empty() ? "" : "\\,") + ("\\si{" + found.str(2) + "}");
  }
  if (n_below == 0) return above;
  return above + (n_below > 1 ? "/(" + below + ")" : "/" + below);
}

}  // namespace

// The forms are «-1.2e-6 lbf/in», «994(22) ± 3», «994 +22 −18», «(4.7 ± 1.8)e-3 mm»,
// «994 ± 22 (statistics) ± 5 (calibration)»; from the first blank before something else it is unit.
std::string quantity_latex(std::string_view printed, bool is_math) {
  static const sys::Pattern number(R"([-+.\d()e]*\d[-+.\d()e]*( .*)?)"),
      part(
          R"( \(([^()]*)\)|( ± )| \+([\de.-]+) −([\de.-]+)| (.*)|e\+?(-?\d+)|(-)|(\d+)(?:\.(\d+))?|.)");
  if (!number.is_all_of(printed)) return escape_latex(printed);
  std::string text;
  for (const sys::Pattern::Match& found : part.all_in(printed)) {
    const auto quantity = [&](std::size_t i) { return quantity_latex(found.parts[i], is_math); };
    const auto is_form = [&](std::size_t i) { return !found.parts[i].empty(); };
    if (is_form(1)) {
      const std::string words = " (" + escape_bookmark(found.parts[1]) + ")";
      text += is_math ? "\\text{" + words + "}" : words;
    } else if (is_form(2)) {
      text += is_math ? "\\pm " : "~±~";
    } else if (is_form(3)) {
      text += is_math ? "^{+" + quantity(3) + "}_{-" + quantity(4) + "}"
                      : "~+" + quantity(3) + "~−" + quantity(4);
    } else if (is_form(5)) {
      text += (is_math ? "\\," : "~") + unit_with_powers(found.parts[5], is_math);
    } else if (is_form(6)) {
      if (found.parts[6] == "0") continue;  // as siunitx prints it
      if (!text.empty()) text += is_math ? "\\times" : "~×~";
      text += "10" + power_of(found.str(6), is_math);
    } else if (is_form(7)) {
      text += is_math ? "{-}" : "−";
    } else if (is_form(8)) {
      text += grouped(found.str(8), false);
      if (is_form(9)) text += "." + grouped(found.str(9), true);
    } else {
      text += found.str();
    }
  }
  return text;
}

/// What siunitx prints of a number that an author types: «-.5E3» is −0.5e3.
std::string Expander::typed_number(std::string_view latex) {
  static const sys::Pattern form(
      R"(\s*([-+]?)(\d*)(?:[.,](\d*))?(\(\d+\))?(?:[eEdD]([-+]?[1-9]\d*|0))?\s*)");
  const std::string typed = expanded(latex);
  const auto found = form.match_all_of(typed);
  if (!found || (found->str(2) + found->str(3) + found->str(5)).empty()) {
    fail(fmt::format("the page cannot set the number '{}'; write it as -1.2(3)e-4", typed));
    return "";
  }
  const auto part = [&](std::size_t i) { return found->str(i); };
  std::string number = part(1) + part(2);
  if (!part(3).empty()) number += (part(2).empty() ? "0." : ".") + part(3);
  return number + part(4) + (part(5).empty() ? "" : "e" + part(5));
}

/// A number or a unit is set as siunitx sets it without options.
void Expander::require_default_options(const Call& call) {
  const std::string_view options = sys::stripped(call.option());
  if (options.empty() || options == "per-mode=symbol" || options == "per-mode = symbol") return;
  fail(fmt::format("the page cannot set a number or a unit with the options '{}'", options));
}

void Expander::know_quantities() {
  know({"num"}, "om", [this](const Call& call) {
    require_default_options(call);
    emit(quantity_latex(typed_number(call.arguments[0]), is_math_));
  });
  know({"qty", "SI"}, "omm", [this](const Call& call) {
    require_default_options(call);
    const std::string printed = typed_number(call.arguments[0]);
    const std::string unit = unit_of_latex(call.arguments[1]);
    std::string text = quantity_latex(printed + " " + unit, is_math_);
    if (unit.find('\\') != unit.npos) {
      const std::string bare = unit_with_solidus(unit);
      const char* blank = bare.starts_with('/') ? "" : is_math_ ? "\\," : "~";
      text = quantity_latex(printed, is_math_) + blank + bare;
    }
    // Both stand on one line.
    emit(is_math_ ? text : marked("<span class=\"lit-nowrap\">", text, "</span>"));
  });
  know({"si", "unit"}, "om", [this](const Call& call) {
    require_default_options(call);
    const std::string typed = unit_of_latex(call.arguments[0]);
    if (typed.find('\\') == typed.npos) return emit(unit_with_powers(typed, is_math_));
    const std::string bare = unit_with_solidus(call[0]);
    emit(bare.starts_with('/') ? "1" + bare : bare);
  });
  // pandoc takes only letters for columns, and shows nothing of what stands between them.
  know_environments(
      {"tabular", "tabular*", "tabularx", "longtable"}, "om", [this](const Call& call) {
        static const sys::Pattern joint(R"([@!]\s*\{\s*[^\s\\}])"),
            filler(R"([@!<>]\s*\{[^{}]*\}|\|)"), paragraph(R"([pmbw]\s*\{[^{}]*\}|X)");
        const bool has_width = call.name == "tabular*" || call.name == "tabularx";
        std::string columns = expanded(has_width ? argument(call.in) : call.arguments[0]);
        if (joint.is_in(columns)) {
          fail(
              "the page cannot join columns by @{…}; \\LiteratePicture{tabular} has LaTeX set "
              "them");
        }
        columns = paragraph.replaced_in(filler.replaced_in(columns, ""), "l");
        begin_block("<div class=\"lit-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"table\">",
                    "</div>");
        emit("\\begin{tabular}{" + columns + "}");
        read_all(body_of(call.in, call.name));
        emit("\\end{tabular}");
        end_block();
      });
  // \cmidrule(lr){2-3}
  know({"cmidrule", "cline"}, "", [](const Call& call) {
    call.in.skip(group_at(call.in.rest(), '(', ')').size());
    argument(call.in);
  });
  know({"makebox", "framebox"}, "oom", [this](const Call& call) {
    static const sys::Pattern length(R"(\s*[\d.]+(em|ex|pt|pc|mm|cm|in)\s*)");
    const std::string width(call.option());
    if (is_math_ || !length.is_all_of(width)) {
      read_all(call.arguments[0]);
      return emit(width.empty() ? "" : " ");
    }
    emit(marked(fmt::format("<span class=\"lit-box\" style=\"min-width:{}\">", width),
                expanded(call.arguments[0]), "</span> "));
  });
}

}  // namespace literate
