// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/characters.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace literate {
namespace {

// The one list of characters, each followed by its LaTeX: excerpts are checked against it, and
// LaTeX is told of it. First the mathematics of comments, which stands in \ensuremath, with the
// italic letters of symbols.
constexpr const char* in_formulas = R"(
α \alpha  β \beta  γ \gamma  δ \delta  ε \varepsilon  ζ \zeta  η \eta  θ \theta  ι \iota
κ \kappa  λ \lambda  μ \mu  ν \nu  ξ \xi  π \pi  ρ \rho  ς \varsigma  σ \sigma  τ \tau
υ \upsilon  φ \varphi  χ \chi  ψ \psi  ω \omega  ϕ \phi  ϵ \epsilon  ϑ \vartheta  Γ \Gamma
Δ \Delta  Θ \Theta  Λ \Lambda  Ξ \Xi  Π \Pi  Σ \Sigma  Υ \Upsilon  Φ \Phi  Ψ \Psi  Ω \Omega  − -
± \pm  ∓ \mp  × \times  ÷ \div  · \cdot  ⋅ \cdot  ∘ \circ  √ \surd  ∂ \partial  ∇ \nabla
∫ \smallint  ∮ \oint  ∑ \Sigma  ∏ \Pi  ∞ \infty  ∝ \propto  ≈ \approx  ≃ \simeq  ≅ \cong  ∼ \sim
≡ \equiv  ≠ \neq  ≤ \leq  ≥ \geq  ≪ \ll  ≫ \gg  ∈ \in  ∉ \notin  ⊂ \subset  ⊆ \subseteq  ∪ \cup
∩ \cap  ∅ \emptyset  ∀ \forall  ∃ \exists  ∧ \wedge  ∨ \vee  ¬ \neg  ⊗ \otimes  ⊕ \oplus
→ \rightarrow  ← \leftarrow  ↔ \leftrightarrow  ↑ \uparrow  ↓ \downarrow  ⇒ \Rightarrow
⇐ \Leftarrow  ⇔ \Leftrightarrow  ↦ \mapsto  ∥ \parallel  ‖ \|  ⟂ \perp  ⊥ \perp  ℓ \ell  ħ \hbar
⟨ \langle  ⟩ \rangle  ⌊ \lfloor  ⌋ \rfloor  ⌈ \lceil  ⌉ \rceil  ′ ^{\prime}  ″ ^{\prime\prime}
° ^\circ  … \ldots  ⋯ \cdots  ᵀ ^{T}  ⁿ ^{n}  ⁱ ^{i}  ⁺ ^{+}  ⁻ ^{-}  ᵢ _{i}  ⱼ _{j}  ₖ _{k}
ₙ _{n}  ₛ _{s}  ₘ _{m}  ₓ _{x}  ₊ _{+}  ₋ _{-}  ⁰ ^{0}  ¹ ^{1}  ² ^{2}  ³ ^{3}  ⁴ ^{4}  ⁵ ^{5}
⁶ ^{6}  ⁷ ^{7}  ⁸ ^{8}  ⁹ ^{9}  ₀ _{0}  ₁ _{1}  ₂ _{2}  ₃ _{3}  ₄ _{4}  ₅ _{5}  ₆ _{6}  ₇ _{7}
₈ _{8}  ₉ _{9}  𝑎 a  𝑏 b  𝑐 c  𝑑 d  𝑒 e  𝑓 f  𝑔 g  ℎ h  𝑖 i  𝑗 j  𝑘 k  𝑙 l  𝑚 m  𝑛 n  𝑜 o  𝑝 p
𝑞 q  𝑟 r  𝑠 s  𝑡 t  𝑢 u  𝑣 v  𝑤 w  𝑥 x  𝑦 y  𝑧 z  𝐴 A  𝐵 B  𝐶 C  𝐷 D  𝐸 E  𝐹 F  𝐺 G  𝐻 H  𝐼 I
𝐽 J  𝐾 K  𝐿 L  𝑀 M  𝑁 N  𝑂 O  𝑃 P  𝑄 Q  𝑅 R  𝑆 S  𝑇 T  𝑈 U  𝑉 V  𝑊 W  𝑋 X  𝑌 Y  𝑍 Z
½ \frac{1}{2}  ¼ \frac{1}{4}  ¾ \frac{3}{4}
)";

