// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/latex.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "holds.hpp"
#include "literate/text/characters.hpp"

BOOST_AUTO_TEST_SUITE(latex_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(text_for_latex_shows_every_character) {
  BOOST_TEST(escape_latex(R"(5 % a_b \ ~)") == R"(5 \% a\_b \textbackslash{} \textasciitilde{})");
  BOOST_TEST(escape_latex("ν ≤ é") == R"(\ensuremath{\nu} \ensuremath{\leq} \'{e})");
  BOOST_TEST(escape_latex("a\nb\x01") == "a b ");
  BOOST_TEST(escape_latex("語\xFF") == "語\xFF");
}

BOOST_AUTO_TEST_CASE(the_first_character_that_latex_cannot_print_is_found) {
  BOOST_TEST(first_unprintable("").empty());
  BOOST_TEST(first_unprintable("Größe ~ #1 \\x ≤ 2 µm").empty());
  BOOST_TEST(first_unprintable("ab😀c語") == "😀");
  BOOST_TEST(first_unprintable("ä\nb") == "\n");
  BOOST_TEST(first_unprintable("\x7F") == "\x7F");
  BOOST_TEST(first_unprintable("a\xFF") == "\xFF");
}

BOOST_AUTO_TEST_CASE(a_bookmark_keeps_what_is_beyond_ascii) {
  BOOST_TEST(escape_bookmark("ν_x 語") == "ν\\_x 語");
}

BOOST_AUTO_TEST_CASE(a_path_may_break_after_each_slash) {
  BOOST_TEST(escape_latex_path("src/a_b.cpp") == "src/\\allowbreak{}a\\_b.cpp");
}

BOOST_AUTO_TEST_CASE(plain_text_is_what_a_reader_of_latex_reads) {
  BOOST_TEST(plain_text("$\\theta$") == "θ");
  BOOST_TEST(plain_text("$\\partial u_z/\\partial x$") == "∂u_z/∂x");
  BOOST_TEST(plain_text("$u_z$, eq.~(3)") == "u_z, eq. (3)");
  BOOST_TEST(plain_text("convergence, \\% \\& more\\,--\\,less") == "convergence, % & more – less");
  BOOST_TEST(plain_text("$1 + \\theta^2/16$") == "1 + θ^2/16");
  BOOST_TEST(plain_text("$\\mathrm{d}x$") == "dx");
  BOOST_TEST(plain_text("$\\frac{a}{b}$") == "$\\frac{a}{b}$");
  BOOST_TEST(plain_text("from $20\\,^\\circ$C to $5^{\\circ}$") == "from 20 °C to 5°");
  BOOST_TEST(plain_text(escape_latex("at 5°")) == "at 5°");
  BOOST_TEST(plain_text("less than \\qty{1.5e-6}{m.s^{-1}}, or \\num{12} of \\unit{in}.") ==
             "less than 1.5e-6 m s⁻¹, or 12 of in.");
}

BOOST_AUTO_TEST_CASE(mathematical_letters_are_symbols_in_italics) {
  BOOST_TEST(escape_latex("10⁻¹²") == "10\\ensuremath{^{-12}}");
  BOOST_TEST(escape_latex("over 𝑝₀") == "over \\ensuremath{p}\\ensuremath{_{0}}");
  BOOST_TEST(escape_latex("𝑎𝑧𝐴𝑍ℎ") ==
             "\\ensuremath{a}\\ensuremath{z}\\ensuremath{A}\\ensuremath{Z}\\ensuremath{h}");
}

BOOST_AUTO_TEST_CASE(listings_know_every_character_that_text_knows) {
  const std::string setting = listings_characters();
  for (const char* character : {"ν", "≤", "−", "é", "Ž", "𝑝", "ₛ"}) {
    const std::string latex(latex_of(character));
    BOOST_TEST(holds(setting, std::string("{") + character + "}{{" + latex + "}}1"));
  }
  BOOST_TEST(latex_of("語").empty());
}

BOOST_AUTO_TEST_SUITE_END()
