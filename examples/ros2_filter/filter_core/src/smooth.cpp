// SPDX-License-Identifier: Apache-2.0
// Reads one number a line from standard input and prints the filtered ones.
#include <iostream>

#include "filter_core/alpha_beta.hpp"

int main()
{
  filter_core::AlphaBeta filter(0.2, 0.02, 0.1);
  for (double measurement; std::cin >> measurement;) {
    std::cout << filter.update(measurement) << '\n';
  }
  return std::cin.eof() ? 0 : 1;
}
