// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/characters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace literate {
namespace {

struct Mapping {
  std::string_view character;
  std::string_view latex;
};

// One source of truth: the excerpts are checked against it and LaTeX is told of it.
// Mathematics as in comments, then typographic signs, then accented letters.
constexpr auto mappings = std::to_array<Mapping>({
    // clang-format off
    {"α", R"(\ensuremath{\alpha})"},
    {"β", R"(\ensuremath{\beta})"},
    {"γ", R"(\ensuremath{\gamma})"},
    {"δ", R"(\ensuremath{\delta})"},
    {"ε", R"(\ensuremath{\varepsilon})"},
    {"ζ", R"(\ensuremath{\zeta})"},
    {"η", R"(\ensuremath{\eta})"},
    {"θ", R"(\ensuremath{\theta})"},
    {"ι", R"(\ensuremath{\iota})"},
    {"κ", R"(\ensuremath{\kappa})"},
    {"λ", R"(\ensuremath{\lambda})"},
    {"μ", R"(\ensuremath{\mu})"},
    {"ν", R"(\ensuremath{\nu})"},
    {"ξ", R"(\ensuremath{\xi})"},
    {"ο", R"(o)"},
    {"π", R"(\ensuremath{\pi})"},
    {"ρ", R"(\ensuremath{\rho})"},
    {"ς", R"(\ensuremath{\varsigma})"},
    {"σ", R"(\ensuremath{\sigma})"},
    {"τ", R"(\ensuremath{\tau})"},
    {"υ", R"(\ensuremath{\upsilon})"},
    {"φ", R"(\ensuremath{\varphi})"},
    {"χ", R"(\ensuremath{\chi})"},
    {"ψ", R"(\ensuremath{\psi})"},
    {"ω", R"(\ensuremath{\omega})"},
    {"ϕ", R"(\ensuremath{\phi})"},
    {"ϵ", R"(\ensuremath{\epsilon})"},
    {"ϑ", R"(\ensuremath{\vartheta})"},
    {"Γ", R"(\ensuremath{\Gamma})"},
    {"Δ", R"(\ensuremath{\Delta})"},
    {"Θ", R"(\ensuremath{\Theta})"},
    {"Λ", R"(\ensuremath{\Lambda})"},
    {"Ξ", R"(\ensuremath{\Xi})"},
    {"Π", R"(\ensuremath{\Pi})"},
    {"Σ", R"(\ensuremath{\Sigma})"},
    {"Υ", R"(\ensuremath{\Upsilon})"},
    {"Φ", R"(\ensuremath{\Phi})"},
    {"Ψ", R"(\ensuremath{\Psi})"},
    {"Ω", R"(\ensuremath{\Omega})"},
    {"−", R"(\ensuremath{-})"},
    {"±", R"(\ensuremath{\pm})"},
    {"∓", R"(\ensuremath{\mp})"},
    {"×", R"(\ensuremath{\times})"},
    {"÷", R"(\ensuremath{\div})"},
    {"·", R"(\ensuremath{\cdot})"},
    {"⋅", R"(\ensuremath{\cdot})"},
    {"∘", R"(\ensuremath{\circ})"},
    {"√", R"(\ensuremath{\surd})"},
    {"∂", R"(\ensuremath{\partial})"},
    {"∇", R"(\ensuremath{\nabla})"},
    {"∫", R"(\ensuremath{\smallint})"},
    {"∮", R"(\ensuremath{\oint})"},
    {"∑", R"(\ensuremath{\Sigma})"},
    {"∏", R"(\ensuremath{\Pi})"},
    {"∞", R"(\ensuremath{\infty})"},
    {"∝", R"(\ensuremath{\propto})"},
    {"≈", R"(\ensuremath{\approx})"},
    {"≃", R"(\ensuremath{\simeq})"},
    {"≅", R"(\ensuremath{\cong})"},
    {"∼", R"(\ensuremath{\sim})"},
    {"≡", R"(\ensuremath{\equiv})"},
    {"≠", R"(\ensuremath{\neq})"},
    {"≤", R"(\ensuremath{\leq})"},
    {"≥", R"(\ensuremath{\geq})"},
    {"≪", R"(\ensuremath{\ll})"},
    {"≫", R"(\ensuremath{\gg})"},
    {"∈", R"(\ensuremath{\in})"},
    {"∉", R"(\ensuremath{\notin})"},
    {"⊂", R"(\ensuremath{\subset})"},
    {"⊆", R"(\ensuremath{\subseteq})"},
    {"∪", R"(\ensuremath{\cup})"},
    {"∩", R"(\ensuremath{\cap})"},
    {"∅", R"(\ensuremath{\emptyset})"},
    {"∀", R"(\ensuremath{\forall})"},
    {"∃", R"(\ensuremath{\exists})"},
    {"∧", R"(\ensuremath{\wedge})"},
    {"∨", R"(\ensuremath{\vee})"},
    {"¬", R"(\ensuremath{\neg})"},
    {"⊗", R"(\ensuremath{\otimes})"},
    {"⊕", R"(\ensuremath{\oplus})"},
    {"→", R"(\ensuremath{\rightarrow})"},
    {"←", R"(\ensuremath{\leftarrow})"},
    {"↔", R"(\ensuremath{\leftrightarrow})"},
    {"↑", R"(\ensuremath{\uparrow})"},
    {"↓", R"(\ensuremath{\downarrow})"},
    {"⇒", R"(\ensuremath{\Rightarrow})"},
    {"⇐", R"(\ensuremath{\Leftarrow})"},
    {"⇔", R"(\ensuremath{\Leftrightarrow})"},
    {"↦", R"(\ensuremath{\mapsto})"},
    {"∥", R"(\ensuremath{\parallel})"},
    {"‖", R"(\ensuremath{\|})"},
    {"⟂", R"(\ensuremath{\perp})"},
    {"⊥", R"(\ensuremath{\perp})"},
    {"ℓ", R"(\ensuremath{\ell})"},
    {"ħ", R"(\ensuremath{\hbar})"},
    {"⟨", R"(\ensuremath{\langle})"},
    {"⟩", R"(\ensuremath{\rangle})"},
    {"⌊", R"(\ensuremath{\lfloor})"},
    {"⌋", R"(\ensuremath{\rfloor})"},
    {"⌈", R"(\ensuremath{\lceil})"},
    {"⌉", R"(\ensuremath{\rceil})"},
    {"′", R"(\ensuremath{^{\prime}})"},
    {"″", R"(\ensuremath{^{\prime\prime}})"},
    {"°", R"(\ensuremath{^\circ})"},
    {"…", R"(\ensuremath{\ldots})"},
    {"⋯", R"(\ensuremath{\cdots})"},
    {"ᵀ", R"(\ensuremath{^{T}})"},
    {"ⁿ", R"(\ensuremath{^{n}})"},
    {"ⁱ", R"(\ensuremath{^{i}})"},
    {"⁺", R"(\ensuremath{^{+}})"},
    {"⁻", R"(\ensuremath{^{-}})"},
    {"ᵢ", R"(\ensuremath{_{i}})"},
    {"ⱼ", R"(\ensuremath{_{j}})"},
    {"ₖ", R"(\ensuremath{_{k}})"},
    {"ₙ", R"(\ensuremath{_{n}})"},
    {"ₘ", R"(\ensuremath{_{m}})"},
    {"ₓ", R"(\ensuremath{_{x}})"},
    {"₊", R"(\ensuremath{_{+}})"},
    {"₋", R"(\ensuremath{_{-}})"},
    {"⁰", R"(\ensuremath{^{0}})"},
    {"¹", R"(\ensuremath{^{1}})"},
    {"²", R"(\ensuremath{^{2}})"},
    {"³", R"(\ensuremath{^{3}})"},
    {"⁴", R"(\ensuremath{^{4}})"},
    {"⁵", R"(\ensuremath{^{5}})"},
    {"⁶", R"(\ensuremath{^{6}})"},
    {"⁷", R"(\ensuremath{^{7}})"},
    {"⁸", R"(\ensuremath{^{8}})"},
    {"⁹", R"(\ensuremath{^{9}})"},
    {"₀", R"(\ensuremath{_{0}})"},
    {"₁", R"(\ensuremath{_{1}})"},
    {"₂", R"(\ensuremath{_{2}})"},
    {"₃", R"(\ensuremath{_{3}})"},
    {"₄", R"(\ensuremath{_{4}})"},
    {"₅", R"(\ensuremath{_{5}})"},
    {"₆", R"(\ensuremath{_{6}})"},
    {"₇", R"(\ensuremath{_{7}})"},
    {"₈", R"(\ensuremath{_{8}})"},
    {"₉", R"(\ensuremath{_{9}})"},
    {"½", R"(\ensuremath{\frac{1}{2}})"},
    {"¼", R"(\ensuremath{\frac{1}{4}})"},
    {"¾", R"(\ensuremath{\frac{3}{4}})"},
    {"–", R"(\textendash{})"},
    {"—", R"(\textemdash{})"},
    {"‐", R"(-)"},
    {"‑", R"(-)"},
    {"“", R"(\textquotedblleft{})"},
    {"”", R"(\textquotedblright{})"},
    {"„", R"(\quotedblbase{})"},
    {"‘", R"(\textquoteleft{})"},
    {"’", R"(\textquoteright{})"},
    {"§", R"(\S{})"},
    {"¶", R"(\P{})"},
    {"†", R"(\dag{})"},
    {"©", R"(\textcopyright{})"},
    {"µ", R"(\textmu{})"},
    {"•", R"(\textbullet{})"},
    {"\u00a0", R"(\ )"},
    {"ß", R"(\ss{})"},
    {"å", R"(\aa{})"},
    {"Å", R"(\AA{})"},
    {"æ", R"(\ae{})"},
    {"Æ", R"(\AE{})"},
    {"ø", R"(\o{})"},
    {"Ø", R"(\O{})"},
    {"à", R"(\`{a})"},
    {"á", R"(\'{a})"},
    {"â", R"(\^{a})"},
    {"ã", R"(\~{a})"},
    {"ä", R"(\"{a})"},
    {"ç", R"(\c{c})"},
    {"è", R"(\`{e})"},
    {"é", R"(\'{e})"},
    {"ê", R"(\^{e})"},
    {"ë", R"(\"{e})"},
    {"ì", R"(\`{\i})"},
    {"í", R"(\'{\i})"},
    {"î", R"(\^{\i})"},
    {"ï", R"(\"{\i})"},
    {"ñ", R"(\~{n})"},
    {"ò", R"(\`{o})"},
    {"ó", R"(\'{o})"},
    {"ô", R"(\^{o})"},
    {"õ", R"(\~{o})"},
    {"ö", R"(\"{o})"},
    {"ù", R"(\`{u})"},
    {"ú", R"(\'{u})"},
    {"û", R"(\^{u})"},
    {"ü", R"(\"{u})"},
    {"ý", R"(\'{y})"},
    {"ÿ", R"(\"{y})"},
    {"č", R"(\v{c})"},
    {"š", R"(\v{s})"},
    {"ž", R"(\v{z})"},
    {"À", R"(\`{A})"},
    {"Á", R"(\'{A})"},
    {"Â", R"(\^{A})"},
    {"Ã", R"(\~{A})"},
    {"Ä", R"(\"{A})"},
    {"Ç", R"(\c{C})"},
    {"È", R"(\`{E})"},
    {"É", R"(\'{E})"},
    {"Ê", R"(\^{E})"},
    {"Ë", R"(\"{E})"},
    {"Ì", R"(\`{I})"},
    {"Í", R"(\'{I})"},
    {"Î", R"(\^{I})"},
    {"Ï", R"(\"{I})"},
    {"Ñ", R"(\~{N})"},
    {"Ò", R"(\`{O})"},
    {"Ó", R"(\'{O})"},
    {"Ô", R"(\^{O})"},
    {"Õ", R"(\~{O})"},
    {"Ö", R"(\"{O})"},
    {"Ù", R"(\`{U})"},
    {"Ú", R"(\'{U})"},
    {"Û", R"(\^{U})"},
    {"Ü", R"(\"{U})"},
    {"Ý", R"(\'{Y})"},
    {"Č", R"(\v{C})"},
    {"Š", R"(\v{S})"},
    {"Ž", R"(\v{Z})"},
    // clang-format on
});

std::size_t length_from_lead(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  if (lead >= 0xF0 && lead < 0xF5) return 4;
  return 1;
}

}  // namespace

int n_characters(std::string_view utf8) {
  return static_cast<int>(std::ranges::count_if(
      utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string_view first_character(std::string_view text) {
  const std::size_t length = length_from_lead(static_cast<unsigned char>(text.front()));
  const std::string_view tail = text.substr(1, length - 1);
  const bool is_whole = tail.size() == length - 1 && std::ranges::all_of(tail, [](char c) {
                          return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
                        });
  return text.substr(0, is_whole ? length : 1);
}

std::string_view latex_of(std::string_view character) {
  const auto found = std::ranges::find(mappings, character, &Mapping::character);
  return found == mappings.end() ? std::string_view{} : found->latex;
}

std::string listings_characters() {
  std::string setting = "\\lstset{literate=%\n";
  for (const auto& [character, latex] : mappings) {
    setting.append("  {").append(character).append("}{{").append(latex).append("}}1\n");
  }
  return setting + "}\n";
}

}  // namespace literate
