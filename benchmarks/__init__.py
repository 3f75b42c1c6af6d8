"""What is measured is the program beside these benchmarks, whichever is installed, in the lab beside its tests."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parent.parent / name) for name in ("scripts", "tests")]
