"""Computes the period of a pendulum and registers everything that the paper prints."""

import math
import sys

import literate


def relative_period(angle: float, n: int = 64) -> tuple[float, float]:
    """Returns the period over that of small swings, for an angle in radians below π, and a bound on its error.

    T/T₀ = (2/π) ∫₀^{π/2} dφ/√(1 − sin²(angle/2) sin²φ). The integrand is periodic and smooth, so the trapezoidal rule
    converges faster than any power of its step. The bound is the difference from half as many points plus rounding.
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


def compute(document: literate.Document, case: literate.Case) -> None:
    angle, length, gravity = (float(case.pop(key)) for key in ("angle", "length", "gravity"))
    if case:
        raise literate.Error(f"the case has an unknown key: {', '.join(case)}")
    if not 0 < angle < 180:
        raise literate.Error(f"angle = {angle}: must be between 0 and 180 degrees")
    relative, error = relative_period(math.radians(angle))
    series = short_series(math.radians(angle))
    small = 2 * math.pi * math.sqrt(length / gravity)

    document.value("angle", angle, unit="°", format="exact()")
    document.value("length", length, unit="m", format="exact()")
    document.value("relative-period", relative, error=error, digits=6)
    document.value("period", small * relative, error=small * error, unit="s", digits=6)
    document.flag("is-wide", angle > 60)

    document.table(
        "periods",
        [literate.column(r"$\theta$", "°", format="integer()"),
         literate.column("integral", decimals=8, group="$T/T_0$"),
         literate.column(r"$1 + \theta^2/16$", decimals=8, group="$T/T_0$")],
        [[a, relative_period(math.radians(a)), (short_series(math.radians(a)), 1e-15)] for a in (10, 30, 60, 90)])
    angles = range(0, 125, 5)
    document.figure("period", width_cm=10, height_cm=6, data={"periods": {
        "angle": angles,
        "integral": [relative_period(math.radians(a))[0] for a in angles],
        "series": [short_series(math.radians(a)) for a in angles]}})

    document.check("longer-than-small", "Far swings take longer than small ones.", criteria=[
        literate.at_least("period over that of small swings", literate.number(relative, error=error, digits=4),
                          literate.limit(1, "theory", "as long"))])
    document.claim("longer", route="the integral for the period", criteria=[
        literate.at_least("excess", literate.number(relative - 1, error=error, percent=1),
                          literate.limit(0.1, "data", "a tenth"))])
    document.claim("series-suffices", route="the same integral", expected="fails", criteria=[
        literate.agrees_relatively("series", literate.number(series, error=1e-15, digits=4),
                                   literate.number(relative, error=error, digits=4),
                                   literate.limit(0.01, "data", "one part in a hundred"))])


literate.run(compute)
