// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "block/discretization.hpp"
#include "block/rectangle.hpp"
#include "block/supports.hpp"
#include "config/printed_number.hpp"
#include "config/units.hpp"
#include "contact/cylinder_pair.hpp"
#include "elasticity/material.hpp"
#include "elasticity/triangular_load.hpp"

namespace parameters {

/// The half-space under a triangular load: what eqs. (2) to (4) need. Lengths and stresses in the
/// case's unit system, here and below.
struct HalfSpaceCase {
  elasticity::Material material;
  elasticity::TriangularLoad load;
  double datum;                ///< the x at which u_z = 0
  std::vector<double> points;  ///< where the paper's tables are taken
};

/// One of the two bodies in contact.
struct CylinderCase {
  elasticity::Material material;
  contact::Radius radius;
};

/// Two cylinders pressed together.
struct ContactCase {
  CylinderCase body1;
  CylinderCase body2;
  contact::CylinderPair cylinders;
  double line_load;
  double datum;  ///< where the points lie whose approach is stated
  long n_nodes;
};

/// The finite block that the paper analysed with finite elements.
struct BlockCase {
  block::Rectangle rectangle;
  block::Support sides;  ///< how left and right are held; the bottom is clamped
  double density;        ///< mass per volume
  block::Discretization discretization;
};

/// A column or table that the paper prints, with its place in the paper.
struct PrintedFigure5 {
  std::string source;
  std::vector<config::PrintedNumber> x, fea_magnitude, fea_z, analytical, error;
};
struct PrintedTriDist {
  std::string source;
  std::vector<config::PrintedNumber> displacement;
  config::PrintedNumber step;  ///< how far the program steps off a singular point
};
struct PrintedAppendix2 {
  std::string source;
  std::map<std::string, config::PrintedNumber> measures;     ///< by their printed names
  std::map<std::string, config::PrintedNumber> convergence;  ///< of those, in percent
  std::map<std::string, config::PrintedNumber>
      mass_properties;  ///< mass, centre_y, ixx_about_origin, …
};

struct PrintedContactM {
  std::string source;
  config::PrintedNumber spacing;    ///< c
  config::PrintedNumber n_nodes;    ///< n
  config::PrintedNumber zero_node;  ///< aa: «node where p becomes zero»
};

/// What the paper prints about its own case. It is compared with, never computed from.
struct PrintedData {
  PrintedFigure5 figure5;
  PrintedTriDist tri_dist;
  PrintedAppendix2 appendix2;
  PrintedContactM contact_m;
};

/// All that a report is computed from.
struct Case {
  std::filesystem::path file;
  std::string title;
  config::UnitSystem units;
  HalfSpaceCase half_space;
  ContactCase contact;
  std::optional<BlockCase> block;
  std::optional<PrintedData> printed;  ///< only for the paper's own case
};

/// Reads a case file (TOML). Every quantity carries its unit and is converted to the case's system.
/// Throws config::Error naming file, line, column, key, value and what is allowed.
Case read_case(const std::filesystem::path& file);

}  // namespace parameters
