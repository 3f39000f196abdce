// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/math_symbols.hpp"

#include <array>
#include <unordered_map>
#include <utility>

#include "literate/text/characters.hpp"

namespace literate {
namespace {

using enum AtomClass;
using Symbols = std::unordered_map<std::string_view, MathSymbol>;

const Symbols& symbols() {
  static const Symbols all{
      {"alpha", {"α", ordinary}},
      {"beta", {"β", ordinary}},
      {"gamma", {"γ", ordinary}},
      {"delta", {"δ", ordinary}},
      {"epsilon", {"ϵ", ordinary}},
      {"varepsilon", {"ε", ordinary}},
      {"zeta", {"ζ", ordinary}},
      {"eta", {"η", ordinary}},
      {"theta", {"θ", ordinary}},
      {"vartheta", {"ϑ", ordinary}},
      {"iota", {"ι", ordinary}},
      {"kappa", {"κ", ordinary}},
      {"lambda", {"λ", ordinary}},
      {"mu", {"μ", ordinary}},
      {"nu", {"ν", ordinary}},
      {"xi", {"ξ", ordinary}},
      {"pi", {"π", ordinary}},
      {"varpi", {"ϖ", ordinary}},
      {"rho", {"ρ", ordinary}},
      {"varrho", {"ϱ", ordinary}},
      {"sigma", {"σ", ordinary}},
      {"varsigma", {"ς", ordinary}},
      {"tau", {"τ", ordinary}},
      {"upsilon", {"υ", ordinary}},
      {"phi", {"ϕ", ordinary}},
      {"varphi", {"φ", ordinary}},
      {"chi", {"χ", ordinary}},
      {"psi", {"ψ", ordinary}},
      {"omega", {"ω", ordinary}},
      {"Gamma", {"Γ", ordinary}},
      {"Delta", {"Δ", ordinary}},
      {"Theta", {"Θ", ordinary}},
      {"Lambda", {"Λ", ordinary}},
      {"Xi", {"Ξ", ordinary}},
      {"Pi", {"Π", ordinary}},
      {"Sigma", {"Σ", ordinary}},
      {"Upsilon", {"Υ", ordinary}},
      {"Phi", {"Φ", ordinary}},
      {"Psi", {"Ψ", ordinary}},
      {"Omega", {"Ω", ordinary}},
      {"partial", {"∂", ordinary}},
      {"infty", {"∞", ordinary}},
      {"nabla", {"∇", ordinary}},
      {"ell", {"ℓ", ordinary}},
      {"hbar", {"ℏ", ordinary}},
      {"imath", {"ı", ordinary}},
      {"jmath", {"ȷ", ordinary}},
      {"Re", {"ℜ", ordinary}},
      {"Im", {"ℑ", ordinary}},
      {"aleph", {"ℵ", ordinary}},
      {"forall", {"∀", ordinary}},
      {"exists", {"∃", ordinary}},
      {"emptyset", {"∅", ordinary}},
      {"varnothing", {"∅", ordinary}},
      {"angle", {"∠", ordinary}},
      {"degree", {"°", ordinary}},
      {"prime", {"′", ordinary}},
      {"top", {"⊤", ordinary}},
      {"bot", {"⊥", ordinary}},
      {"ldots", {"…", ordinary}},
      {"dots", {"…", ordinary}},
      {"dotsc", {"…", ordinary}},
      {"cdots", {"⋯", ordinary}},
      {"dotsb", {"⋯", ordinary}},
      {"vdots", {"⋮", ordinary}},
      {"ddots", {"⋱", ordinary}},
      {"%", {"%", ordinary}},
      {"#", {"#", ordinary}},
      {"&", {"&amp;", ordinary}},
      {"$", {"$", ordinary}},
      {"_", {"_", ordinary}},
      {"neg", {"¬", ordinary}},
      {"lnot", {"¬", ordinary}},
      {"square", {"□", ordinary}},
      {"Box", {"□", ordinary}},
      {"dagger", {"†", binary}},
      {"triangle", {"△", ordinary}},
      {"star", {"⋆", binary}},
      {"int", {"∫", large}},
      {"iint", {"∬", large}},
      {"iiint", {"∭", large}},
      {"oint", {"∮", large}},
      {"sum", {"∑", large}},
      {"prod", {"∏", large}},
      {"coprod", {"∐", large}},
      {"bigcup", {"⋃", large}},
      {"bigcap", {"⋂", large}},
      {"bigoplus", {"⨁", large}},
      {"bigotimes", {"⨂", large}},
      {"pm", {"±", binary}},
      {"mp", {"∓", binary}},
      {"times", {"×", binary}},
      {"cdot", {"⋅", binary}},
      {"div", {"÷", binary}},
      {"ast", {"∗", binary}},
      {"circ", {"∘", binary}},
      {"bullet", {"∙", binary}},
      {"oplus", {"⊕", binary}},
      {"otimes", {"⊗", binary}},
      {"cup", {"∪", binary}},
      {"cap", {"∩", binary}},
      {"setminus", {"∖", binary}},
      {"wedge", {"∧", binary}},
      {"land", {"∧", binary}},
      {"vee", {"∨", binary}},
      {"lor", {"∨", binary}},
      {"le", {"≤", relation}},
      {"leq", {"≤", relation}},
      {"leqslant", {"⩽", relation}},
      {"ge", {"≥", relation}},
      {"geq", {"≥", relation}},
      {"geqslant", {"⩾", relation}},
      {"lt", {"&lt;", relation}},
      {"gt", {"&gt;", relation}},
      {"ll", {"≪", relation}},
      {"gg", {"≫", relation}},
      {"ne", {"≠", relation}},
      {"neq", {"≠", relation}},
      {"equiv", {"≡", relation}},
      {"approx", {"≈", relation}},
      {"sim", {"∼", relation}},
      {"simeq", {"≃", relation}},
      {"cong", {"≅", relation}},
      {"propto", {"∝", relation}},
      {"lesssim", {"≲", relation}},
      {"gtrsim", {"≳", relation}},
      {"in", {"∈", relation}},
      {"notin", {"∉", relation}},
      {"ni", {"∋", relation}},
      {"subset", {"⊂", relation}},
      {"subseteq", {"⊆", relation}},
      {"supset", {"⊃", relation}},
      {"supseteq", {"⊇", relation}},
      {"perp", {"⊥", relation}},
      {"parallel", {"∥", relation}},
      {"mid", {"∣", relation}},
      {"to", {"→", relation}},
      {"rightarrow", {"→", relation}},
      {"leftarrow", {"←", relation}},
      {"gets", {"←", relation}},
      {"leftrightarrow", {"↔", relation}},
      {"Rightarrow", {"⇒", relation}},
      {"implies", {"⟹", relation}},
      {"Leftarrow", {"⇐", relation}},
      {"Leftrightarrow", {"⇔", relation}},
      {"iff", {"⟺", relation}},
      {"mapsto", {"↦", relation}},
      {"longrightarrow", {"⟶", relation}},
      {"uparrow", {"↑", relation}},
      {"downarrow", {"↓", relation}},
      {"colon", {":", punctuation}},
      {"coloneqq", {"≔", relation}},
      {"langle", {"⟨", open}},
      {"rangle", {"⟩", close}},
      {"lbrace", {"{", open}},
      {"rbrace", {"}", close}},
      {"{", {"{", open}},
      {"}", {"}", close}},
      {"lfloor", {"⌊", open}},
      {"rfloor", {"⌋", close}},
      {"lceil", {"⌈", open}},
      {"rceil", {"⌉", close}},
      {"lvert", {"|", open}},
      {"rvert", {"|", close}},
      {"lVert", {"‖", open}},
      {"rVert", {"‖", close}},
      {"lbrack", {"[", open}},
      {"rbrack", {"]", close}},
      {"vert", {"|", ordinary}},
      {"Vert", {"‖", ordinary}},
      {"|", {"‖", ordinary}},
      {"backslash", {"\\", ordinary}},
  };
  return all;
}

// Where an alphabet of Unicode begins: capitals, small letters, digits, capital and small Greek
// letters; 0 for what it lacks.
struct Alphabet {
  std::string_view name;
  char32_t capital, small, digit, capital_greek, small_greek;
};

constexpr std::array<Alphabet, 8> alphabets{{
    {"mathbf", 0x1D400, 0x1D41A, 0x1D7CE, 0x1D6A8, 0x1D6C2},
    {"boldsymbol", 0x1D468, 0x1D482, 0x1D7CE, 0x1D71C, 0x1D736},
    {"bm", 0x1D468, 0x1D482, 0x1D7CE, 0x1D71C, 0x1D736},
    {"mathcal", 0x1D49C, 0x1D4B6, 0, 0, 0},
    {"mathfrak", 0x1D504, 0x1D51E, 0, 0, 0},
    {"mathbb", 0x1D538, 0x1D552, 0x1D7D8, 0, 0},
    {"mathsf", 0x1D5A0, 0x1D5BA, 0x1D7E2, 0, 0},
    {"mathtt", 0x1D670, 0x1D68A, 0x1D7F6, 0, 0},
}};

// Letters that Unicode had before it had the alphabets.
constexpr std::array<std::pair<char32_t, char32_t>, 24> older_letters{{
    {0x1D49D, 0x212C}, {0x1D4A0, 0x2130}, {0x1D4A1, 0x2131}, {0x1D4A3, 0x210B}, {0x1D4A4, 0x2110},
    {0x1D4A7, 0x2112}, {0x1D4A8, 0x2133}, {0x1D4AD, 0x211B}, {0x1D4BA, 0x212F}, {0x1D4BC, 0x210A},
    {0x1D4C4, 0x2134}, {0x1D506, 0x212D}, {0x1D50B, 0x210C}, {0x1D50C, 0x2111}, {0x1D515, 0x211C},
    {0x1D51D, 0x2128}, {0x1D53A, 0x2102}, {0x1D53F, 0x210D}, {0x1D545, 0x2115}, {0x1D547, 0x2119},
    {0x1D548, 0x211A}, {0x1D549, 0x211D}, {0x1D551, 0x2124}, {0x1D455, 0x210E},
}};

char32_t code_point(std::string_view character) {
  const auto byte = [&](std::size_t i) {
    return static_cast<char32_t>(static_cast<unsigned char>(character[i]));
  };
  switch (character.size()) {
    case 1:
      return byte(0);
    case 2:
      return (byte(0) & 0x1F) << 6 | (byte(1) & 0x3F);
    case 3:
      return (byte(0) & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F);
    case 4:
      return (byte(0) & 0x07) << 18 | (byte(1) & 0x3F) << 12 | (byte(2) & 0x3F) << 6 |
             (byte(3) & 0x3F);
    default:
      return 0;
  }
}

std::string utf8_of(char32_t code) {
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0 | code >> 6), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0 | code >> 12), tail(6), tail(0)};
  return {static_cast<char>(0xF0 | code >> 18), tail(12), tail(6), tail(0)};
}

}  // namespace

