// E. T. Whittaker and G. N. Watson, A Course of Modern Analysis, 1927, § 22.302: T/T₀ at 90° is 2K(1/√2)/π, and
// K(1/√2) = Γ(1/4)²/(4√π).
#include <cmath>
#include <cstdio>
#include <numbers>

#include "pendulum.hpp"

int main() {
  const double gamma = std::tgamma(0.25);
  const double exact = gamma * gamma / (2 * std::pow(std::numbers::pi, 1.5));
  const numerics::Estimate found = relative_period(std::numbers::pi / 2);
  const double error = std::abs(found.value - exact);
  if (error <= found.abs_error + 1e-15) return 0;
  std::printf("at 90 degrees: %.17g differs from %.17g by more than its bound %.2g\n", found.value,
              exact, found.abs_error);
  return 1;
}
