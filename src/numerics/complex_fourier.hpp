// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

#include "numerics/fftw_planner.hpp"

namespace numerics {

/// Complex numbers that lie in memory as FFTW wants them.
class ComplexBuffer {
 public:
  /// Throws std::bad_alloc.
  explicit ComplexBuffer(std::size_t size);

  std::size_t size() const { return size_; }
  std::complex<double>* data() const { return numbers_.get(); }
  std::complex<double>& operator[](std::size_t i) const { return numbers_[i]; }
  std::span<std::complex<double>> numbers() const { return {numbers_.get(), size_}; }

 private:
  std::size_t size_;
  std::unique_ptr<std::complex<double>[], FreeFftwMemory> numbers_;
};

/// The discrete Fourier transform of complex numbers by FFTW, in place.
///
/// forward():  Z_k = Σ_j z_j exp(−2πi jk/n), k = 0 … n−1;  backward() is its inverse times n. Plans
/// are estimated, not measured, so that a result is the same each time. Several threads may use one
/// object at once, each with its own buffer.
class ComplexFourier {
 public:
  explicit ComplexFourier(std::size_t size);

  std::size_t size() const { return size_; }

  /// The buffer holds size() numbers.
  void forward(const ComplexBuffer& buffer) const;
  void backward(const ComplexBuffer& buffer) const;

 private:
  std::size_t size_;
  FftwPlan forward_;
  FftwPlan backward_;
};

}  // namespace numerics