std::optional<MathSymbol> math_symbol(std::string_view name) {
  const auto found = symbols().find(name);
  return found == symbols().end() ? std::nullopt : std::optional(found->second);
}

std::optional<MathFunction> math_function(std::string_view name) {
  static constexpr std::array<MathFunction, 35> functions{
      {{"arccos", false}, {"arcsin", false}, {"arctan", false}, {"arg", false},   {"arsinh", false},
       {"cos", false},    {"cosh", false},   {"cot", false},    {"coth", false},  {"csc", false},
       {"deg", false},    {"dim", false},    {"exp", false},    {"hom", false},   {"ker", false},
       {"lg", false},     {"ln", false},     {"log", false},    {"sec", false},   {"sgn", false},
       {"sin", false},    {"sinh", false},   {"tan", false},    {"tanh", false},  {"det", true},
       {"gcd", true},     {"inf", true},     {"lim", true},     {"liminf", true}, {"limsup", true},
       {"max", true},     {"min", true},     {"Pr", true},      {"sup", true},    {"erf", false}}};
  for (const MathFunction& function : functions) {
    if (function.name == name) return function;
  }
  return std::nullopt;
}

std::string_view math_accent(std::string_view name) {
  static const std::unordered_map<std::string_view, std::string_view> accents{
      {"bar", "¯"},      {"hat", "^"},      {"tilde", "~"},         {"dot", "˙"},
      {"ddot", "¨"},     {"vec", "→"},      {"check", "ˇ"},         {"breve", "˘"},
      {"acute", "´"},    {"grave", "`"},    {"widehat", "^"},       {"widetilde", "~"},
      {"mathring", "˚"}, {"overline", "‾"}, {"overrightarrow", "→"}};
  const auto found = accents.find(name);
  return found == accents.end() ? std::string_view() : found->second;
}

std::string math_letter(std::string_view alphabet, std::string_view character) {
  for (const Alphabet& known : alphabets) {
    if (known.name != alphabet) continue;
    const char32_t code = code_point(character);
    char32_t mapped = 0;
    const auto shifted = [&](char32_t first, char32_t last, char32_t begin) {
      if (begin != 0 && code >= first && code <= last) mapped = begin + (code - first);
    };
    shifted('A', 'Z', known.capital);
    shifted('a', 'z', known.small);
    shifted('0', '9', known.digit);
    shifted(0x391, 0x3A9, known.capital_greek);
    shifted(0x3B1, 0x3C9, known.small_greek);
    for (const auto& [hole, older] : older_letters) {
      if (mapped == hole) mapped = older;
    }
    if (mapped != 0) return utf8_of(mapped);
  }
  return std::string(character);
}

}  // namespace literate
