// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fourier.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "random_inputs.hpp"

BOOST_AUTO_TEST_SUITE(complex_fourier_test)

using numerics::ComplexBuffer;
using numerics::ComplexFourier;
using numerics::convenient_fourier_size;
using Complex = std::complex<double>;

namespace {

std::vector<Complex> random_signal(std::size_t n) {
  RandomInputs random(n);
  std::vector<Complex> signal;
  for (std::size_t j = 0; j < n; ++j)
    signal.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
  return signal;
}

double largest_difference(const ComplexBuffer& a, const std::vector<Complex>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < b.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_transform_is_the_sum_it_stands_for) {
  for (const std::size_t n : {4U, 15U, 60U}) {
    const std::vector<Complex> signal = random_signal(n);
    std::vector<Complex> sums(n);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < n; ++j) {
        const double turns = static_cast<double>(j * k % n) / static_cast<double>(n);
        sums[k] += signal[j] * std::polar(1.0, -2 * std::numbers::pi * turns);
      }
    }
    const ComplexBuffer buffer(n);
    std::copy(signal.begin(), signal.end(), buffer.data());
    ComplexFourier(n).forward(buffer);

    BOOST_TEST(largest_difference(buffer, sums) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(back_and_forth_is_n_times_the_signal) {
  constexpr std::size_t n = 96;
  std::vector<Complex> signal = random_signal(n);
  const ComplexFourier fourier(n);
  const ComplexBuffer buffer(n);
  std::copy(signal.begin(), signal.end(), buffer.data());
  fourier.forward(buffer);
  fourier.backward(buffer);
  for (Complex& value : signal) value *= static_cast<double>(n);

  BOOST_TEST(largest_difference(buffer, signal) < 1e-13);
}

BOOST_AUTO_TEST_CASE(threads_may_share_a_transform) {
  constexpr std::size_t n = 1024;
  const std::vector<Complex> signal = random_signal(n);
  const ComplexFourier fourier(n);
  std::vector<ComplexBuffer> buffers;
  for (int t = 0; t < 4; ++t) {
    buffers.emplace_back(n);
    std::copy(signal.begin(), signal.end(), buffers.back().data());
  }
  {
    std::vector<std::jthread> threads;
    for (const ComplexBuffer& buffer : buffers) {
      threads.emplace_back([&fourier, &buffer] { fourier.forward(buffer); });
    }
  }
  for (const ComplexBuffer& buffer : buffers) {
    BOOST_TEST(std::equal(buffer.data(), buffer.data() + n, buffers[0].data()));
  }
}

BOOST_AUTO_TEST_CASE(convenient_sizes_are_not_much_greater_than_what_is_asked_for) {
  BOOST_TEST(convenient_fourier_size(1) == 4);
  BOOST_TEST(convenient_fourier_size(1024) == 1024);
  BOOST_TEST(convenient_fourier_size(1025) == 1152);  // 2⁷·9
  for (std::size_t n = 16; n < 5000; n += 7) {
    BOOST_TEST(convenient_fourier_size(n) >= n);
    BOOST_TEST(convenient_fourier_size(n) % 4 == 0);
    BOOST_TEST(static_cast<double>(convenient_fourier_size(n)) < 1.26 * static_cast<double>(n));
  }
}

BOOST_AUTO_TEST_SUITE_END()
