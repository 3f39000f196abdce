// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies pressed together along a line, for `halfspace contact` and `halfspace stress`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bodies.hpp"
#include "app/flags.hpp"
#include "app/output.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"

namespace app {

/// A contact described by the command line and the case, with its solution.
struct SolvedContact {
  Material material;  ///< of body 1
  line_contact::Solution solution;
  std::string method;
  std::optional<double> datum;
  std::optional<line_contact::Hertz> hertz;  ///< of cylinders
  double seconds;
  std::vector<std::string> notes, warnings;

  /// From the second moment of the pressure for cylinders; otherwise half the distance between the
  /// outer edges.
  double half_width() const;
};

/// The flags that describe a contact.
struct ContactFlags {
  CLI::App& command;
  Flag load{command, "--load", "FORCE/LENGTH", "Load", "Load P, force per length of the contact"};
  Flag datum{command, "--datum", "LENGTH", "Load",
             "Compute the approach of the surface points at this x"};
  Flag radius1{command, "--radius1", "LENGTH", "Bodies",
               "Radius of body 1, a cylinder; 'plane' for a plane, negative for a hollow"};
  Flag radius2{command, "--radius2", "LENGTH", "Bodies", "Radius of body 2 [plane]"};
  PairOfMaterialFlags materials{command};
  Flag profile{command, "--profile", "cylinder|file:PATH", "Bodies",
               "Gap between the unloaded bodies: that of cylinders, or measured: a "
               "CSV file with the columns x,gap [cylinder]"};
  Flag nodes{command, "--nodes", "COUNT", "Solution", "Number of nodes [401, or the case's]"};
  Flag domain{command, "--domain", "LENGTH", "Solution",
              "Width that the nodes fill [a tenth wider than the contact, or the file's]"};
  Choice element{command,
                 "--element",
                 {"triangular", "uniform", "point"},
                 "Solution",
                 "Pressure around a node: a triangle, a strip or a force [triangular]"};
  Choice method{command,
                "--method",
                {"matrix-inversion", "variational", "fft"},
                "Solution",
                "Solution method [matrix-inversion up to 1000 nodes, then fft]"};
  Flag tolerance{command, "--tolerance", "NUMBER", "Solution",
                 "fft: error of the pressure, relative to the peak [1e-10]"};

  /// Solves the contact; flags override the case. Throws sys::InputError for a flag that is
  /// missing, wrong, or meaningless for the profile, and as the methods.
  SolvedContact solve(const Given& given) const;
};

}  // namespace app
