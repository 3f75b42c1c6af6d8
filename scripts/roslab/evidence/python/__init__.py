"""Readers of Python manifests and modules."""
