"""T/T₀ at 90° is 2K(1/√2)/π, and K(1/√2) = Γ(1/4)²/(4√π).

E. T. Whittaker and G. N. Watson, A Course of Modern Analysis, 1927, § 22.302.
"""

import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "src"))
from pendulum import relative_period  # noqa: E402


class Period(unittest.TestCase):
    def test_at_90_degrees_the_error_is_within_its_bound(self):
        exact = math.gamma(0.25) ** 2 / (2 * math.pi**1.5)
        found, error = relative_period(math.pi / 2)
        self.assertLessEqual(abs(found - exact), error + 1e-15)


unittest.main()
