// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fourier.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "random_inputs.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(real_fourier_test)

using numerics::RealFourier;
using Complex = std::complex<double>;

namespace {

// 4 is the least; the others are 4, 8, 16 or 32 times 1, 3, 5, 7, 9 and 15.
constexpr std::size_t sizes[] = {4, 8, 12, 20, 24, 28, 36, 40, 56, 60, 64, 72, 112, 120, 480};

std::vector<double> random_signal(std::size_t n) {
  RandomInputs random(n);
  std::vector<double> signal(n);
  for (double& value : signal) value = random.uniform(-2.385, 1.7);
  return signal;
}

std::vector<Complex> spectrum_of(RealFourier& fourier, const std::vector<double>& signal) {
  std::copy(signal.begin(), signal.end(), fourier.signal().begin());
  fourier.forward();
  return {fourier.spectrum().begin(), fourier.spectrum().end()};
}

// Σ_j signal_j exp(−2πi jk/n), the angle reduced first.
Complex direct_sum(const std::vector<double>& signal, std::size_t k) {
  const std::size_t n = signal.size();
  Complex sum = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double turn = static_cast<double>(j * k % n) / static_cast<double>(n);
    sum += signal[j] * std::polar(1.0, -2 * std::numbers::pi * turn);
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_spectrum_is_the_direct_sum) {
  for (const std::size_t n : sizes) {
    RealFourier fourier(n);
    const std::vector<double> signal = random_signal(n);
    const std::vector<Complex> spectrum = spectrum_of(fourier, signal);

    BOOST_TEST(fourier.size() == n);
    BOOST_TEST(spectrum.size() == n / 2 + 1);
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
      BOOST_TEST_CONTEXT("n = " << n << ", k = " << k) {
        const double rounding = tolerance::rounding * static_cast<double>(n);
        BOOST_TEST(std::abs(spectrum[k] - direct_sum(signal, k)) < rounding);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_mean_and_the_highest_frequency_are_real) {
  for (const std::size_t n : sizes) {
    RealFourier fourier(n);
    const std::vector<Complex> spectrum = spectrum_of(fourier, random_signal(n));

    BOOST_TEST(spectrum.front().imag() == 0);
    BOOST_TEST(spectrum.back().imag() == 0);
  }
}

BOOST_AUTO_TEST_CASE(forward_and_backward_is_n_times_the_signal) {
  for (const std::size_t n : {4UL, 60UL, 4096UL, 61'440UL}) {
    RealFourier fourier(n);
    const std::vector<double> signal = random_signal(n);
    spectrum_of(fourier, signal);
    fourier.backward();

    double largest = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double error = fourier.signal()[j] / static_cast<double>(n) - signal[j];
      largest = std::max(largest, std::abs(error));
    }
    BOOST_TEST(largest < 2.385 * tolerance::rounding);
  }
}

BOOST_AUTO_TEST_CASE(backward_is_the_direct_sum_of_any_spectrum) {
  // signal_j = S_0 + (−1)^j S_{n/2} + 2 Re Σ S_k exp(2πi jk/n), of a spectrum no signal was made
  // of.
  for (const std::size_t n : {4UL, 12UL, 56UL, 120UL}) {
    RandomInputs random(n + 1);
    RealFourier fourier(n);
    std::vector<Complex> spectrum(n / 2 + 1);
    for (Complex& value : spectrum) value = {random.uniform(-1, 2), random.uniform(-2, 1)};
    spectrum.front().imag(0);
    spectrum.back().imag(0);
    std::copy(spectrum.begin(), spectrum.end(), fourier.spectrum().begin());
    fourier.backward();

    for (std::size_t j = 0; j < n; ++j) {
      double sum = spectrum.front().real() + (j % 2 == 0 ? 1 : -1) * spectrum.back().real();
      for (std::size_t k = 1; k < n / 2; ++k) {
        const double turn = static_cast<double>(j * k % n) / static_cast<double>(n);
        sum += 2 * (spectrum[k] * std::polar(1.0, 2 * std::numbers::pi * turn)).real();
      }
      BOOST_TEST(std::abs(fourier.signal()[j] - sum) <
                 tolerance::rounding * static_cast<double>(n));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_sum_of_squares_is_that_of_the_spectrum) {
  // Parseval: n Σ signal² = |S_0|² + |S_{n/2}|² + 2 Σ |S_k|².
  for (const std::size_t n : {4UL, 28UL, 7680UL, 65'536UL}) {
    RealFourier fourier(n);
    const std::vector<double> signal = random_signal(n);
    const std::vector<Complex> spectrum = spectrum_of(fourier, signal);

    double squares = 0;
    for (const double value : signal) squares += value * value;
    double of_spectrum = std::norm(spectrum.front()) + std::norm(spectrum.back());
    for (std::size_t k = 1; k + 1 < spectrum.size(); ++k) of_spectrum += 2 * std::norm(spectrum[k]);
    // what the sums of squares themselves may lose, added one by one
    const double rounding = tolerance::epsilon * std::sqrt(static_cast<double>(n));
    BOOST_TEST(tolerance::relative_difference(of_spectrum, static_cast<double>(n) * squares) <
               rounding + tolerance::rounding);
  }
}

BOOST_AUTO_TEST_CASE(a_long_transform_keeps_its_digits) {
  // One period of a cosine and of the fastest sine but one: all else is rounding.
  constexpr std::size_t n = 1U << 17U;
  RealFourier fourier(n);
  for (std::size_t j = 0; j < n; ++j) {
    const double turn = static_cast<double>(j) / static_cast<double>(n);
    fourier.signal()[j] = std::cos(2 * std::numbers::pi * turn);
  }
  fourier.forward();

  BOOST_TEST(std::abs(fourier.spectrum()[1] - n / 2.0) < 1e-15 * n);
  double largest = 0;
  for (std::size_t k = 0; k <= n / 2; ++k) {
    if (k != 1) largest = std::max(largest, std::abs(fourier.spectrum()[k]));
  }
  BOOST_TEST(largest < 1e-15 * n);
}

BOOST_AUTO_TEST_CASE(the_size_is_the_least_convenient_one_that_is_enough) {
  // 2^k m, k ≥ 2, m = 1, 3, 5, 7, 9 or 15, found by going up one by one.
  const auto is_convenient = [](std::size_t n) {
    if (n % 4 != 0) return false;
    while (n % 2 == 0) n /= 2;
    return n == 1 || n == 3 || n == 5 || n == 7 || n == 9 || n == 15;
  };
  for (std::size_t min_size = 0; min_size < 700; ++min_size) {
    std::size_t least = min_size < 4 ? 4 : min_size;
    while (!is_convenient(least)) ++least;
    BOOST_TEST(RealFourier(min_size).size() == least);
  }
  BOOST_TEST(RealFourier(1'000'003).size() == 1'048'576);
}

BOOST_AUTO_TEST_CASE(a_transform_may_be_used_again) {
  RealFourier fourier(60);
  const std::vector<double> signal = random_signal(60);
  const std::vector<Complex> once = spectrum_of(fourier, signal);
  fourier.backward();

  BOOST_TEST((spectrum_of(fourier, signal) == once));
}

BOOST_AUTO_TEST_SUITE_END()
