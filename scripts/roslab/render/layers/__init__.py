"""Blocks of a Dockerfile, one function each; ``dockerfile`` puts them in order."""
