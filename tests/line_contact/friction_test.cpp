// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/friction.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(friction_test)

using Eigen::Index;
using Eigen::VectorXd;
using elasticity::distributed_load;
using elasticity::Material;
using elasticity::SurfaceQuadrature;
using line_contact::Element;
using line_contact::Friction;
using line_contact::grid_of_width;
using line_contact::Hertz;
using line_contact::Method;
using line_contact::partial_slip;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Radius;
using line_contact::sliding;
using line_contact::Slopes;
using line_contact::Solution;
using line_contact::solve_by_fft;
using line_contact::surface_slopes;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double load = 3.461;
constexpr double friction = 0.37;
constexpr double curvature = 0.571;

const Material steel(1663, 0.3);
const Material rubber(71.3, 0.41);
const line_contact::CylinderPair alike(steel, Radius::of_cylinder("radius1", 1 / curvature), steel,
                                       Radius::of_plane());
const Hertz hertz(alike, load);

const Method by_fft = [](const Problem& problem, double line_load) {
  return solve_by_fft(problem, line_load, 1e-11);
};

Problem cylinders_on(Index n_nodes, Element element = Element::triangular) {
  return {alike.profile(), alike.contact_modulus(),
          grid_of_width(2.385 * hertz.half_width(), n_nodes), element};
}

// Cattaneo and Mindlin: q = μp₀[√(1 − ξ²) − (c/a)√(1 − (x/c)²)], ξ = x/a, c = a√(1 − Q/(μP)), the
// second root only where |x| < c (Johnson 7.24–7.28).
double cattaneo_mindlin(double x, double tangential_load) {
  const double a = hertz.half_width();
  const double c = a * std::sqrt(1 - std::abs(tangential_load) / (friction * load));
  const auto root = [x](double b) { return std::sqrt(std::max(0., 1 - x * x / (b * b))); };
  return std::copysign(friction * hertz.peak_pressure() * (root(a) - c / a * root(c)),
                       tangential_load);
}

// The slope of ln(error) over ln(spacing), fitted: single errors scatter with where the edge falls
// between nodes.
class Fit {
 public:
  void add(double spacing, double error) {
    const double x = std::log(spacing);
    const double y = std::log(error);
    n_ += 1, x_ += x, y_ += y, xx_ += x * x, xy_ += x * y;
  }
  double order() const { return (n_ * xy_ - x_ * y_) / (n_ * xx_ - x_ * x_); }

 private:
  double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

// Root of the mean square of a difference over low < |x|/a < high.
template <class Exact>
double mean_error(const Solution& s, const VectorXd& values, const Exact& exact, double low,
                  double high) {
  double squares = 0;
  double n = 0;
  for (Index i = 0; i < s.grid.n_nodes; ++i) {
    const double x = s.grid.x(i);
    const double share = std::abs(x) / hertz.half_width();
    if (share <= low || share >= high) continue;
    squares += std::pow(values[i] - exact(x), 2);
    n += 1;
  }
  return std::sqrt(squares / n);
}

constexpr Index node_counts[] = {301, 357, 424, 503, 601, 713, 847, 1009, 1201, 1427, 1693, 2011};

auto names(const char* quantity) {
  return [=](const InvalidQuantity& e) { return e.quantity() == quantity; };
}

}  // namespace

BOOST_AUTO_TEST_CASE(sliding_shear_is_friction_times_pressure) {
  const Solution s = solve_by_fft(cylinders_on(101), load);
  const Friction shear = sliding(s, friction);

  BOOST_TEST((shear.shear - friction * s.pressure).cwiseAbs().maxCoeff() == 0);
  BOOST_TEST(relative_difference(shear.tangential_load, friction * load) < 1e-13);
  BOOST_TEST(shear.stick_load == 0);
}

