// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/assignment.hpp"
#include "message_of.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>
#include <string>

#include "course/assignment/student.hpp"
#include "course/toy.hpp"
#include "holds.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(variants_test)

using course::Variant;

namespace {

const auto all_are_valid = [](const Variant&) { return true; };

Variant variant(const std::string& student, const std::string& seed = "winter") {
  return course::variant_of(toy::assignment(), student, seed, all_are_valid);
}

}  // namespace

BOOST_AUTO_TEST_CASE(nobodys_variant_has_the_nominal_numbers) {
  const Variant nominal = course::nominal_variant(toy::assignment());

  BOOST_TEST(nominal.student.empty());
  BOOST_TEST(nominal("first") == 2.3);
  BOOST_TEST(nominal("second") == 41);
}

// python3 -c "import hashlib; print([a + int(hashlib.sha256(f'ada\n{q}\n0\nwinter'.encode())
//   .hexdigest()[:16], 16) % 89 * s for q, a, s in (('first', 1.1, .1), ('second', 11, 1))])"
BOOST_AUTO_TEST_CASE(a_variant_is_what_the_hash_says) {
  const Variant ada = variant("ada");

  BOOST_TEST(ada.student == "ada");
  BOOST_TEST(ada("first") == 8.9);
  BOOST_TEST(ada("second") == 37);
}

BOOST_AUTO_TEST_CASE(students_and_seeds_have_their_own_variants) {
  BOOST_CHECK(variant("ada").quantities == variant("ada").quantities);
  BOOST_CHECK(variant("ada").quantities != variant("bob").quantities);
  BOOST_CHECK(variant("ada").quantities != variant("ada", "summer").quantities);
}

BOOST_AUTO_TEST_CASE(every_place_of_the_grid_is_drawn_about_equally_often) {
  constexpr int n_students = 8900;
  std::map<double, int> n_drawn;

  for (int i = 0; i < n_students; ++i) ++n_drawn[variant(std::to_string(i))("first")];

  BOOST_TEST(n_drawn.size() == 89U);
  BOOST_TEST(n_drawn.begin()->first == 1.1);
  BOOST_TEST(n_drawn.rbegin()->first == 9.9);
  // Each is drawn 100 times on average; five standard deviations are 50.
  for (const auto& [value, n] : n_drawn) BOOST_TEST(std::abs(n - 100) < 50, value << ": " << n);
}

BOOST_AUTO_TEST_CASE(values_on_the_grid_are_the_decimals_that_they_look_like) {
  BOOST_TEST(variant("ada")("first") == std::round(variant("ada")("first") * 10) / 10);
  BOOST_TEST(course::on_grid({"q", "", 0.2, 0.4, 0.01, 0.3}, 8) == 0.28);
  BOOST_TEST(course::n_values({"q", "", 0.2, 0.4, 0.01, 0.3}) == 21U);
  BOOST_TEST(course::n_values({"q", "", 1, 2.5, 1, 1}) == 2U);
  BOOST_TEST(course::n_values({"q", "", 1, 1, 1, 1}) == 1U);
}

BOOST_AUTO_TEST_CASE(what_is_not_valid_is_drawn_again) {
  int n_refused = 0;
  const auto third_time = [&](const Variant&) { return ++n_refused > 2; };

  const Variant drawn = course::variant_of(toy::assignment(), "ada", "winter", third_time);

  BOOST_TEST(n_refused == 3);
  BOOST_CHECK(drawn.quantities != variant("ada").quantities);
}

BOOST_AUTO_TEST_CASE(ranges_without_a_valid_variant_are_told) {
  const auto never = [](const Variant&) { return false; };

  BOOST_TEST(holds(message_of<sys::SourceError>(
                       [&] { course::variant_of(toy::assignment(), "ada", "winter", never); }),
                   "\"ada\": none of 1000"));
}

BOOST_AUTO_TEST_CASE(an_id_that_could_not_name_a_file_is_refused_by_name) {
  for (const char* id : {"ada", "s1234567", "a.b@uni-x.example", "_", "A-1"}) {
    BOOST_CHECK_NO_THROW(course::require_student_id(id));
  }
  const std::string too_long(65, 'a');
  for (const std::string& id : std::initializer_list<std::string>{
           "", "a b", "a/b", "..", ".hidden", "-f", "\xC3\xA9va", "a\nb", "quote\"", "@ada",
           "ada.part", "ada.zip", "ada.tar.gz", too_long}) {
    const std::string what = message_of<sys::SourceError>([&] { course::require_student_id(id); });
    BOOST_TEST((what.starts_with("student \"") && !holds(what, "\n")), what);
  }
  BOOST_CHECK_THROW(variant("ada", ""), sys::SourceError);
}

BOOST_AUTO_TEST_SUITE_END()
