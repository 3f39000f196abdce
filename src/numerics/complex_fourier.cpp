// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fourier.hpp"

#include <cassert>
#include <new>

namespace numerics {
namespace {

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

}  // namespace numerics
