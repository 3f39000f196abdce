// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/listing_language.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(listing_language_test)

using literate::listing_language;

BOOST_AUTO_TEST_CASE(the_name_of_a_file_tells_its_language) {
  BOOST_TEST(listing_language("src/a.cpp") == "[20]C++");
  BOOST_TEST(listing_language("octave/Tri_dist.m") == "Octave");
  BOOST_TEST(listing_language("case.toml") == "TOML");
  BOOST_TEST(listing_language("Makefile") == "[gnu]make");
  BOOST_TEST(listing_language("src/CMakeLists.txt") == "CMake");
}

BOOST_AUTO_TEST_CASE(a_text_of_no_known_language_is_printed_as_it_is) {
  BOOST_TEST(listing_language("notes.txt") == "");
  BOOST_TEST(listing_language("cpp") == "");
}

BOOST_AUTO_TEST_SUITE_END()
