"""Decisions on system packages: what apt installs, and what is built from source instead."""
