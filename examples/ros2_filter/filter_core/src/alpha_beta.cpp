// SPDX-License-Identifier: Apache-2.0
#include "filter_core/alpha_beta.hpp"

namespace filter_core
{

AlphaBeta::AlphaBeta(double alpha, double beta, double interval) : alpha_(alpha), beta_(beta), interval_(interval) {}

double AlphaBeta::update(double measurement)
{
  if (!started_) {
    started_ = true;
    return value_ = measurement;
  }
  const double predicted = value_ + interval_ * rate_;
  const double residual = measurement - predicted;
  value_ = predicted + alpha_ * residual;
  rate_ += beta_ * residual / interval_;
  return value_;
}

}  // namespace filter_core
