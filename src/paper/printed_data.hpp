// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "literate/tables/table.hpp"
#include "literate/values/value.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// The columns of Fig. 5, with their place in the paper: as many numbers in each as the case has
/// points.
struct PrintedFigure5 {
  std::string source;
  std::vector<PrintedNumber> x, fea_magnitude, fea_z, analytical, error;
};

/// The output of Tri_dist.m, a number for each point.
struct PrintedTriDist {
  std::string source;
  std::vector<PrintedNumber> displacement;
  PrintedNumber step;  ///< how far the program steps off a singular point
};

/// The error of the stresses that the run estimates itself, root mean square, in units of stress.
struct PrintedStressError {
  PrintedNumber rms;
  PrintedNumber of_largest;  ///< the largest principal stress, which the run compares it with
};

/// The summary of the finite-element run.
struct PrintedAppendix2 {
  std::string source;
  PrintedStressError stress_error;
  std::map<std::string, PrintedNumber> measures;         ///< by their printed names
  std::map<std::string, PrintedNumber> convergence;      ///< of those, in percent
  std::map<std::string, PrintedNumber> mass_properties;  ///< mass, centre_y, ixx_about_origin, …
};

/// The numbers that are typed into Contact.m.
struct PrintedContactM {
  std::string source;
  PrintedNumber spacing;    ///< c
  PrintedNumber n_nodes;    ///< n
  PrintedNumber zero_node;  ///< aa: «node where p becomes zero»
};

/// What the paper prints about its own case. It is compared with, never computed from.
struct PrintedData {
  PrintedFigure5 figure5;
  PrintedTriDist tri_dist;
  PrintedAppendix2 appendix2;
  PrintedContactM contact_m;
};

/// Reads what the paper prints from the case's table [printed]; nothing if the case has none.
/// Throws config::Error naming file, line, column, key and what is allowed: for a key that is
/// missing or unknown, a column that has not one number for each point, and for units other than
/// the case's.
std::optional<PrintedData> read_printed(const parameters::Case& from_file);

/// A table cell that shows a printed number with its own digits, no more and no fewer.
inline Cell quoted(const PrintedNumber& number) {
  return literate::Cell::quoted(number.value(), number.place());
}

}  // namespace paper
