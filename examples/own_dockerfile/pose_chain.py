# SPDX-License-Identifier: Apache-2.0
"""Chain noisy odometry along a square, and close the loop by spreading the error over the poses."""

import numpy as np


def pose(x, y, heading):
    """Return a pose in the plane as a 3x3 matrix; metres and radians."""
    c, s = np.cos(heading), np.sin(heading)
    return np.array([[c, -s, x], [s, c, y], [0.0, 0.0, 1.0]])


def main():
    """Print how far the chain ends from its start, before and after."""
    random = np.random.default_rng(1)
    step, turn = pose(1.0, 0.0, 0.0), pose(0.0, 0.0, np.pi / 2)
    chain = [np.eye(3)]
    for index in range(40):
        noise = pose(*random.normal(0.0, [0.02, 0.02, 0.01]))
        motion = step @ turn if index % 10 == 9 else step
        chain.append(chain[-1] @ motion @ noise)
    positions = np.array([matrix[:2, 2] for matrix in chain])
    gap = positions[-1] - positions[0]
    closed = positions - np.linspace(0.0, 1.0, len(positions))[:, None] * gap
    print(f"open:   the chain ends {np.linalg.norm(gap):.3f} m from its start")
    print(f"closed: {np.linalg.norm(closed[-1] - closed[0]):.3f} m")


if __name__ == "__main__":
    main()
