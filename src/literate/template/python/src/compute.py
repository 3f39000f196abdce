"""Registers everything that the paper prints."""

import math

import literate
from pendulum import relative_period, short_series


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
