// SPDX-License-Identifier: GPL-3.0-or-later
// build/figures FOLDER [ID] writes the curves of your report to FOLDER/*.dat and its numbers to
// FOLDER/numbers.tex.
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>

#include "assignment/given/bodies.hpp"

namespace {

using assignment::OwnNumbers;
using exercise::Material;

// Returns the number, or 0 if the exercise is not solved yet, so that the report can always be
// typeset.
double number_of(double number) {
  return std::isfinite(number) ? number : 0;
}

std::ofstream open(const std::filesystem::path& file) {
  std::ofstream out(file);
  if (!out) throw std::runtime_error("cannot write " + file.string());
  return out << std::setprecision(17), std::move(out);
}

// Columns: x/a, the slope by eq. (3), the slope by eq. (2) and its error, u_z.
void write_surface(const std::filesystem::path& file, const OwnNumbers& own) {
  std::ofstream out = open(file);
  const Material material{own.young1, own.poisson1};
  const exercise::TriangularLoad triangle{own.peak_pressure, own.half_width};
  // The triangle as a load that is given by its values.
  const exercise::Load load =
      assignment::load_of(assignment::shape::triangle, own.peak_pressure, own.half_width);
  for (int i = -160; i <= 160; ++i) {
    const double xi = i / 40.0;
    const double x = xi * own.half_width;
    const auto quadrature = exercise::normal_gradient_by_quadrature(material, load, x);
    out << xi << ' ' << number_of(exercise::normal_gradient(material, triangle, x)) << ' '
        << number_of(quadrature.value) << ' ' << number_of(quadrature.abs_error) << ' '
        << number_of(exercise::normal_displacement(material, load, own.datum, x)) << '\n';
  }
}

exercise::Contact contact_on(const exercise::Grid& grid, const OwnNumbers& own) {
  const exercise::Cylinders cylinders{
      {own.young1, own.poisson1}, own.radius1, {own.young2, own.poisson2}, own.radius2};
  return exercise::solve_contact(cylinders, grid, own.datum, own.line_load);
}

void write_pressure(const std::filesystem::path& file, const exercise::Grid& grid,
                    exercise::Contact contact) {
  contact.pressure.resize(static_cast<std::size_t>(grid.n_nodes), std::nan(""));
  std::ofstream out = open(file);
  for (int i = 0; i < grid.n_nodes; ++i) {
    const double pressure = contact.pressure[static_cast<std::size_t>(i)];
    out << grid.x(i) << ' ' << number_of(pressure) << '\n';
  }
}

// Defines a TeX command \name that prints a length in millimetres, with the digits that a grid with
// half the spacing confirms. `coarse` is the length on your grid, `fine` the length on that grid.
// The method is at least of first order, so twice the difference bounds the error of `coarse`. A
// unit of the last printed digit is at least as large as this bound.
void define_length(std::ostream& out, const std::string& name, double coarse, double fine) {
  const double length = 1e3 * number_of(coarse);
  const double error = 2 * std::abs(length - 1e3 * number_of(fine));
  if (error > std::abs(length)) {
    std::cerr << "figures: a grid with half the spacing confirms no digit of \\" << name << '\n';
  }
  const double most_decimals = length == 0 ? 0 : 9;
  const double decimals =
      error > 0 ? std::clamp(std::floor(-std::log10(error)), 0., most_decimals) : most_decimals;
  out << "\\newcommand*\\" << name << "{" << std::fixed
      << std::setprecision(static_cast<int>(decimals)) << length << "\\,mm}\n";
}

void write_all(const std::filesystem::path& folder, const std::string& student) {
  std::filesystem::create_directories(folder);
  const OwnNumbers own = assignment::own_numbers(student);
  write_surface(folder / "surface.dat", own);
  const exercise::Grid grid{static_cast<int>(std::lround(own.nodes)), own.spacing};
  const exercise::Grid finer{2 * grid.n_nodes - 1, grid.spacing / 2};
  const exercise::Contact contact = contact_on(grid, own);
  const exercise::Contact confirming = contact_on(finer, own);
  write_pressure(folder / "contact.dat", grid, contact);
  std::ofstream numbers = open(folder / "numbers.tex");
  numbers << "\\newcommand*\\student{"
          << (student.empty() ? "the paper's case" : "\\detokenize{" + student + "}") << "}\n";
  define_length(numbers, "halfwidth", contact.half_width, confirming.half_width);
  define_length(numbers, "approach", contact.approach, confirming.approach);
}

}  // namespace

int main(int argc, char** argv) {
  gsl_set_error_handler_off();  // as in build/assignment
  try {
    if (argc < 2) throw std::invalid_argument("usage: figures FOLDER [ID]");
    write_all(argv[1], argc > 2 ? argv[2] : "");
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "figures: " << e.what() << '\n';
    return 2;
  }
}
