// SPDX-License-Identifier: GPL-3.0-or-later
// Known Hilbert transforms, for example F. W. King, Hilbert Transforms, vol. 2 (2009), appendix 1.
#include "numerics/kernel_integrals.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "numbers.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(kernel_integrals_test)

using numerics::Estimate;
using numerics::KernelIntegrals;
using numerics::PiecewiseFunction;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

double uniform(double) {
  return 1;
}
double parabolic(double s) {
  return (1 - s) * (1 + s);
}
double elliptic(double s) {
  return std::sqrt((1 - s) * (1 + s));
}

KernelIntegrals integrals_of(double (*density)(double)) {
  return KernelIntegrals(PiecewiseFunction({{-1, 1, density}}));
}

double x_log(double t) {
  return t == 0 ? 0 : t * std::log(std::abs(t));
}

// The difference is below the reported error, which is small.
void check(const Estimate& estimate, double exact, double x) {
  BOOST_TEST_CONTEXT("x = " << x) {
    const double rounding_of_reference = 16 * tolerance::epsilon * (1 + std::abs(exact));
    BOOST_TEST(std::abs(estimate.value - exact) <= estimate.abs_error + rounding_of_reference);
    BOOST_TEST(estimate.abs_error < tolerance::quadrature);
  }
}

}  // namespace

namespace {

// A closed form of an integral, and its domain.
struct ClosedForm {
  const char* name;
  double (*density)(double);
  double (*exact)(double x);
  double (*point)(RandomInputs& random);
};

double anywhere(RandomInputs& random) {
  const double x = random.point(1e6);
  return std::abs(x) == 1 ? 0.5 : x;
}
double near(RandomInputs& random) {
  return random.point(10);
}
double inside(RandomInputs& random) {
  return random.uniform(-0.999, 0.999);
}
double outside(RandomInputs& random) {
  return random.sign() * random.log_uniform(1.001, 1e6);
}

const ClosedForm cauchy_forms[] = {
    {"of a uniform density", uniform,
     // |x| ≫ 1: ln((x+1)/(x−1)) itself loses digits; atanh does not.
     [](double x) {
       return std::abs(x) > 2 ? 2 * std::atanh(1 / x) : std::log(std::abs((x + 1) / (x - 1)));
     },
     anywhere},
    {"of a parabola", parabolic,
     [](double x) {
       const double logarithm = std::abs(x) == 1 ? 0 : std::log(std::abs((x + 1) / (x - 1)));
       return 2 * x + (1 - x) * (1 + x) * logarithm;
     },
     near},
    {"of an ellipse inside", elliptic, [](double x) { return pi * x; }, inside},
    {"of an ellipse outside", elliptic,
     [](double x) {
       const double root = std::sqrt((std::abs(x) - 1) * (std::abs(x) + 1));
       return pi / std::copysign(std::abs(x) + root, x);
     },
     outside},
};

const ClosedForm logarithmic_forms[] = {
    {"of a uniform density", uniform, [](double x) { return x_log(x + 1) - x_log(x - 1) - 2; },
     [](RandomInputs& random) { return random.point(50); }},
    {"of an ellipse inside", elliptic,
     [](double x) { return pi / 2 * (x * x - 0.5 - std::numbers::ln2); }, inside},
};

}  // namespace

