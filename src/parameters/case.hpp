// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "block/mesh.hpp"
#include "block/rectangle.hpp"
#include "config/table.hpp"
#include "config/units.hpp"
#include "elasticity/loads.hpp"
#include "elasticity/material.hpp"
#include "line_contact/cylinders.hpp"

namespace parameters {

/// The half-space under a triangular load: the parameters of eqs. (2) to (4). Here and below,
/// lengths and stresses are in the case's unit system.
struct HalfSpaceCase {
  elasticity::Material material;
  elasticity::TriangularLoad load;
  double datum;                ///< the x at which u_z = 0
  std::vector<double> points;  ///< the x of the paper's tables, rising

  /// The greatest |x| of the points, where the tables of the symmetric load end.
  double farthest_point() const;
};

/// One of the two bodies in contact.
struct CylinderCase {
  elasticity::Material material;
  line_contact::Radius radius;
};

/// Two cylinders pressed together.
struct ContactCase {
  CylinderCase body1;
  CylinderCase body2;
  line_contact::CylinderPair cylinders;
  double line_load;
  double datum;  ///< the x of the points whose approach is computed
  long n_nodes;
};

/// The bodies of ContactCase, with their radii taken as those of spheres.
struct PointContactCase {
  double load;  ///< P, a force
};

/// The finite block that the paper analysed with finite elements.
struct BlockCase {
  block::Rectangle rectangle;
  block::Support sides;  ///< supports on the left and right; the bottom is clamped
  double density;        ///< mass per volume
  block::Discretization discretization;
};

/// A case file (TOML). Each member reads one table.
///
/// Every quantity carries its unit and is converted to the case's system. Each member throws
/// config::Error with file, line, column, key, value and the allowed range, also for a missing
/// table and for an unknown key in it.
class CaseFile {
 public:
  explicit CaseFile(const std::filesystem::path& file);

  const config::Table& root() const { return root_; }
  const config::UnitSystem& units() const { return units_; }

  HalfSpaceCase half_space() const;
  ContactCase contact() const;
  PointContactCase point_contact() const;
  BlockCase block() const;

 private:
  config::Table root_;
  config::UnitSystem units_;
};

/// A case: the bodies, their loads and the points of the results.
struct Case {
  std::filesystem::path file;
  std::string title;
  config::UnitSystem units;
  HalfSpaceCase half_space;
  ContactCase contact;
  std::optional<PointContactCase> point_contact;
  std::optional<BlockCase> block;
  std::optional<config::Table> printed;  ///< [printed], which the paper's code reads
};

/// Reads a whole case file, which must have a title and a block that suits its half-space. Does not
/// check the table [printed]. Throws config::Error as CaseFile.
Case read_case(const std::filesystem::path& file);

}  // namespace parameters
