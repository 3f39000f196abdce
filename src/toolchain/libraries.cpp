// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/libraries.hpp"

#include <fftw3.h>
#include <fmt/core.h>
#include <gsl/gsl_version.h>

#include <Eigen/Core>

namespace toolchain {

std::map<std::string, std::string> libraries() {
  return {{"Eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"FFTW", fftw_version},
          {"GSL", GSL_VERSION}};
}

}  // namespace toolchain
