# SPDX-License-Identifier: Apache-2.0
"""Track a point on a curve through noise, draw the track to a file and print the errors."""

import argparse

import matplotlib
import numpy as np

matplotlib.use("Agg")  # draws to files: no display is needed
from matplotlib import pyplot as plt

from kalman import KalmanFilter


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default="track.png", help="file of the figure (default: track.png)")
    parser.add_argument("--noise", type=float, default=0.5, help="noise of a measurement in m (default: 0.5)")
    options = parser.parse_args()

    interval = 0.1
    time = np.arange(0.0, 20.0, interval)
    truth = np.column_stack([10.0 * np.cos(0.3 * time), 5.0 * np.sin(0.6 * time)])
    measured = truth + np.random.default_rng(1).normal(0.0, options.noise, truth.shape)
    kalman = KalmanFilter(interval, acceleration=2.0, noise=options.noise)
    estimated = np.array([kalman.step(position) for position in measured])

    for name, positions in (("measured", measured), ("filtered", estimated)):
        error = np.sqrt(np.mean(np.sum((positions - truth) ** 2, axis=1)))
        print(f"{name}: {error:.3f} m root mean square error")

    plt.plot(*truth.T, "k-", label="truth")
    plt.plot(*measured.T, ".", color="0.7", label="measured")
    plt.plot(*estimated.T, "r-", label="filtered")
    plt.axis("equal")
    plt.legend()
    plt.savefig(options.output, dpi=150)
    print(f"figure: {options.output}")


if __name__ == "__main__":
    main()
