"""Run roslab from a checkout: ``python -I scripts …``, as the action does."""

import sys

from roslab.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
