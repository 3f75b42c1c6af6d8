"""Decisions on Python: version, manager, packages, pins."""
