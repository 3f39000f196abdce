// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/profile.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "multiprecision.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(profile_test)

using line_contact::Profile;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::vector<double> measured_x{-2.1, -1.3, 0.2385, 0.7, 1.9, 2.6};
const std::vector<double> measured_gap{1.7, 0.4, 0.013, 0.2, 0.2, 3.1};
const Profile measured = Profile::tabulated(measured_x, measured_gap);

// A profile and its formula in a hundred digits.
struct Formula {
  const char* name;
  Profile profile;
  std::function<Precise(const Precise&)> gap;
};

Precise beyond(const Precise& x, double b) {
  const Precise distance = abs(x) - b;
  return distance > 0 ? distance : Precise(0);
}

const std::vector<Formula> formulas{
    {"parabola", Profile::parabola(2.385),
     [](const Precise& x) -> Precise { return Precise(2.385) * x * x / 2; }},
    {"wedge", Profile::wedge(0.0371), [](const Precise& x) -> Precise { return 0.0371 * abs(x); }},
    {"rounded punch", Profile::rounded_punch(0.63, 1.7),
     [](const Precise& x) -> Precise { return Precise(1.7) * pow(beyond(x, 0.63), 2) / 2; }},
    {"power law", Profile::power_law(0.57, 3),
     [](const Precise& x) -> Precise { return 0.57 * pow(x, 6); }},
    {"highest power", Profile::power_law(0.57, Profile::max_power),
     [](const Precise& x) -> Precise { return 0.57 * pow(x, 2 * Profile::max_power); }}};

double relative_error(double value, const Precise& exact) {
  return exact == 0 ? std::abs(value) : static_cast<double>(abs((value - exact) / exact));
}

