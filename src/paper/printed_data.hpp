// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "paper/prelude.hpp"

namespace paper {

/// The columns of Fig. 5, one number for each point.
struct PrintedFigure5 {
  std::vector<PrintedNumber> x, fea_magnitude, fea_z, analytical, error;
};

/// What is typed into Tri_dist.m, and its output, one number for each point.
struct PrintedTriDist {
  PrintedNumber young, poisson, peak_pressure, half_width, datum;
  PrintedNumber step;  ///< how far the program moves off a singular point
  std::vector<PrintedNumber> displacement;
};

/// The error of the stresses that the run estimates itself, root mean square.
struct PrintedStressError {
  PrintedNumber rms;
  PrintedNumber of_largest;  ///< the largest principal stress, which the run compares it with
};

/// The summary of the finite-element run.
struct PrintedAppendix2 {
  PrintedStressError stress_error;
  std::map<std::string, PrintedNumber> measures;         ///< by their printed names
  std::map<std::string, PrintedNumber> convergence;      ///< of those, in per cent
  std::map<std::string, PrintedNumber> mass_properties;  ///< mass, centre_y, ixx_about_origin, …
};

/// What is typed into Contact.m.
struct PrintedContactM {
  PrintedNumber load, young, poisson, radius1, radius2, datum;
  PrintedNumber spacing;    ///< c
  PrintedNumber n_nodes;    ///< n
  PrintedNumber zero_node;  ///< aa, the node where the pressure becomes zero
};

/// What the paper prints about its own case. It is compared with, never computed from.
struct PrintedData {
  std::string units;  ///< the unit system of the print
  PrintedFigure5 figure5;
  PrintedTriDist tri_dist;
  PrintedAppendix2 appendix2;
  PrintedContactM contact_m;
};

/// Reads what the paper prints from the case's table [printed]; nothing if the case has none.
/// Throws config::Error naming file, line, column and key for a key that is missing or unknown and
/// for columns of unequal length.
std::optional<PrintedData> read_printed(const parameters::Case& from_file);

/// Why a case is not the one that the print is about: the first of its numbers that is not the
/// paper's. Empty if all are.
std::string difference_from_paper(const parameters::Case& c, const PrintedData& printed);

/// A table cell that shows a printed number with its own digits.
inline Cell quoted(const PrintedNumber& number) {
  return Cell::quoted(number.value(), number.place());
}

/// A printed measure of the run, or its convergence as a ratio.
inline const PrintedNumber& measure(const PrintedData& printed, const std::string& name) {
  return printed.appendix2.measures.at(name);
}
inline double convergence(const PrintedData& printed, const std::string& name) {
  return printed.appendix2.convergence.at(name).value() / 100;
}

}  // namespace paper
