"""Decisions on CUDA: whether it is needed, and which version."""
