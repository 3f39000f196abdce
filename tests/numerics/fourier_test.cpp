// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fourier.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <thread>

#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(fourier_test)

using numerics::ComplexBuffer;
using numerics::ComplexFourier;
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

// Σ_j signal_j exp(∓2πi jk/n), the angle reduced first.
template <class Number>
Complex direct_sum(const std::vector<Number>& signal, std::size_t k, int sign) {
  const std::size_t n = signal.size();
  Complex sum = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double turn = static_cast<double>(j * k % n) / static_cast<double>(n);
    sum += signal[j] * std::polar(1.0, sign * 2 * std::numbers::pi * turn);
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(transforms_equal_their_defining_sums) {
  for (const std::size_t n : sizes) {
    BOOST_TEST_CONTEXT("n = " << n) {
      const double rounding = tolerance::rounding * static_cast<double>(n);
      const std::vector<double> signal = random_signal(n);
      RealFourier fourier(n);
      const std::vector<Complex> spectrum = spectrum_of(fourier, signal);
      BOOST_TEST(fourier.size() == n);
      BOOST_TEST(spectrum.size() == n / 2 + 1);
      for (std::size_t k = 0; k < spectrum.size(); ++k) {
        BOOST_TEST(std::abs(spectrum[k] - direct_sum(signal, k, -1)) < rounding);
      }
      BOOST_TEST(spectrum.front().imag() == 0);
      BOOST_TEST(spectrum.back().imag() == 0);
      fourier.backward();
      for (std::size_t j = 0; j < n; ++j) {
        BOOST_TEST(std::abs(fourier.signal()[j] - static_cast<double>(n) * signal[j]) < rounding);
      }
      BOOST_TEST((spectrum_of(fourier, signal) == spectrum));

      const ComplexFourier complex(n);
      const ComplexBuffer buffer(n);
      std::vector<Complex> numbers(n);
      for (std::size_t j = 0; j < n; ++j) numbers[j] = {signal[j], signal[n - 1 - j]};
      for (const int sign : {-1, 1}) {
        std::copy(numbers.begin(), numbers.end(), buffer.data());
        sign < 0 ? complex.forward(buffer) : complex.backward(buffer);
        for (std::size_t k = 0; k < n; ++k) {
          BOOST_TEST(std::abs(buffer[k] - direct_sum(numbers, k, sign)) < rounding);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(threads_may_plan_transforms_at_the_same_time) {
  // Without the lock, two threads crash FFTW's planner here.
  std::vector<Complex> sums(4);
  const auto plan_many = [&](std::size_t thread) {
    for (std::size_t n = 4; n < 2000; n += 4) {
      RealFourier fourier(n);
      const ComplexFourier complex(n);
      std::fill(fourier.signal().begin(), fourier.signal().end(), 1.0);
      fourier.forward();
      sums[thread] += fourier.spectrum()[0] / static_cast<double>(fourier.size());
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < sums.size(); ++i) threads.emplace_back(plan_many, i);
  }
  for (const Complex& sum : sums) BOOST_TEST(std::abs(sum - 499.0) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_long_transform_keeps_its_digits) {
  // One period of a cosine: every other coefficient is rounding.
  constexpr std::size_t n = 1U << 17U;
  RealFourier fourier(n);
  for (std::size_t j = 0; j < n; ++j) {
    const double turn = static_cast<double>(j) / static_cast<double>(n);
    fourier.signal()[j] = std::cos(2 * std::numbers::pi * turn);
  }
  fourier.forward();

  for (std::size_t k = 0; k <= n / 2; ++k) {
    const double exact = k == 1 ? n / 2.0 : 0;
    if (std::abs(fourier.spectrum()[k] - exact) > 1e-15 * n) BOOST_ERROR("k = " << k);
  }
}

BOOST_AUTO_TEST_CASE(the_size_is_the_least_convenient_one_that_suffices) {
  // 2^k m, k ≥ 2, m = 1, 3, 5, 7, 9 or 15, found by trying every number.
  const auto is_convenient = [](std::size_t n) {
    if (n % 4 != 0) return false;
    while (n % 2 == 0) n /= 2;
    return n == 1 || n == 3 || n == 5 || n == 7 || n == 9 || n == 15;
  };
  for (std::size_t min_size = 0; min_size < 700; ++min_size) {
    std::size_t least = min_size < 4 ? 4 : min_size;
    while (!is_convenient(least)) ++least;
    BOOST_TEST(numerics::convenient_fourier_size(min_size) == least);
  }
  BOOST_TEST(RealFourier(1'000'003).size() == 1'048'576);
}

BOOST_AUTO_TEST_SUITE_END()
