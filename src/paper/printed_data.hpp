// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "paper/conventions.hpp"

namespace paper {

/// The columns of Fig. 5, one number per point.
struct PrintedFigure5 {
  std::vector<PrintedNumber> x, fea_magnitude, fea_z, analytical, error;
};

/// The input of Tri_dist.m and its output, one number per point.
struct PrintedTriDist {
  PrintedNumber young, poisson, peak_pressure, half_width, datum;
  PrintedNumber step;  ///< offset by which the program avoids a singular point
  std::vector<PrintedNumber> displacement;
};

/// The run's own estimate of its stress error, root mean square.
struct PrintedStressError {
  PrintedNumber rms;
  PrintedNumber of_largest;  ///< the largest principal stress, to which the run relates it
};

/// The summary of the finite-element run.
struct PrintedAppendix2 {
  PrintedStressError stress_error;
  std::map<std::string, PrintedNumber> measures;         ///< by their printed names
  std::map<std::string, PrintedNumber> convergence;      ///< of the measures, in per cent
  std::map<std::string, PrintedNumber> mass_properties;  ///< mass, centre_y, ixx_about_origin, …
};

/// The input of Contact.m.
struct PrintedContactM {
  PrintedNumber load, young, poisson, radius1, radius2, datum;
  PrintedNumber spacing;    ///< c
  PrintedNumber n_nodes;    ///< n
  PrintedNumber zero_node;  ///< aa, the node where the pressure becomes zero
};

/// The numbers that the paper prints about its own case: for comparison only, never an input.
struct PrintedData {
  std::string units;  ///< the unit system of the print
  PrintedFigure5 figure5;
  PrintedTriDist tri_dist;
  PrintedAppendix2 appendix2;
  PrintedContactM contact_m;
};

/// Reads the paper's numbers from the case's table [printed]; nothing if the case has none. Throws
/// config::Error with file, line, column and key for a missing or unknown key and for columns of
/// unequal length.
std::optional<PrintedData> read_printed(const parameters::Case& from_file);

/// The first difference of a case from the paper's own, as a message; empty if there is none.
std::string difference_from_paper(const parameters::Case& c, const PrintedData& printed);

/// A table cell that shows a number with the digits printed in the paper.
inline Cell quoted(const PrintedNumber& number) {
  return Cell::quoted(number.value(), number.place());
}

/// A printed measure of the run, and its convergence as a ratio.
inline const PrintedNumber& measure(const PrintedData& printed, const std::string& name) {
  return printed.appendix2.measures.at(name);
}
inline double convergence(const PrintedData& printed, const std::string& name) {
  return printed.appendix2.convergence.at(name).value() / 100;
}

}  // namespace paper
