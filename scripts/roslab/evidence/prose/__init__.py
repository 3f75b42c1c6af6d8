"""Readers of what was written for people or for other machines: pages, CI, scripts, the author's Dockerfiles."""
