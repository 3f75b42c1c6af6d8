# SPDX-License-Identifier: Apache-2.0
"""A Kalman filter for a point that moves in the plane."""

from .filter import KalmanFilter

__all__ = ["KalmanFilter"]