template <class Make>
void check_refused(const Make& make, const char* quantity) {
  BOOST_CHECK_EXCEPTION(make(), InvalidQuantity,
                        [&](const InvalidQuantity& e) { return e.quantity() == quantity; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(gaps_are_those_of_the_formulas) {
  RandomInputs random(5);
  for (const Formula& formula : formulas) {
    for (int i = 0; i < 100; ++i) {
      const double x = random.uniform(-1.9, 1.9);
      BOOST_TEST_CONTEXT(formula.name << ", x = " << x) {
        // the power takes 2n times the rounding of x², |x| − b its own
        const double error = relative_error(formula.profile.gap(x), formula.gap(x));
        BOOST_TEST(error < 10 * tolerance::rounding);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(rises_keep_their_digits_however_close_the_points) {
  RandomInputs random(6);
  for (const Formula& formula : formulas) {
    for (int i = 0; i < 200; ++i) {
      const double from = random.sign() * random.uniform(0.7, 1.9);
      const double to = from + random.sign() * random.log_uniform(1e-14, 0.01);
      BOOST_TEST_CONTEXT(formula.name << ", from " << from << " to " << to) {
        const Precise exact = formula.gap(to) - formula.gap(from);
        BOOST_TEST(relative_error(formula.profile.rise(from, to), exact) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(rises_across_the_middle_and_onto_the_flat_are_differences_of_gaps) {
  const std::vector<std::pair<double, double>> steps{
      {-1.3, 0.7}, {0.2, -1.1}, {-0.2, 0.3}, {0.5, 0.9}, {-0.9, -0.5}, {0, 1.2385}, {1.1, 1.1}};
  for (const Formula& formula : formulas) {
    for (const auto& [from, to] : steps) {
      BOOST_TEST_CONTEXT(formula.name << ", from " << from << " to " << to) {
        const double difference = formula.profile.gap(to) - formula.profile.gap(from);
        BOOST_TEST(std::abs(formula.profile.rise(from, to) - difference) <
                   tolerance::rounding * (1 + std::abs(difference)));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(formulas_are_symmetric_and_without_end) {
  for (const Formula& formula : formulas) {
    BOOST_TEST(formula.profile.is_symmetric());
    BOOST_TEST(formula.profile.gap(-1.2385) == formula.profile.gap(1.2385));
    BOOST_TEST(formula.profile.begin() == -infinity);
    BOOST_TEST(formula.profile.end() == infinity);
  }
}

BOOST_AUTO_TEST_CASE(a_rounded_punch_without_a_flat_is_a_parabola) {
  const Profile punch = Profile::rounded_punch(0, 2.385);
  const Profile parabola = Profile::parabola(2.385);

  BOOST_TEST(punch.gap(0.7) == parabola.gap(0.7));
  BOOST_TEST(relative_difference(punch.rise(-0.3, 0.7), parabola.rise(-0.3, 0.7)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(the_first_power_is_a_parabola_too) {
  const Profile power = Profile::power_law(2.385, 1);
  const Profile parabola = Profile::parabola(2 * 2.385);

  BOOST_TEST(relative_difference(power.gap(0.7), parabola.gap(0.7)) < 1e-15);
  BOOST_TEST(relative_difference(power.rise(0.69, 0.7), parabola.rise(0.69, 0.7)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_measured_profile_goes_through_its_points_and_ends_with_them) {
  for (std::size_t i = 0; i < measured_x.size(); ++i) {
    BOOST_TEST(std::abs(measured.gap(measured_x[i]) - measured_gap[i]) < tolerance::rounding * 3.1);
  }
  BOOST_TEST(measured.begin() == -2.1);
  BOOST_TEST(measured.end() == 2.6);
  BOOST_TEST(!measured.is_symmetric());
}

BOOST_AUTO_TEST_CASE(a_measured_profile_does_not_overshoot) {
  for (std::size_t i = 0; i + 1 < measured_x.size(); ++i) {
    const auto [low, high] = std::minmax(measured_gap[i], measured_gap[i + 1]);
    for (const double share : {0.05, 0.2385, 0.5, 0.77, 0.99}) {
      const double at = measured_x[i] + share * (measured_x[i + 1] - measured_x[i]);
      BOOST_TEST(measured.gap(at) >= low - 1e-15);
      BOOST_TEST(measured.gap(at) <= high + 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_measured_profile_has_no_kink_at_its_points) {
  constexpr double step = 1e-7;
  for (std::size_t i = 1; i + 1 < measured_x.size(); ++i) {
    const double x = measured_x[i];
    const double left = (measured.gap(x) - measured.gap(x - step)) / step;
    const double right = (measured.gap(x + step) - measured.gap(x)) / step;
    BOOST_TEST(std::abs(right - left) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_measured_profile_rises_by_the_difference_of_its_gaps) {
  BOOST_TEST(measured.rise(-1.7, 2.385) == measured.gap(2.385) - measured.gap(-1.7));
}

BOOST_AUTO_TEST_CASE(copies_outlive_the_original) {
  Profile copy = Profile::parabola(1);
  {
    const Profile original = Profile::tabulated(measured_x, measured_gap);
    copy = original;
  }

  BOOST_TEST(copy.gap(0.2385) == measured.gap(0.2385));
}

BOOST_AUTO_TEST_CASE(shapes_out_of_range_are_refused_by_name) {
  for (const double bad : {0.0, -2.385, double(NAN), infinity}) {
    check_refused([=] { return Profile::parabola(bad); }, "relative_curvature");
    check_refused([=] { return Profile::wedge(bad); }, "slope");
    check_refused([=] { return Profile::rounded_punch(1, bad); }, "edge_curvature");
    check_refused([=] { return Profile::power_law(bad, 2); }, "coefficient");
  }
  for (const double bad : {-1e-300, -1.0, double(NAN), infinity}) {
    check_refused([=] { return Profile::rounded_punch(bad, 1); }, "flat_half_width");
  }
  for (const int bad : {0, -1, Profile::max_power + 1}) {
    check_refused([=] { return Profile::power_law(1, bad); }, "n");
  }
}

BOOST_AUTO_TEST_CASE(measured_points_that_make_no_profile_are_refused_by_name) {
  const auto tabulate = [](std::vector<double> x, std::vector<double> gap) {
    return [=] { return Profile::tabulated(x, gap); };
  };
  check_refused(tabulate({1, 2, 3}, {1, 0, 1}), "profile points");
  check_refused(tabulate({1, 2, 3, 4}, {1, 0, 1}), "profile points");
  check_refused(tabulate({}, {}), "profile points");
  check_refused(tabulate({1, 2, 2, 4}, {1, 0, 1, 2}), "profile x");
  check_refused(tabulate({1, 2, 1.5, 4}, {1, 0, 1, 2}), "profile x");
  check_refused(tabulate({1, 2, 3, infinity}, {1, 0, 1, 2}), "profile x");
  check_refused(tabulate({1, 2, 3, 4}, {1, 0, double(NAN), 2}), "profile gap");
  BOOST_CHECK_NO_THROW(Profile::tabulated({1, 2, 3, 4}, {1, 0, 1, 2}));
}

BOOST_AUTO_TEST_SUITE_END()
