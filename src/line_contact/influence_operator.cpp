// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/influence_operator.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace line_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::product;

using Complex = std::complex<double>;
using Spectrum = std::span<Complex>;

std::size_t size_of(Index n) {
  return static_cast<std::size_t>(n);
}

// Fills the signal with T(k+1) − T(k), which is odd about k = −½: the lags k = 0, 1, … from the
// front, −1, −2, … from the back.
void fill_with_differences(std::span<double> signal, Element element) {
  const std::size_t half = signal.size() / 2;
  for (std::size_t k = 0; k < half; ++k) {
    const double difference = influence_difference(element, static_cast<Index>(k));
    signal[k] = difference;
    signal[signal.size() - 1 - k] = -difference;
  }
}

// Fills the signal with T(k) at the lags k = 0, ±1, ….
void fill_with_coefficients(std::span<double> signal, Element element) {
  const std::size_t half = signal.size() / 2;
  signal[0] = influence_coefficient(element, 0);
  for (std::size_t k = 1; k <= half; ++k) {
    signal[k] = influence_coefficient(element, static_cast<double>(k));
    signal[signal.size() - k] = signal[k];
  }
}

}  // namespace

InfluenceOperator::InfluenceOperator(Element element, Index n) : n_(n), fourier_(2 * size_of(n)) {
  const double scale = 1 / static_cast<double>(fourier_.size());
  const Spectrum spectrum = fourier_.spectrum();
  fill_with_differences(fourier_.signal(), element);
  fourier_.forward();
  difference_spectrum_.assign(spectrum.begin(), spectrum.end());
  for (auto& value : difference_spectrum_) value *= scale;

  fill_with_coefficients(fourier_.signal(), element);
  fourier_.forward();
  eigenvalues_.resize(spectrum.size());
  std::transform(spectrum.begin(), spectrum.end(), eigenvalues_.begin(),
                 [scale](const Complex& value) { return scale * value.real(); });
}

void InfluenceOperator::load(const VectorXd& values) {
  const std::span<double> signal = fourier_.signal();
  std::copy(values.begin(), values.end(), signal.begin());
  std::fill(signal.begin() + values.size(), signal.end(), 0);
  fourier_.forward();
}

void InfluenceOperator::store(VectorXd& result, Index n) {
  fourier_.backward();
  result = Eigen::Map<const VectorXd>(fourier_.signal().data(), n);
}

// T is a Toeplitz matrix, T_ij = T(i−j), and so a corner of a circulant matrix of twice its size,
// which the Fourier transform F diagonalises: Tφ = F⁻¹ Λ F φ with φ padded with zeros.
void InfluenceOperator::potentials(const VectorXd& phi, VectorXd& result) {
  load(phi);  // F φ
  const Spectrum spectrum = fourier_.spectrum();
  for (std::size_t k = 0; k < spectrum.size(); ++k) spectrum[k] *= eigenvalues_[k];  // Λ F φ
  store(result, n_);  // F⁻¹ Λ F φ
}

// (Tφ)_{i+1} − (Tφ)_i = Σ_j [T(i+1−j) − T(i−j)] φ_j, with the spectrum of these differences.
void InfluenceOperator::differences(const VectorXd& phi, VectorXd& result) {
  load(phi);
  const Spectrum spectrum = fourier_.spectrum();
  for (std::size_t k = 0; k < spectrum.size(); ++k)
    spectrum[k] = product(spectrum[k], difference_spectrum_[k]);
  store(result, n_ - 1);
}

// −F⁻¹ Λ⁻¹ F r: the inverse of the circulant matrix without its mean, which δ absorbs. Λ contains
// the scale 1/N of the transforms, so its inverse needs it twice.
void InfluenceOperator::precondition(const VectorXd& residual, VectorXd& result) {
  load(residual);
  const Spectrum spectrum = fourier_.spectrum();
  const auto size = static_cast<double>(fourier_.size());
  spectrum[0] = 0;
  for (std::size_t k = 1; k < spectrum.size(); ++k) spectrum[k] /= -size * size * eigenvalues_[k];
  store(result, n_);
}

namespace {

// Returns Σ_j t(i−j) φ_j, i = 0 … n_rows−1, for values φ that begin at `first`. fill() puts t(k) at
// the lags k = 0, 1, … from the front of a signal and k = −1, −2, … from its back.
template <class Fill>
VectorXd convolution(const Fill& fill, const VectorXd& phi, Index first, Index n_rows) {
  const Index reach = std::max(first + phi.size(), n_rows - first);  // the greatest |lag|
  numerics::RealFourier fourier(size_of(std::max(2 * reach, n_rows + phi.size())));
  const std::span<double> signal = fourier.signal();
  const Spectrum spectrum = fourier.spectrum();
  fill(signal);
  fourier.forward();
  const std::vector<Complex> kernel(spectrum.begin(), spectrum.end());

  std::fill(signal.begin(), signal.end(), 0);
  std::copy(phi.begin(), phi.end(), signal.begin() + first);
  fourier.forward();
  const double scale = 1 / static_cast<double>(fourier.size());
  for (std::size_t k = 0; k < spectrum.size(); ++k) {
    spectrum[k] = scale * product(spectrum[k], kernel[k]);
  }
  fourier.backward();
  return Eigen::Map<const VectorXd>(signal.data(), n_rows);
}

}  // namespace

VectorXd differences_over_grid(Element element, const VectorXd& phi, Index first, Index n_nodes) {
  const auto fill = [element](std::span<double> signal) { fill_with_differences(signal, element); };
  return convolution(fill, phi, first, n_nodes - 1);
}

}  // namespace line_contact
