// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/graded_contact.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "contact/contact_search.hpp"
#include "numerics/kernel_integrals.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(graded_contact_test)

using contact::ContactError;
using line_contact::Edges;
using line_contact::GradedSolution;
using line_contact::Profile;
using line_contact::solve_on_graded_grid;
using std::numbers::pi;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 2.385;
using Function = std::function<double(double)>;

// A profile, and the load, pressure and peak of its contact of half-width a.
struct Closed {
  Profile profile;
  double a;
  double load;
  Function pressure;
  double peak;

  GradedSolution solve(long n_elements) const {
    return solve_on_graded_grid(profile, modulus, load, n_elements, {-0.7 * a, 1.3 * a});
  }
};

// h = A x²ⁿ: p = E* n A a²ⁿ⁻¹ √(1−ξ²) Σ c_k ξ²⁽ⁿ⁻¹⁻ᵏ⁾, c_k = (2k−1)!!/(2k)!!, P = π E* n A a²ⁿ c_n.
// Steuermann (1939); n = 1 is Hertz's contact.
Closed power_law(int n, double a, double peak_ratio) {
  const double coefficient = 0.7;
  const double scale = modulus * n * coefficient * std::pow(a, 2 * n - 1);
  double c = 1;
  for (int k = 1; k <= n; ++k) c *= (2 * k - 1) / (2.0 * k);
  const auto pressure = [=](double x) {
    const double xi = std::min(1.0, std::abs(x) / a);
    double sum = 0;
    double c_k = 1;
    for (int k = 0; k < n; c_k *= (2 * k + 1) / (2.0 * k + 2), ++k) {
      sum += c_k * std::pow(xi, 2 * (n - 1 - k));
    }
    return scale * sum * std::sqrt((1 - xi) * (1 + xi));
  };
  return {Profile::power_law(coefficient, n), a, pi * scale * a * c, pressure, peak_ratio * scale};
}

Closed hertz(double a) {
  return power_law(1, a, 1);
}

// x⁴: (1/2 + ξ²)√(1−ξ²) has its greatest value 1/√2 at ξ² = 1/2.
Closed fourth_power(double a) {
  return power_law(2, a, std::sqrt(0.5));
}

// h = |x| tan α: p = (E* tan α/π) arcosh(a/|x|), P = E* a tan α (Johnson §5.2).
Closed wedge(double a) {
  const double slope = 0.3;
  return {Profile::wedge(slope), a, modulus * slope * a,
          [=](double x) {
            return std::abs(x) < a ? modulus * slope / pi * std::acosh(a / std::abs(x)) : 0;
          },
          std::numeric_limits<double>::infinity()};
}

// Ciavarella, Hills & Monno (1998), Proc. IMechE C 212, 319, sin φ₀ = b/a, sin φ = |x|/a:
//   p = (κE*a/2π) {(π−2φ₀) cos φ + ln[|sin(φ+φ₀)/sin(φ−φ₀)|^sin φ |tan½(φ+φ₀) tan½(φ−φ₀)|^sin φ₀]}.
Closed rounded_punch(double b, double a) {
  const double curvature = 0.7;
  const double phi0 = std::asin(b / a);
  const double load =
      modulus * curvature * a * a / 2 * (pi / 2 - phi0 - std::sin(phi0) * std::cos(phi0));
  const auto pressure = [=](double x) -> double {
    if (std::abs(x) >= a) return 0;
    const double phi = std::asin(std::abs(x) / a);
    const double sum = phi + phi0;
    const double difference = phi - phi0;
    const double logs =
        std::sin(phi) * std::log(std::abs(std::sin(sum) / std::sin(difference))) +
        std::sin(phi0) * std::log(std::abs(std::tan(sum / 2) * std::tan(difference / 2)));
    return modulus * curvature * a / (2 * pi) * ((pi - 2 * phi0) * std::cos(phi) + logs);
  };
  return {Profile::rounded_punch(b, curvature), a, load, pressure, 0};
}

// Greatest error of the pressure at the nodes.
double nodal_error(const GradedSolution& s, const Function& exact) {
  return (s.pressure - s.x.unaryExpr(exact)).cwiseAbs().maxCoeff();
}

