"""Readers of Python's manifests and modules."""
