"""The period of a pendulum over that of small swings, for amplitudes in radians below π."""

import math
import sys


def relative_period(angle: float, n: int = 64) -> tuple[float, float]:
    """Returns T/T₀ = (2/π) ∫₀^{π/2} dφ/√(1 − sin²(angle/2) sin²φ) and a bound on its error.

    The integrand is periodic and smooth, so the trapezoidal rule converges faster than any power of its step. The bound is
    the difference from half as many points plus rounding.
    """
    k = math.sin(angle / 2)

    def trapezoidal(n: int) -> float:
        step = math.pi / 2 / n
        inner = sum(1 / math.sqrt(1 - (k * math.sin(i * step)) ** 2) for i in range(1, n))
        return (0.5 * (1 + 1 / math.sqrt(1 - k * k)) + inner) / n

    coarse, fine = trapezoidal(n // 2), trapezoidal(n)
    return fine, abs(fine - coarse) + 8 * sys.float_info.epsilon * fine


def short_series(angle: float) -> float:
    """Returns the first two terms of its series in the angle."""
    return 1 + angle * angle / 16
