// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fourier.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <new>
#include <numbers>

namespace numerics {
namespace {

using Complex = std::complex<double>;

fftw_complex* as_fftw(const ComplexBuffer& buffer) {
  return reinterpret_cast<fftw_complex*>(buffer.data());
}

}  // namespace

ComplexBuffer::ComplexBuffer(std::size_t size)
    : size_(size), numbers_(reinterpret_cast<std::complex<double>*>(fftw_alloc_complex(size))) {
  if (!numbers_) throw std::bad_alloc();
}

ComplexFourier::ComplexFourier(std::size_t size) : size_(size) {
  const ComplexBuffer buffer(size);
  const int n = static_cast<int>(size);
  const std::scoped_lock lock(fftw_planner());
  forward_.reset(
      fftw_plan_dft_1d(n, as_fftw(buffer), as_fftw(buffer), FFTW_FORWARD, FFTW_ESTIMATE));
  backward_.reset(
      fftw_plan_dft_1d(n, as_fftw(buffer), as_fftw(buffer), FFTW_BACKWARD, FFTW_ESTIMATE));
}

void ComplexFourier::forward(const ComplexBuffer& buffer) const {
  assert(buffer.size() == size_);
  fftw_execute_dft(forward_.get(), as_fftw(buffer), as_fftw(buffer));
}

void ComplexFourier::backward(const ComplexBuffer& buffer) const {
  assert(buffer.size() == size_);
  fftw_execute_dft(backward_.get(), as_fftw(buffer), as_fftw(buffer));
}

namespace {

Complex times_minus_i(const Complex& z) {
  return {z.imag(), -z.real()};
}

}  // namespace

RealFourier::RealFourier(std::size_t min_size)
    : size_(convenient_fourier_size(min_size)),
      buffer_(fftw_alloc_real(size_ + 2)),
      roots_(size_ / 4 + 1) {
  if (!buffer_) throw std::bad_alloc();
  for (std::size_t k = 0; k < roots_.size(); ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(size_);
    roots_[k] = std::polar(1.0, -2 * std::numbers::pi * turn);
  }
  auto* z = reinterpret_cast<fftw_complex*>(buffer_.get());
  const int n = static_cast<int>(size_ / 2);
  const std::scoped_lock lock(fftw_planner());
  forward_.reset(fftw_plan_dft_1d(n, z, z, FFTW_FORWARD, FFTW_ESTIMATE));
  backward_.reset(fftw_plan_dft_1d(n, z, z, FFTW_BACKWARD, FFTW_ESTIMATE));
}

std::mutex& fftw_planner() {
  static std::mutex planner;
  return planner;
}

void FreeFftwPlan::operator()(fftw_plan_s* plan) const {
  const std::scoped_lock lock(fftw_planner());
  fftw_destroy_plan(plan);
}

std::span<std::complex<double>> RealFourier::spectrum() {
  return {reinterpret_cast<Complex*>(buffer_.get()), size_ / 2 + 1};
}

// With m = n/2, z_j = signal_2j + i signal_{2j+1} and its transform Z, the even samples have the
// spectrum E_k = (Z_k + Z*_{m−k})/2, the odd ones O_k = (Z_k − Z*_{m−k})/(2i), and
//   spectrum_k = E_k + w^k O_k,  spectrum_{m−k} = (E_k − w^k O_k)*,  w = exp(−2πi/n).
void RealFourier::forward() {
  fftw_execute(forward_.get());
  const std::span<Complex> x = spectrum();
  const std::size_t m = size_ / 2;
  x[m] = x[0].real() - x[0].imag();
  x[0] = x[0].real() + x[0].imag();
  for (std::size_t k = 1; k <= m / 2; ++k) {
    const Complex even = 0.5 * (x[k] + std::conj(x[m - k]));
    const Complex odd = times_minus_i(0.5 * (x[k] - std::conj(x[m - k])));
    const Complex turned = product(roots_[k], odd);
    x[k] = even + turned;
    x[m - k] = std::conj(even - turned);
  }
}

// The inverse of the above, times two: Z_k = 2(E_k + i O_k).
void RealFourier::backward() {
  const std::span<Complex> x = spectrum();
  const std::size_t m = size_ / 2;
  const double first = x[0].real();
  const double last = x[m].real();
  x[0] = {first + last, first - last};
  for (std::size_t k = 1; k <= m / 2; ++k) {
    const Complex even = x[k] + std::conj(x[m - k]);
    const Complex odd = product(std::conj(roots_[k]), x[k] - std::conj(x[m - k]));
    const Complex turned = times_minus_i(odd);
    x[k] = even - turned;
    x[m - k] = std::conj(even + turned);
  }
  fftw_execute(backward_.get());
}

std::size_t convenient_fourier_size(std::size_t min_size) {
  std::size_t best = std::bit_ceil(std::max<std::size_t>(min_size, 4));
  for (const std::size_t odd : {3U, 5U, 7U, 9U, 15U}) {
    std::size_t size = 4 * odd;
    while (size < min_size) size *= 2;
    best = std::min(best, size);
  }
  return best;
}

}  // namespace numerics
