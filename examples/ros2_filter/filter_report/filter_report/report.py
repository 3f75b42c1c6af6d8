# SPDX-License-Identifier: Apache-2.0
"""Feed a noisy sine to filter_core's program and say how much of the noise is left."""

import math
import random
import subprocess
import sys


def root_mean_square(errors):
    """Return the usual size of the errors, in their unit."""
    return math.sqrt(sum(error * error for error in errors) / len(errors))


def main():
    """Print both errors; the exit code is 1 where the filter made it worse."""
    random.seed(1)  # the same noise every time
    truth = [math.sin(0.02 * step) for step in range(1000)]
    noisy = [value + random.gauss(0.0, 0.2) for value in truth]
    answer = subprocess.run(
        ["smooth"], input="\n".join(map(str, noisy)), stdout=subprocess.PIPE, universal_newlines=True, check=True
    )
    filtered = [float(line) for line in answer.stdout.split()]
    before = root_mean_square([a - b for a, b in zip(noisy, truth)])
    after = root_mean_square([a - b for a, b in zip(filtered, truth)])
    print(f"error of the measurements: {before:.3f}")
    print(f"error after the filter:    {after:.3f}")
    return 0 if after < before else 1


if __name__ == "__main__":
    sys.exit(main())
