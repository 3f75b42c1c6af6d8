"""The program ``roslab``, also as ``python -m roslab``."""

import sys


def run() -> None:
    """Run the command line; an interrupt ends it in the same way while its modules are still being imported."""
    try:
        from roslab.cli.main import run as program  # noqa: PLC0415 - what takes long is this

        program()
    except KeyboardInterrupt:
        sys.stderr.write("\nroslab: interrupted\n")
        sys.exit(130)


if __name__ == "__main__":
    run()
