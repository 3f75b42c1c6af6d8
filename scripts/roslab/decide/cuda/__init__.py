"""Decisions on CUDA: whether, and which."""