// Typographic signs and accented letters.
constexpr const char* in_texts = R"(
– \textendash{}  — \textemdash{}  ‐ -  ‑ -  “ \textquotedblleft{}  ” \textquotedblright{}
„ \quotedblbase{}  ‘ \textquoteleft{}  ’ \textquoteright{}  § \S{}  ¶ \P{}  † \dag{}
© \textcopyright{}  µ \textmu{}  • \textbullet{}  ß \ss{}  å \aa{}  Å \AA{}  æ \ae{}  Æ \AE{}
ø \o{}  Ø \O{}  à \`{a}  á \'{a}  â \^{a}  ã \~{a}  ä \"{a}  ç \c{c}  è \`{e}  é \'{e}  ê \^{e}
ë \"{e}  ì \`{\i}  í \'{\i}  î \^{\i}  ï \"{\i}  ñ \~{n}  ò \`{o}  ó \'{o}  ô \^{o}  õ \~{o}
ö \"{o}  ù \`{u}  ú \'{u}  û \^{u}  ü \"{u}  ý \'{y}  ÿ \"{y}  č \v{c}  š \v{s}  ž \v{z}
À \`{A}  Á \'{A}  Â \^{A}  Ã \~{A}  Ä \"{A}  Ç \c{C}  È \`{E}  É \'{E}  Ê \^{E}  Ë \"{E}
Ì \`{I}  Í \'{I}  Î \^{I}  Ï \"{I}  Ñ \~{N}  Ò \`{O}  Ó \'{O}  Ô \^{O}  Õ \~{O}  Ö \"{O}
Ù \`{U}  Ú \'{U}  Û \^{U}  Ü \"{U}  Ý \'{Y}  Č \v{C}  Š \v{S}  Ž \v{Z}
)";

struct Mapping {
  std::string character;
  std::string latex;
};

const std::vector<Mapping>& mappings() {
  static const std::vector<Mapping> all = [] {
    std::vector<Mapping> mappings{
        {"\u00a0", "~"}, {"\u202f", "\\,"}, {"\u2009", "\\,"}, {"ο", "o"}};
    std::string character, latex;
    for (std::istringstream words(in_formulas); words >> character >> latex;) {
      mappings.push_back({character, "\\ensuremath{" + latex + "}"});
    }
    for (std::istringstream words(in_texts); words >> character >> latex;) {
      mappings.push_back({character, latex});
    }
    return mappings;
  }();
  return all;
}

}  // namespace

std::string_view character_of(std::string_view command) {
  const std::string in_formula = "\\ensuremath{" + std::string(command) + "}";
  const auto found = std::ranges::find_if(mappings(), [&](const Mapping& mapping) {
    return mapping.latex == command || mapping.latex == in_formula;
  });
  return found == mappings().end() ? std::string_view() : found->character;
}

std::string_view latex_of(std::string_view character) {
  const auto found = std::ranges::find(mappings(), character, &Mapping::character);
  return found == mappings().end() ? std::string_view() : found->latex;
}

std::string listings_characters() {
  std::string setting = "\\lstset{literate=%\n";
  for (const auto& [character, latex] : mappings()) {
    setting.append("  {").append(character).append("}{{").append(latex).append("}}1\n");
  }
  return setting + "}\n";
}

bool is_key(std::string_view text) {
  const auto is_allowed = [](char c) {
    return is_alphanumeric(c) || c == '-' || c == '_' || c == '.';
  };
  return !text.empty() && is_alphanumeric(text.front()) && std::ranges::all_of(text, is_allowed);
}

bool is_file_name(std::string_view text) {
  return is_key(text) && text.find('.') == std::string_view::npos;
}

void require_key(std::string_view text) {
  if (is_key(text)) return;
  throw std::logic_error(fmt::format("key '{}' must be letters, digits, '-', '_' and '.'", text));
}

void require_file_name(std::string_view text) {
  if (is_file_name(text)) return;
  throw std::logic_error(fmt::format("name '{}' must be letters, digits, '-' and '_'", text));
}

}  // namespace literate
