"""``python -m roslab``."""

from roslab.cli.main import run

if __name__ == "__main__":
    run()
