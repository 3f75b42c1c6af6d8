"""``python -m roslab``."""

import sys

from roslab.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
