// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "literate/page/math_symbols.hpp"
#include "literate/page/tex_reader.hpp"

namespace literate {

/// What a formula asks of the page around it.
struct FormulaSurroundings {
  /// HTML of what stands in \text.
  std::function<std::string(const PageTokens&)> text;
  /// Does what a command that is no mathematics does, such as \val: the HTML that it prints goes to
  /// `html`, tokens are pushed to the reader. False if the page does not know the command either.
  std::function<bool(const PageToken&, std::string& html)> command;
  /// Is told what the page cannot show.
  std::function<void(const PageToken&, const std::string& message)> complain;
};

/// Turns formulas of LaTeX into MathML, in the part of it that browsers show (MathML Core).
///
/// Letters, numbers, operators, scripts, fractions, roots, accents, braces with labels, delimiters
/// that stretch, \text, matrices, cases and aligned rows. Spaces are TeX's where the dictionary of
/// operators has others.
class Formula {
 public:
  Formula(TexReader& reader, const FormulaSurroundings& surroundings)
      : reader_(reader), surroundings_(surroundings) {}

  /// The content of <math>.
  std::string mathml(const PageTokens& tokens);

 private:
  struct Atom {
    std::string html;
    AtomClass atom_class = AtomClass::ordinary;
    bool takes_limits = false;
  };

  std::string row(const std::function<bool(const PageToken&)>& ends);
  std::string argument();
  std::string grouped(const PageTokens& tokens);
  static std::string joined(const std::vector<Atom>& atoms);
  bool read_atom(std::vector<Atom>& atoms);
  Atom character(const PageToken& token);
  std::string number(std::string digits);
  Atom operator_atom(std::string_view character) const;
  bool command(const PageToken& token, std::vector<Atom>& atoms);
  bool structure(const PageToken& token, std::vector<Atom>& atoms);
  bool style(const PageToken& token, std::vector<Atom>& atoms);
  bool space(const PageToken& token, std::vector<Atom>& atoms);
  bool sized_delimiter(std::string_view name, std::vector<Atom>& atoms);
  Atom stretched();
  std::string delimiter();
  Atom letters(std::string_view alphabet, const PageTokens& tokens);
  std::string environment(const std::string& name);
  void read_scripts(Atom& atom);
  std::string primes();

  TexReader& reader_;
  const FormulaSurroundings& surroundings_;
  std::string alphabet_;
};

/// The cells of the rows that && and \\ part, outside braces and environments.
std::vector<std::vector<PageTokens>> formula_rows(const PageTokens& tokens);

}  // namespace literate
