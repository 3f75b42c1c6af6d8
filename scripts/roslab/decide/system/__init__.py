"""Decisions on system packages."""
