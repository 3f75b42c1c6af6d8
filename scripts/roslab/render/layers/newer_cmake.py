"""Layer 3, CMake itself: a newer one than the distribution's."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell

CMAKE_URL = "https://cmake.org/files"
"""Kitware's own archive of every release, ``vX.Y/cmake-X.Y.Z.tar.gz``."""


def newer_cmake(plan: Plan) -> str:
    """Build the CMake that ``base.cmake_update`` asks for over the distribution's."""
    if not plan.cmake_update:
        return ""
    version = plan.cmake_update
    name = f"cmake-{version}"
    url = f"{CMAKE_URL}/v{'.'.join(version.split('.')[:2])}/{name}.tar.gz"
    return shell.run(
        f"curl --fail --silent --show-error --location {quote.shell(url)} | tar --extract --gzip --directory /tmp",
        f"cd /tmp/{quote.shell(name)}",
        shell.SET_JOBS,
        './bootstrap --parallel="${jobs}" -- -DCMAKE_USE_OPENSSL=OFF',
        'make --jobs="${jobs}" install',
        f"rm -rf /tmp/{quote.shell(name)}",
        comment=f"CMake {version}, newer than the distribution's",
    )
