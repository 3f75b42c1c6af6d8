"""PyYAML, imported without compiling its patterns: some are for the pure Python reader, and most files need none."""

from roslab.values.pattern import postponed

with postponed():
    import yaml

__all__ = ["yaml"]
