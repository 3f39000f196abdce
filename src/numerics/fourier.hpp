// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fftw3.h>
#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace numerics {

/// ab without the checks for infinities that make operator* slow.
inline std::complex<double> product(const std::complex<double>& a, const std::complex<double>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// The lock for making and destroying plans: FFTW's planner is not thread-safe.
std::mutex& fftw_planner();

struct FreeFftwPlan {
  void operator()(fftw_plan_s* plan) const;
};
using FftwPlan = std::unique_ptr<fftw_plan_s, FreeFftwPlan>;

struct FreeFftwMemory {
  void operator()(void* memory) const { fftw_free(memory); }
};

/// The least size ≥ min_size of the form 2^k m, k ≥ 2, with a small odd m that FFTW has code for.
std::size_t convenient_fourier_size(std::size_t min_size);

/// The discrete Fourier transform of a real signal by FFTW, in place, in a buffer that it owns.
///
/// forward():  spectrum_k = Σ_j signal_j exp(−2πi jk/n), k = 0 … n/2;  backward() is its inverse
/// times n. Signal and spectrum share the buffer. The n real numbers are transformed as n/2 complex
/// ones (Press et al., Numerical Recipes, 12.3.2): FFTW plans a complex transform in half a
/// millisecond but a real one in 5 to 20, longer than a small contact takes to solve. Plans are
/// estimated, not measured, so that results are reproducible.
class RealFourier {
 public:
  /// A transform of length convenient_fourier_size(min_size).
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

/// An array of complex numbers, aligned for FFTW.
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
/// are estimated, not measured, so that results are reproducible.
class ComplexFourier {
 public:
  explicit ComplexFourier(std::size_t size);

  /// The buffer holds `size` numbers.
  void forward(const ComplexBuffer& buffer) const;
  void backward(const ComplexBuffer& buffer) const;

 private:
  std::size_t size_;
  FftwPlan forward_;
  FftwPlan backward_;
};

}  // namespace numerics
