"""What is measured is the program that lies beside these benchmarks, whichever is installed."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "scripts"))