// The same at 19 points in each element, with its parabola or without.
double error_between(const GradedSolution& s, const Function& exact, bool with_bulges) {
  double error = 0;
  for (Eigen::Index i = 0; i + 1 < s.x.size(); ++i) {
    for (double share = 0.05; share < 0.99; share += 0.05) {
      const double x = s.x[i] + share * (s.x[i + 1] - s.x[i]);
      const double straight = s.pressure[i] + share * (s.pressure[i + 1] - s.pressure[i]);
      error = std::max(error, std::abs((with_bulges ? s.pressure_at(x) : straight) - exact(x)));
    }
  }
  return error;
}

// log₂ of the ratio of two errors, the second on twice as many elements.
double order(double coarse, double fine) {
  return std::log2(std::abs(coarse / fine));
}

// Whether an error's message contains `what`.
std::function<bool(const ContactError&)> says(const char* what) {
  return [what](const ContactError& e) {
    return std::string(e.what()).find(what) != std::string::npos;
  };
}

// A table of h at n_points, even from begin to end.
Profile table(const Function& h, double begin, double end, int n_points) {
  std::vector<double> x;
  std::vector<double> gap;
  for (int i = 0; i < n_points; ++i) {
    x.push_back(begin + (end - begin) * i / (n_points - 1));
    gap.push_back(h(x.back()));
  }
  return Profile::tabulated(x, gap);
}

}  // namespace

BOOST_AUTO_TEST_CASE(
    a_hundred_elements_give_hertz_pressure_to_1e_4_and_half_width_and_peak_to_4e_9) {
  const Closed exact = hertz(1.7);
  const GradedSolution s = exact.solve(100);

  BOOST_TEST(nodal_error(s, exact.pressure) < 2.5e-5 * exact.peak);
  BOOST_TEST(error_between(s, exact.pressure, true) < 5.5e-5 * exact.peak);
  BOOST_TEST(error_between(s, exact.pressure, false) < 1e-4 * exact.peak);
  BOOST_TEST(relative_difference(s.half_width(), exact.a) < 4e-9);
  BOOST_TEST(relative_difference(s.peak_pressure(), exact.peak) < 2e-9);
  BOOST_TEST(std::abs(s.edges.left + s.edges.right) < 1e-11 * exact.a);
}

BOOST_AUTO_TEST_CASE(greatest_error_converges_with_order_two_half_width_with_order_four) {
  for (const Closed& exact : {hertz(1.7), fourth_power(0.9)}) {
    const GradedSolution coarse = exact.solve(50);
    const GradedSolution fine = exact.solve(100);
    const double at_nodes =
        order(nodal_error(coarse, exact.pressure), nodal_error(fine, exact.pressure));
    const double between = order(error_between(coarse, exact.pressure, true),
                                 error_between(fine, exact.pressure, true));
    BOOST_TEST(std::abs(at_nodes - 2) < 0.05);
    BOOST_TEST(std::abs(between - 2) < 0.05);
    BOOST_TEST(std::abs(order(coarse.half_width() - exact.a, fine.half_width() - exact.a) - 4) <
               0.1);
  }
}

