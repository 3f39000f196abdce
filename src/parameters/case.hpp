// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "block/discretization.hpp"
#include "block/rectangle.hpp"
#include "config/table.hpp"
#include "config/units.hpp"
#include "elasticity/material.hpp"
#include "elasticity/triangular_load.hpp"
#include "line_contact/cylinders.hpp"

namespace parameters {

/// The half-space under a triangular load: what eqs. (2) to (4) need. Lengths and stresses in the
/// case's unit system, here and below.
struct HalfSpaceCase {
  elasticity::Material material;
  elasticity::TriangularLoad load;
  double datum;                ///< the x at which u_z = 0
  std::vector<double> points;  ///< where the paper's tables are taken, rising

  /// The greatest |x| of the points: where the tables end, since the load is symmetric.
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
  double datum;  ///< where the points lie whose approach is stated
  long n_nodes;
};

/// The bodies of ContactCase once more, with the radii as those of spheres.
struct PointContactCase {
  double load;  ///< P, a force
};

/// The finite block that the paper analysed with finite elements.
struct BlockCase {
  block::Rectangle rectangle;
  block::Support sides;  ///< how left and right are held; the bottom is clamped
  double density;        ///< mass per volume
  block::Discretization discretization;
};

/// A case file (TOML), of which a reader takes the tables that it needs.
///
/// Every quantity carries its unit and is converted to the case's system. Each member throws
/// config::Error naming file, line, column, key, value and what is allowed, also for a table that
/// is missing and for a key in it that is unknown.
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

/// A case: the bodies, their loads and where they are looked at.
struct Case {
  std::filesystem::path file;
  std::string title;
  config::UnitSystem units;
  HalfSpaceCase half_space;
  ContactCase contact;
  std::optional<PointContactCase> point_contact;
  std::optional<BlockCase> block;
  std::optional<config::Table> printed;  ///< [printed], left to the reader who knows the paper
};

/// Reads a whole case file, with a title, whose block must suit its half-space. The table [printed]
/// is not looked into. Throws config::Error as CaseFile.
Case read_case(const std::filesystem::path& file);

}  // namespace parameters
