"""Run roslab from a checkout: ``python -I scripts …``, as the action does."""

from roslab.__main__ import run

if __name__ == "__main__":
    run()
