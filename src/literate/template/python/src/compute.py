"""The numbers of the paper: the period of a pendulum that swings to a wide angle."""

import math
import sys

import literate


def relative_period(angle: float, n: int = 64) -> tuple[float, float]:
    """Returns T/T₀ = (2/π) ∫₀^{π/2} dφ/√(1 − sin²(angle/2) sin²φ) and a bound of its error, for an angle in radians below π.

    The integrand is periodic and smooth, so the trapezoidal rule converges faster than any power of its step.
    """
    k = math.sin(angle / 2)

    def trapezoidal(n: int) -> float:
        step = math.pi / 2 / n
        inner = sum(1 / math.sqrt(1 - (k * math.sin(i * step)) ** 2) for i in range(1, n))
        return (0.5 * (1 + 1 / math.sqrt(1 - k * k)) + inner) / n

    coarse, fine = trapezoidal(n // 2), trapezoidal(n)
    return fine, abs(fine - coarse) + 8 * sys.float_info.epsilon * fine


def short_series(angle: float) -> float:
    """Returns the first two terms of its series."""
    return 1 + angle * angle / 16


def compute(document: literate.Document, case: dict) -> None:
    """Registers everything that the paper prints."""
    angle, length, gravity = (float(case.pop(key)) for key in ("angle", "length", "gravity"))
    if case:
        sys.exit(f"the case has an unknown key: {', '.join(case)}")
    if not 0 < angle < 180:
        sys.exit(f"angle = {angle}: must be between 0 and 180 degrees")
    radians = math.radians(angle)
    relative, error = relative_period(radians)
    series = short_series(radians)
    small = 2 * math.pi * math.sqrt(length / gravity)

    document.value("angle", angle, unit="°", format="exact()")
    document.value("length", length, unit="m", format="exact()")
    document.value("relative-period", relative, error=error, digits=6)
    document.value("period", small * relative, error=small * error, unit="s", digits=6)
    document.flag("is-wide", angle > 60)
    document.check("longer-than-small", "Far swings take longer than small ones.", criteria=[
        literate.at_least("period over that of small swings", literate.number(relative, error=error, digits=4),
                          literate.limit(1, "theory", "as long"))])

    angles = [10, 30, 60, 90]
    document.table("periods",
                   [literate.column(r"$\theta$", "°", format="integer()"),
                    literate.column("integral", decimals=8, group="$T/T_0$"),
                    literate.column(r"$1 + \theta^2/16$", decimals=8, group="$T/T_0$")],
                   [[a, relative_period(math.radians(a)), (short_series(math.radians(a)), 1e-15)] for a in angles])
    angles = range(0, 125, 5)
    document.figure("period", 10, 6, {"periods": {
        "angle": angles,
        "integral": [relative_period(math.radians(a))[0] for a in angles],
        "series": [short_series(math.radians(a)) for a in angles]}})

    document.claim("longer", route="the integral for the period", criteria=[
        literate.at_least("excess", literate.number(relative - 1, error=error, percent=1),
                          literate.limit(0.1, "data", "a tenth"))])
    document.claim("series-suffices", route="the same integral", expected="fails", criteria=[
        literate.agrees_relatively("series", literate.number(series, error=1e-15, digits=4),
                                   literate.number(relative, error=error, digits=4),
                                   literate.limit(0.01, "data", "one part in a hundred"))])


literate.run(compute)
