"""Repositories that nobody prepared: each planned, built, proved and run, and why not."""
