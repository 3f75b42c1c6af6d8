# SPDX-License-Identifier: Apache-2.0
"""A linear Kalman filter with a constant-velocity model."""

import numpy as np


class KalmanFilter:
    """Estimates position and velocity, ``[x, y, vx, vy]``, from noisy positions.

    ``interval`` in seconds, ``acceleration`` and ``noise`` are standard deviations in m/s^2 and m.
    """

    def __init__(self, interval, acceleration, noise):
        self.transition = np.eye(4)
        self.transition[:2, 2:] = interval * np.eye(2)
        self.observation = np.eye(2, 4)
        steps = np.vstack([0.5 * interval**2 * np.eye(2), interval * np.eye(2)])
        self.process_covariance = acceleration**2 * steps @ steps.T
        self.noise_covariance = noise**2 * np.eye(2)
        self.state = np.zeros(4)
        self.covariance = 100.0 * np.eye(4)

    def step(self, measurement):
        """Predict one interval ahead, correct with a measured position, return the estimated position."""
        self.state = self.transition @ self.state
        self.covariance = self.transition @ self.covariance @ self.transition.T + self.process_covariance

        innovation = measurement - self.observation @ self.state
        innovation_covariance = self.observation @ self.covariance @ self.observation.T + self.noise_covariance
        gain = np.linalg.solve(innovation_covariance, self.observation @ self.covariance).T
        self.state = self.state + gain @ innovation
        self.covariance = (np.eye(4) - gain @ self.observation) @ self.covariance
        return self.state[:2]
