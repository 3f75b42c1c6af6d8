"""Readers of texts for people or other machines: pages, CI files, scripts, the author's Dockerfiles."""
