// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace filter_core
{

/// Tracks a value and its rate of change from noisy measurements at a fixed interval.
class AlphaBeta
{
public:
  /// `alpha` and `beta` between 0 and 1: how far a measurement corrects the value and the rate; `interval` in seconds.
  AlphaBeta(double alpha, double beta, double interval);

  /// Takes the next measurement and returns the new estimate of the value.
  double update(double measurement);

private:
  double alpha_;
  double beta_;
  double interval_;
  double value_ = 0.0;
  double rate_ = 0.0;
  bool started_ = false;
};

}  // namespace filter_core