BOOST_AUTO_TEST_CASE(partial_slip_is_cattaneos_and_mindlins_with_order_two_or_more_inside) {
  // Away from both edges, c/a = 0.632 and 1, where the order is 1/2.
  const double tangential_load = 0.6 * friction * load;
  const auto exact = [=](double x) { return cattaneo_mindlin(x, tangential_load); };
  Fit stick, slip, everywhere;
  for (const Index n_nodes : node_counts) {
    const Problem problem = cylinders_on(n_nodes);
    const Solution s = by_fft(problem, load);
    const Friction shear = partial_slip(problem, s, friction, tangential_load, by_fft);
    stick.add(s.grid.spacing, mean_error(s, shear.shear, exact, -1, 0.5));
    slip.add(s.grid.spacing, mean_error(s, shear.shear, exact, 0.7, 0.9));
    everywhere.add(s.grid.spacing, mean_error(s, shear.shear, exact, -1, 1.1));
  }

  BOOST_TEST(stick.order() > 2);  // the errors of the two pressures nearly cancel
  BOOST_TEST(std::abs(slip.order() - 2) < 0.4);
  BOOST_TEST(everywhere.order() > 0.6);
}

BOOST_AUTO_TEST_CASE(partial_slip_agrees_with_cattaneo_and_mindlin_for_every_element) {
  for (const Element element : {Element::point, Element::uniform, Element::triangular}) {
    const Problem problem = cylinders_on(2001, element);
    const Solution s = by_fft(problem, load);
    for (const double share : {-0.9, 0.2385, 0.6}) {
      const double tangential_load = share * friction * load;
      const Friction shear = partial_slip(problem, s, friction, tangential_load, by_fft);
      const double c = std::sqrt(1 - std::abs(share));
      const double error = mean_error(
          s, shear.shear, [=](double x) { return cattaneo_mindlin(x, tangential_load); }, -1,
          0.9 * c);
      BOOST_TEST(error < 2e-5 * friction * hertz.peak_pressure());
    }
  }
}

BOOST_AUTO_TEST_CASE(shear_adds_up_to_the_tangential_load_with_its_sign) {
  for (const Index n_nodes : {100, 333}) {
    const Problem problem = cylinders_on(n_nodes);
    const Solution s = by_fft(problem, load);
    for (const double share : {-0.99, -0.3, 0.02385, 0.7, 0.9999}) {
      const double tangential_load = share * friction * load;
      const Friction shear = partial_slip(problem, s, friction, tangential_load, by_fft);

      BOOST_TEST(shear.tangential_load == tangential_load);
      BOOST_TEST(std::abs(s.grid.spacing * shear.shear.sum() - tangential_load) <
                 1e-12 * friction * load);
      BOOST_TEST(relative_difference(shear.stick_load, (1 - std::abs(share)) * load) < 1e-9);
      BOOST_TEST((shear.shear.cwiseAbs() - friction * s.pressure).maxCoeff() <
                 1e-9 * s.peak_pressure());
      BOOST_TEST((shear.shear * share).minCoeff() > -1e-9 * s.peak_pressure());
    }
  }
}

BOOST_AUTO_TEST_CASE(one_side_has_the_same_shear) {
  const Problem both = cylinders_on(201);
  Problem half = both;
  half.grid = line_contact::one_sided_grid(2.385 * hertz.half_width(), 101);
  const Friction of_both = partial_slip(both, by_fft(both, load), friction, 0.5, by_fft);
  const Friction of_half = partial_slip(half, by_fft(half, load), friction, 0.5, by_fft);

  BOOST_TEST((of_both.shear.tail(101) - of_half.shear).cwiseAbs().maxCoeff() <
             1e-10 * hertz.peak_pressure());
}

BOOST_AUTO_TEST_CASE(without_tangential_load_there_is_no_shear) {
  const Problem problem = cylinders_on(101);
  const Solution s = by_fft(problem, load);
  const Friction shear = partial_slip(problem, s, friction, 0, by_fft);

  BOOST_TEST(shear.shear.cwiseAbs().maxCoeff() < 1e-10 * s.peak_pressure());
  BOOST_TEST(relative_difference(shear.stick_load, load) < 1e-13);
}

BOOST_AUTO_TEST_CASE(any_method_may_find_the_part_that_sticks) {
  const Problem problem = cylinders_on(101);
  const Solution s = by_fft(problem, load);
  const VectorXd shear = partial_slip(problem, s, friction, 0.5, by_fft).shear;
  const VectorXd other =
      partial_slip(problem, s, friction, 0.5, line_contact::solve_by_matrix_inversion).shear;

  BOOST_TEST((shear - other).cwiseAbs().maxCoeff() < 1e-9 * s.peak_pressure());
}