BOOST_AUTO_TEST_CASE(integrals_agree_with_their_closed_forms) {
  RandomInputs random(1);
  for (const ClosedForm& form : cauchy_forms) {
    BOOST_TEST_CONTEXT("Cauchy integral " << form.name) {
      const auto integrals = integrals_of(form.density);
      for (int i = 0; i < 1000; ++i) {
        const double x = form.point(random);
        check(integrals.cauchy(x), form.exact(x), x);
      }
    }
  }
  for (const ClosedForm& form : logarithmic_forms) {
    BOOST_TEST_CONTEXT("logarithmic integral " << form.name) {
      const auto integrals = integrals_of(form.density);
      for (int i = 0; i < 1000; ++i) {
        const double x = form.point(random);
        check(integrals.logarithmic(x, 1), form.exact(x), x);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_cauchy_integral_at_a_jump_however_small_is_an_error) {
  BOOST_CHECK_THROW(integrals_of(uniform).cauchy(1), InvalidQuantity);
  BOOST_CHECK_THROW(integrals_of(uniform).cauchy(-1), InvalidQuantity);
  BOOST_CHECK_THROW(integrals_of(uniform).cauchy(NAN), InvalidQuantity);
  for (const double jump : {1e-12, 1e-6, -1e-3}) {
    const KernelIntegrals integrals(
        PiecewiseFunction({{-1, 0.5, uniform}, {0.5, 1, [jump](double) { return 1 + jump; }}}));
    BOOST_CHECK_THROW(integrals.cauchy(0.5), InvalidQuantity);
    BOOST_CHECK_NO_THROW(integrals.cauchy(0.5 + 1e-9));
  }
}

BOOST_AUTO_TEST_CASE(splitting_a_smooth_piece_changes_nothing) {
  const KernelIntegrals split(
      PiecewiseFunction({{-1, -0.2, parabolic}, {-0.2, 0.4, parabolic}, {0.4, 1, parabolic}}));
  for (const double x : {-0.2, 0.4, 0.4 + 1e-10, 0.4 - 1e-13, 0.1, 3.0}) {
    const double logarithm = std::log(std::abs((x + 1) / (x - 1)));
    check(split.cauchy(x), 2 * x + (1 - x * x) * logarithm, x);
  }
}

BOOST_AUTO_TEST_CASE(a_change_of_the_unit_of_length_shifts_the_logarithmic_integral_by_the_total) {
  const auto integrals = integrals_of(parabolic);
  const double total = 4.0 / 3;
  for (const double x : {0.0, 0.7, 1.0, 12.5}) {
    const Estimate shifted = integrals.logarithmic(x, 2.385);
    const Estimate plain = integrals.logarithmic(x, 1);
    check(shifted, plain.value - total * std::log(2.385), x);
  }
}

BOOST_AUTO_TEST_CASE(integral_below_grows_from_zero_to_the_total) {
  const auto integrals = integrals_of(parabolic);

  BOOST_TEST(integrals.integral_below(-2).value == 0);
  check(integrals.integral_below(0), 2.0 / 3, 0);
  check(integrals.integral_below(0.5), 2.0 / 3 + 0.5 - 0.125 / 3, 0.5);
  check(integrals.integral_below(7), 4.0 / 3, 7);
  check(integrals.total(), 4.0 / 3, 1);
}

BOOST_AUTO_TEST_CASE(evaluations_stay_below_those_of_plain_quadpack) {
  // scipy's quad, the same QUADPACK routines split at the kinks: 54 and 144 evaluations per point.
  int n_evaluations = 0;
  const auto rising = [&](double s) {
    ++n_evaluations;
    return 1 + s;
  };
  const auto falling = [&](double s) {
    ++n_evaluations;
    return 1 - s;
  };
  const KernelIntegrals integrals(PiecewiseFunction({{-1, 0, rising}, {0, 1, falling}}));
  for (const double x : {0.25, 0.75, 1.23, 2.0, 5.0}) {
    BOOST_TEST_CONTEXT("x = " << x) {
      n_evaluations = 0;
      integrals.cauchy(x);
      BOOST_TEST(n_evaluations <= 54);
      n_evaluations = 0;
      integrals.logarithmic(x, 1);
      BOOST_TEST(n_evaluations <= 144);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_error_at_a_square_root_of_the_density_includes_the_rounding_of_s) {
  // PV of sqrt(1−s²)/(x−s) is πx inside, here scaled: at the ends the quotient grows as t^{-1/2}.
  for (const double a : {1.0, 0.01, 0.75, 3.7e4}) {
    const auto root = [a](double s) { return std::sqrt(std::max(0.0, (a - s) * (a + s))) / a; };
    const numerics::KernelIntegrals integrals(numerics::PiecewiseFunction({{-a, a, root}}));
    for (const double x : {-a, a}) {
      const numerics::Estimate integral = integrals.cauchy(x);
      BOOST_TEST(std::abs(integral.value - std::numbers::pi * x / a) <= integral.abs_error);
      BOOST_TEST(integral.abs_error < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
