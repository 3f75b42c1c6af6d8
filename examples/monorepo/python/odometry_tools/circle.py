# SPDX-License-Identifier: Apache-2.0
"""Fit a circle to positions, one ``x y`` a line on standard input."""

import sys

import numpy as np


def fit_circle(positions):
    """Return centre and radius of the circle through positions in the sense of least squares (Kasa's method)."""
    coefficients = np.column_stack([2.0 * positions, np.ones(len(positions))])
    (x, y, rest), *_ = np.linalg.lstsq(coefficients, np.sum(positions**2, axis=1), rcond=None)
    return np.array([x, y]), float(np.sqrt(rest + x**2 + y**2))


def main():
    """Print centre and radius."""
    centre, radius = fit_circle(np.loadtxt(sys.stdin, ndmin=2))
    print(f"centre {centre[0]:.3f} {centre[1]:.3f}, radius {radius:.3f}")


if __name__ == "__main__":
    main()