BOOST_AUTO_TEST_CASE(every_power_of_x_has_its_half_width_to_4e_9_and_pressure_to_1e_4) {
  for (int n = 1; n <= 5; ++n) {
    const Closed exact = power_law(n, 0.9, 1);
    const GradedSolution s = exact.solve(100);
    BOOST_TEST_CONTEXT("n = " << n) {
      BOOST_TEST(relative_difference(s.half_width(), exact.a) < 4e-9);
      BOOST_TEST(nodal_error(s, exact.pressure) < 1e-4 * s.peak_pressure());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_peak_between_nodes_is_found) {
  const Closed exact = fourth_power(0.9);
  const GradedSolution s = exact.solve(100);

  BOOST_TEST(relative_difference(s.peak_pressure(), exact.peak) < 2e-6);
  BOOST_TEST(relative_difference(s.pressure.maxCoeff(), exact.peak) > 4e-6);
}

BOOST_AUTO_TEST_CASE(a_wedge_has_its_half_width_to_order_two_and_its_pressure_off_the_edge) {
  // Infinite at x = 0, where the element's pressure is not.
  const Closed exact = wedge(0.9);
  const GradedSolution coarse = exact.solve(50);
  const GradedSolution fine = exact.solve(100);

  BOOST_TEST(relative_difference(fine.half_width(), exact.a) < 6e-5);
  BOOST_TEST(std::abs(order(coarse.half_width() - exact.a, fine.half_width() - exact.a) - 2) < 0.1);
  for (const double share : {-0.9, -0.5, 0.3, 0.999}) {
    const double x = share * exact.a;
    BOOST_TEST(std::abs(fine.pressure_at(x) - exact.pressure(x)) < 4e-4 * modulus * 0.3);
  }
}

BOOST_AUTO_TEST_CASE(a_rounded_punch_has_its_half_width_to_2e_7_and_its_pressure_to_order_one) {
  for (const double ratio : {0.3, 0.5, 0.8, 0.95, 0.99}) {
    const Closed exact = rounded_punch(ratio * 0.9, 0.9);
    const GradedSolution coarse = exact.solve(25);
    const GradedSolution s = exact.solve(100);
    const double error = nodal_error(s, exact.pressure);
    BOOST_TEST_CONTEXT("b/a = " << ratio) {
      BOOST_TEST(relative_difference(s.half_width(), exact.a) < 2e-7);
      BOOST_TEST(error < 0.01 * s.peak_pressure());
      BOOST_TEST(order(nodal_error(coarse, exact.pressure), error) > 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_tilted_parabola_is_hertz_shifted) {
  // x²/2 + x/5 is the parabola about −1/5 but for a constant; from a table of it.
  const double a = 0.9;
  const double load = pi * modulus * a * a / 4;
  const Profile tilted = table([](double x) { return x * x / 2 + x / 5; }, -2, 2, 4001);
  const GradedSolution s = solve_on_graded_grid(tilted, modulus, load, 100, {-0.8, 0.6});
  const Function pressure = [=](double x) {
    return modulus / 2 * std::sqrt(std::max(0.0, a * a - (x + 0.2) * (x + 0.2)));
  };
  BOOST_TEST(std::abs(s.edges.left + 1.1) < 2e-7);
  BOOST_TEST(std::abs(s.edges.right - 0.7) < 2e-7);
  BOOST_TEST(relative_difference(s.peak_pressure(), modulus * a / 2) < 1e-5);
  BOOST_TEST(nodal_error(s, pressure) < 1e-3 * modulus * a / 2);
}

BOOST_AUTO_TEST_CASE(a_lopsided_profile_has_its_two_edges_and_pressure) {
  // h = x²/2 + c x³/3. With ξ = (x−m)/a and h' = b₁ξ + b₂(2ξ²−1), b₁ = a(1+2cm), b₂ = ca²/2, the
  // pressure is (E*/2)√(1−ξ²)(b₁ + 2b₂ξ), P = πE*a b₁/4, if h' has mean 0: m + c(m² + a²/2) = 0;
  // for PV∫ √(1−τ²) U_{k−1}(τ)/(ξ−τ) dτ = π T_k(ξ), |τ| < 1.
  const double c = 0.4;
  const double a = 0.9;
  const double m = (std::sqrt(1 - 2 * c * c * a * a) - 1) / (2 * c);
  const double b1 = a * (1 + 2 * c * m);
  const double b2 = c * a * a / 2;
  const Profile lopsided = table([=](double x) { return x * x * (0.5 + c * x / 3); }, -2, 2, 4001);
  const GradedSolution s =
      solve_on_graded_grid(lopsided, modulus, pi * modulus * a * b1 / 4, 100, {-1.2, 1.1});
  const auto pressure = [=](double x) {
    const double xi = (x - m) / a;
    return modulus / 2 * std::sqrt(std::max(0.0, 1 - xi * xi)) * (b1 + 2 * b2 * xi);
  };

  BOOST_TEST(std::abs(s.edges.left - (m - a)) < 2e-7);
  BOOST_TEST(std::abs(s.edges.right - (m + a)) < 2e-7);
  BOOST_TEST(nodal_error(s, pressure) < 1e-3 * s.peak_pressure());
}

BOOST_AUTO_TEST_CASE(equilibrium_equation_1a_and_symmetry_hold_to_rounding) {
  for (const Closed& exact : {hertz(1.7), fourth_power(0.9), wedge(0.9), rounded_punch(0.5, 0.9)}) {
    const GradedSolution s = exact.solve(100);
    const auto gap = [&](double x) { return std::abs(exact.profile.gap(x) - s.approach(x)); };
    const double misfit = s.x.unaryExpr(gap).maxCoeff();
    BOOST_TEST(relative_difference(s.line_load(), exact.load) < 1e-13);
    BOOST_TEST(misfit < 1e-13 * exact.load / modulus);
    BOOST_TEST(s.misfit == misfit);
    BOOST_TEST((s.pressure - s.pressure.reverse()).cwiseAbs().maxCoeff() <
               1e-6 * s.peak_pressure());
  }
}

BOOST_AUTO_TEST_CASE(between_the_nodes_equation_1a_holds_to_2e_9_and_outside_1b_does) {
  const Closed exact = hertz(1.7);
  const GradedSolution s = exact.solve(100);
  const double indentation = exact.profile.gap(exact.a);
  RandomInputs random(61);
  for (int i = 0; i < 300; ++i) {
    const double inside = random.uniform(s.edges.left, s.edges.right);
    const double outside = random.sign() * exact.a * (1 + random.log_uniform(1e-4, 1e2));
    BOOST_TEST(std::abs(exact.profile.gap(inside) - s.approach(inside)) < 2e-9 * indentation);
    BOOST_TEST(exact.profile.gap(outside) > s.approach(outside));
  }
}

BOOST_AUTO_TEST_CASE(the_approach_is_that_of_the_pressure_by_quadrature) {
  // δ(datum) − δ(x) = (2/(πE*)) ∫ p ln|(datum−s)/(x−s)| ds for the elements' own pressure.
  const GradedSolution s = fourth_power(0.9).solve(6);
  std::vector<numerics::Piece> pieces;
  for (Eigen::Index i = 0; i + 1 < s.x.size(); ++i) {
    pieces.push_back({s.x[i], s.x[i + 1], [&](double x) { return s.pressure_at(x); }});
  }
  const numerics::KernelIntegrals integrals{numerics::PiecewiseFunction(pieces)};
  const double constant = 2 / (pi * modulus);
  for (const double datum : {-40.0, -0.9, 0.123, 3.1}) {
    const double by_quadrature =
        s.approach_at_half_width + constant * integrals.logarithmic(datum, s.half_width()).value;
    BOOST_TEST(std::abs(s.approach(datum) - by_quadrature) < 1e-10);
  }
  BOOST_TEST(relative_difference(s.line_load(), integrals.total().value) < 1e-10);
}

BOOST_AUTO_TEST_CASE(any_start_finds_the_same_edges_and_one_wrong_by_30_percent_soon) {
  RandomInputs random(62);
  for (const Closed& exact :
       {hertz(0.9), power_law(5, 0.9, 1), wedge(0.9), rounded_punch(0.8, 0.9)}) {
    double least = 2 * exact.a;
    double greatest = 0;
    for (int i = 0; i < 60; ++i) {
      const double shift = i % 3 == 0 ? random.uniform(-3, 3) : 0;  // beside the contact
      const double widest = i % 3 == 1 ? 0.7 : 4;                   // within a flat
      const Edges start{shift - random.uniform(0.05, widest), shift + random.uniform(0.05, widest)};
      const GradedSolution s = solve_on_graded_grid(exact.profile, modulus, exact.load, 12, start);
      least = std::min(least, s.edges.right);
      greatest = std::max(greatest, s.edges.right);
    }
    BOOST_TEST(greatest - least < 1e-9);
    BOOST_TEST(exact.solve(20).n_iterations <= 10);
  }
  BOOST_TEST(hertz(0.9).solve(20).n_iterations <= 3);
}

BOOST_AUTO_TEST_CASE(lengths_and_stresses_scale) {
  for (const double scale : {1e-9, 25.4, 1e9}) {
    const double a = 1.7 * scale;
    const GradedSolution s =
        solve_on_graded_grid(Profile::parabola(1 / scale), modulus * 1e7,
                             pi / 4 * modulus * 1e7 * a * 1.7, 20, {-0.7 * a, 1.3 * a});
    const GradedSolution same = hertz(1).solve(20);
    BOOST_TEST(relative_difference(s.half_width() / a, same.half_width()) < 1e-11);
    BOOST_TEST(relative_difference(s.peak_pressure() / (modulus * 1e7 * 1.7 / 2),
                                   same.peak_pressure() / (modulus * 0.7)) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(nodes_rise_from_edge_to_edge_with_no_pressure_beyond) {
  const long n = 100;
  const GradedSolution s = hertz(1.7).solve(n);
  const Eigen::VectorXd length = s.x.tail(2 * n) - s.x.head(2 * n);

  BOOST_TEST(s.x.size() == 2 * n + 1);
  BOOST_TEST((s.x[0] == s.edges.left && s.x[2 * n] == s.edges.right));
  BOOST_TEST((s.pressure[0] == 0 && s.pressure[2 * n] == 0));
  for (const double x : {s.edges.left, s.edges.right, -5.0, 5.0}) BOOST_TEST(s.pressure_at(x) == 0);
  // a sin(½π sin θ), θ = −¼π and the last node but one
  BOOST_TEST(std::abs(s.x[n / 2] + s.half_width() * std::sin(pi / 2 * std::sqrt(0.5))) < 1e-11);
  const double first = std::pow(pi, 6) / 512 / std::pow(static_cast<double>(n), 4);
  BOOST_TEST(relative_difference(length[0], first * s.half_width()) < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_contact_that_reaches_the_end_of_its_profile_is_an_error) {
  const auto parabola = [](double x) { return x * x / 2; };
  const double load = pi * modulus / 4;  // half-width 1
  for (const Edges ends : {Edges{-0.9, 0.9}, Edges{-3, 0.9}, Edges{-0.9, 3}}) {
    const Profile cut = table(parabola, ends.left, ends.right, 101);
    BOOST_CHECK_EXCEPTION(solve_on_graded_grid(cut, modulus, load, 20, {-0.5, 0.5}), ContactError,
                          says("end of the profile"));
  }
  const Profile wide = table(parabola, -1.1, 1.1, 1001);  // cuts the start
  const GradedSolution s = solve_on_graded_grid(wide, modulus, load, 20, {-9, 9});
  BOOST_TEST(std::abs(s.half_width() - 1) < 1e-5);
}

BOOST_AUTO_TEST_CASE(two_regions_are_an_error_until_they_are_one) {
  // Two hills at ±l: pressed over both there is tension between, on one the other penetrates.
  const double l = 1000;
  const auto hill = [l](double x) { return l * std::pow(x * x / (l * l) - 1, 2) / 8; };
  const Profile hills = table(hill, -2 * l, 2 * l, 2001);
  const auto solve = [&](double load, double left, double right) {
    return solve_on_graded_grid(hills, modulus, load * l, 40, {left * l, right * l});
  };

  BOOST_CHECK_EXCEPTION(solve(0.3, -1.3, 1.3), ContactError, says("tension"));
  BOOST_CHECK_EXCEPTION(solve(0.1, 0.6, 1.4), ContactError, says("penetration"));
  BOOST_CHECK_EXCEPTION(solve(0.1, -1.4, -0.6), ContactError, says("penetration"));
  // Pressed flat, P/l = πE*(3ξ⁴/32 − ξ²/8), ξ = a/l: also from where Newton's step leads uphill.
  const double xi = 1.45;
  const double load = pi * modulus * (3 * std::pow(xi, 4) / 32 - xi * xi / 8);
  for (const double middle : {-1.1, -0.6, -0.2, 0.4}) {
    const double a = solve(load, middle - 0.1, middle + 0.1).half_width();
    BOOST_TEST(std::abs(a - xi * l) < 1e-5 * l);
  }
}

BOOST_AUTO_TEST_CASE(inputs_out_of_range_are_refused_by_their_names) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](double e_star, double load, long n, Edges start, const char* quantity) {
    BOOST_CHECK_EXCEPTION(
        solve_on_graded_grid(Profile::parabola(1), e_star, load, n, start), InvalidQuantity,
        [quantity](const InvalidQuantity& e) { return e.quantity() == quantity; });
  };

  refused(0, 1, 20, {-1, 1}, "contact_modulus");
  refused(1, 0, 20, {-1, 1}, "load");
  refused(1, 1, line_contact::min_graded_elements - 1, {-1, 1}, "elements");
  refused(1, 1, line_contact::max_graded_elements + 1, {-1, 1}, "elements");
  refused(1, 1, 20, {-infinity, 1}, "left edge");
  refused(1, 1, 20, {-1, NAN}, "right edge");
  refused(1, 1, 20, {1, 1}, "left edge");
  BOOST_CHECK_THROW(hertz(1).solve(4).approach(infinity), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
