"""CMake's options for the repository's own packages: those of roslab.yaml, and those that were found."""

from __future__ import annotations

import shlex

from roslab.config.model import Config
from roslab.decide.decision import Decision


def own_options(decision: Decision, config: Config) -> tuple[str, ...]:
    """Return the options; what roslab.yaml sets stands first, and alone."""
    return (*_cmake_options(config), *_unset((*decision.cmake_options, *decision.cuda_options), config))


def _unset(options: tuple[str, ...], config: Config) -> tuple[str, ...]:
    """Return the options that roslab.yaml does not set."""
    said = {word.partition("=")[0].partition(":")[0] for word in shlex.split(config.cmake_options)}
    return tuple(word for word in options if word.partition("=")[0].partition(":")[0] not in said)


def _cmake_options(config: Config) -> tuple[str, ...]:
    words = tuple(shlex.split(config.cmake_options))
    if config.compatible or any("CMAKE_BUILD_TYPE" in word for word in words):
        return words
    return ("-DCMAKE_BUILD_TYPE=Release", *words)
