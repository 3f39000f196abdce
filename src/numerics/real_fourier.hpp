// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "numerics/fftw_planner.hpp"

namespace numerics {

/// The discrete Fourier transform of a real signal by FFTW, in place, with an owned buffer.
///
/// forward():  spectrum_k = Σ_j signal_j exp(−2πi jk/n), k = 0 … n/2;  backward() is its inverse
/// times n. Each overwrites the other's view. The n real numbers are transformed as n/2 complex
/// ones (Press et al., Numerical Recipes, 12.3.2): FFTW plans these in half a millisecond, a real
/// transform in 5 to 20, which is more than a small contact takes. Plans are estimated, not
/// measured, so that a result is the same each time. Not for use by two threads at once, but
/// each thread may have its own.
class RealFourier {
 public:
  /// A transform of the least convenient length n ≥ min_size: even, with few and small odd primes.
  explicit RealFourier(std::size_t min_size);

  std::size_t size() const { return size_; }
  std::span<double> signal() { return {buffer_.get(), size_}; }
  std::span<std::complex<double>> spectrum();

  void forward();
  void backward();

 private:
  std::size_t size_;
  std::unique_ptr<double[], FreeFftwMemory> buffer_;
  std::vector<std::complex<double>> roots_;  // exp(−2πi k/n), k = 0 … n/4
  FftwPlan forward_;
  FftwPlan backward_;
};

}  // namespace numerics