BOOST_AUTO_TEST_CASE(a_load_that_slides_and_a_friction_that_is_none_are_refused) {
  const Problem problem = cylinders_on(51);
  const Solution s = by_fft(problem, load);
  const double limit = friction * s.line_load();

  for (const double bad : {limit, -limit, 2 * limit, double(NAN)}) {
    BOOST_CHECK_EXCEPTION(partial_slip(problem, s, friction, bad, by_fft), InvalidQuantity,
                          names("tangential_load"));
  }
  BOOST_CHECK_EXCEPTION(partial_slip(problem, s, 0, 0, by_fft), InvalidQuantity,
                        names("tangential_load"));
  for (const double bad : {-0.1, double(NAN), std::numeric_limits<double>::infinity()}) {
    BOOST_CHECK_EXCEPTION(sliding(s, bad), InvalidQuantity, names("friction"));
    BOOST_CHECK_EXCEPTION(partial_slip(problem, s, bad, 0.1, by_fft), InvalidQuantity,
                          names("friction"));
  }
  BOOST_TEST(sliding(s, 0).tangential_load == 0);
}

BOOST_AUTO_TEST_CASE(
    in_contact_the_pressure_takes_the_slope_of_the_gap_away_with_order_two_or_more) {
  const auto exact = [](double x) { return -curvature * x; };
  Fit fit;
  for (const Index n_nodes : node_counts) {
    const Problem problem = cylinders_on(n_nodes);
    const Solution s = by_fft(problem, load);
    const Slopes slopes = surface_slopes(problem, s, s.pressure, 0);
    fit.add(s.grid.spacing, mean_error(s, slopes.of_pressure, exact, -1, 0.8));
  }

  BOOST_TEST(fit.order() > 2);
}

BOOST_AUTO_TEST_CASE(points_and_uniform_elements_do_so_with_order_one) {
  // A force or a uniform pressure gives its own node no slope, where p′ would give some.
  const auto exact = [](double x) { return -curvature * x; };
  for (const Element element : {Element::point, Element::uniform}) {
    Fit fit;
    for (const Index n_nodes : node_counts) {
      const Problem problem = cylinders_on(n_nodes, element);
      const Solution s = by_fft(problem, load);
      const Slopes slopes = surface_slopes(problem, s, s.pressure, 0);
      fit.add(s.grid.spacing, mean_error(s, slopes.of_pressure, exact, -1, 0.8));
    }
    BOOST_TEST(std::abs(fit.order() - 1) < 0.05);
  }
}

BOOST_AUTO_TEST_CASE(outside_the_slope_is_hertzs_with_order_two) {
  // ∂(u_z1 + u_z2)/∂x = gap′ − h′ = κ[√(x² − a²) − |x|] to the right.
  const auto exact = [](double x) {
    const double a = hertz.half_width();
    return curvature * (std::copysign(std::sqrt(x * x - a * a), x) - x);
  };
  Fit fit;
  for (const Index n_nodes : node_counts) {
    const Problem problem = cylinders_on(n_nodes);
    const Solution s = by_fft(problem, load);
    const Slopes slopes = surface_slopes(problem, s, s.pressure, 0);
    fit.add(s.grid.spacing, mean_error(s, slopes.of_pressure, exact, 1.05, 2));
  }

  BOOST_TEST(std::abs(fit.order() - 2) < 0.2);
}

BOOST_AUTO_TEST_CASE(shear_leaves_alike_bodies_without_a_slope_and_others_with_2_beta_q) {
  const Problem problem = cylinders_on(51);
  const Solution s = by_fft(problem, load);
  const VectorXd shear = sliding(s, friction).shear;
  const Slopes of_alike = surface_slopes(problem, s, shear, dundurs_beta(steel, steel));
  const Slopes of_unlike = surface_slopes(problem, s, shear, -0.2385);

  BOOST_TEST(of_alike.of_shear.cwiseAbs().maxCoeff() == 0);
  BOOST_TEST(
      (of_unlike.of_shear + 2 * 0.2385 / alike.contact_modulus() * shear).cwiseAbs().maxCoeff() <
      1e-16);
  BOOST_TEST((of_unlike.of_pressure == of_alike.of_pressure));
}

