"""Pointers of Git LFS: https://github.com/git-lfs/git-lfs/blob/main/docs/spec.md, read 2026-11-26."""

POINTER = b"version https://git-lfs.github.com/spec/v1"
"""First line of a file whose content is in LFS."""
LARGEST_POINTER = 1024
"""Bytes that such a file is smaller than."""
