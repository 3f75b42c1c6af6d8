"""Pins of a framework that the project's own manifest has outlived."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.python.pins import Pin
from roslab.values.version import minor_of


def outdone(pin: Pin, pins: Iterable[Pin]) -> bool:
    """Tell whether something more trusted pins the same package to another series of releases.

    The CUDA of ``torch==1.8.1+cu101`` in a Dockerfile beside a setup.py with ``torch==2.2.0`` is an older image's.
    """
    series = minor_of(pin.release or "")
    others = (each for each in pins if each.name == pin.name and each.trust > pin.trust and each.release)
    return bool(series) and any(minor_of(each.release or "") not in {series, None} for each in others)