BOOST_AUTO_TEST_CASE(two_half_spaces_by_equation_2_make_the_slopes_of_pressure_and_shear) {
  // Body 2 bears the same pressure and the opposite shear. Mirrored in the surface (x as it is, z
  // into the body) that is a load (p, −q); turned round instead (x and z reversed), a load
  // (p(−x), q(−x)), whose gradient along −x changes sign. Both must give (2β/E*) q beside p's part.
  const auto p = [](double s) { return (1 - s * s) * (1 - s * s) * (1 + 0.3 * s); };
  const auto q = [](double s) { return (1 - s * s) * (1 - s * s) * (0.4 - 0.7 * s); };
  const auto reversed = [](const auto& f) { return [f](double s) { return f(-s); }; };
  const auto opposite = [](const auto& f) { return [f](double s) { return -f(s); }; };
  const std::vector<double> ends{-1, 1};
  const double datum = 10;
  const SurfaceQuadrature body1(steel, distributed_load(p, q, ends), datum);
  const SurfaceQuadrature mirrored2(rubber, distributed_load(p, opposite(q), ends), datum);
  const SurfaceQuadrature turned2(rubber, distributed_load(reversed(p), reversed(q), ends), datum);
  const SurfaceQuadrature pressure1(steel, distributed_load(p, nullptr, ends), datum);
  const SurfaceQuadrature pressure2(rubber, distributed_load(p, nullptr, ends), datum);

  const double modulus = contact_modulus(steel, rubber);
  const double beta = dundurs_beta(steel, rubber);
  for (const double x : {-0.9, -0.2385, 0.0, 0.31, 0.77}) {
    const double of_pressure =
        pressure1.normal_gradient(x).value + pressure2.normal_gradient(x).value;
    const double of_shear = 2 * beta / modulus * q(x);
    const double mirrored = body1.normal_gradient(x).value + mirrored2.normal_gradient(x).value;
    const double turned = body1.normal_gradient(x).value - turned2.normal_gradient(-x).value;
    BOOST_TEST(std::abs(mirrored - of_pressure - of_shear) < 1e-13);
    BOOST_TEST(std::abs(turned - of_pressure - of_shear) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(nodal_pressures_and_shears_have_the_slopes_of_two_half_spaces) {
  // The piecewise linear tractions themselves, by eq. (2) for unlike bodies, at nodes.
  const line_contact::CylinderPair unlike(steel, Radius::of_cylinder("radius1", 1 / curvature),
                                          rubber, Radius::of_plane());
  const double a = Hertz(unlike, load).half_width();
  const Problem problem{unlike.profile(), unlike.contact_modulus(), grid_of_width(2.385 * a, 25),
                        Element::triangular};
  const Solution s = by_fft(problem, load);
  const VectorXd shear = partial_slip(problem, s, friction, -0.5, by_fft).shear;
  const double beta = dundurs_beta(steel, rubber);
  const Slopes slopes = surface_slopes(problem, s, shear, beta);

  const auto piecewise = [&](const VectorXd& values) {
    std::vector<numerics::Piece> pieces;
    for (Index i = 0; i + 1 < s.grid.n_nodes; ++i) {
      const double begin = s.grid.x(i);
      const double left = values[i];
      const double rise = (values[i + 1] - left) / s.grid.spacing;
      pieces.push_back(
          {begin, s.grid.x(i + 1), [=](double x) { return left + rise * (x - begin); }});
    }
    return numerics::PiecewiseFunction(pieces);
  };
  const elasticity::Load on_body1{piecewise(s.pressure), piecewise(shear), {}};
  const elasticity::Load on_body2{piecewise(s.pressure), piecewise(-shear), {}};
  const SurfaceQuadrature body1(steel, on_body1, 100);
  const SurfaceQuadrature body2(rubber, on_body2, 100);
  for (const Index i : {1, 5, 12, 16, 23}) {
    const double x = s.grid.x(i);
    const double slope = body1.normal_gradient(x).value + body2.normal_gradient(x).value;
    BOOST_TEST(std::abs(slope - slopes.of_pressure[i] - slopes.of_shear[i]) <
               1e-10 * curvature * a);
  }
}

BOOST_AUTO_TEST_CASE(slopes_of_one_side_are_refused) {
  Problem half = cylinders_on(51);
  half.grid = line_contact::one_sided_grid(2.385 * hertz.half_width(), 51);
  const Solution s = by_fft(half, load);

  BOOST_CHECK_EXCEPTION(surface_slopes(half, s, s.pressure, 0), InvalidQuantity,
                        names("one-sided grid's end"));
}

BOOST_AUTO_TEST_SUITE_END()
