"""Scripts of the image that read a workspace call one another: where one is copied, those that it calls are too."""

from __future__ import annotations

from collections.abc import Iterable

PACKAGES = "workspace-packages"
"""The script that says which packages of a workspace need which."""
MANIFEST = "read-manifest"
"""The script that reads what a package.xml tells."""
CALLED = {
    PACKAGES: (MANIFEST,),
    "build-needed": (PACKAGES,),
    "clone-holding": (PACKAGES, "checkout-branch", "fetch-submodules", "take-ros-branch", "serve-rosbuild"),
    "clone-listed": ("checkout-branch", "fetch-submodules", "take-ros-branch", "serve-rosbuild"),
    "clone-unknown": ("clone-holding", "leave-out-doubles", "listed-repositories", PACKAGES, MANIFEST),
    "declare-needs": ("required-by-cmake", MANIFEST),
    "leave-out-doubles": (MANIFEST,),
    "leave-out-failed": (PACKAGES, MANIFEST),
    "leave-out-lacking": (PACKAGES,),
    "plain-apart": (PACKAGES,),
    "take-listed": ("checkout-branch", "fetch-submodules", "listed-repositories"),
    "raise-standard": ("required-by-cmake", MANIFEST),
    "required-components": ("required-by-cmake", MANIFEST),
}
"""Scripts, each with those that it calls."""


def with_called(scripts: Iterable[str]) -> tuple[str, ...]:
    """Return scripts and, behind them, those that they call, each once."""
    found = list(dict.fromkeys(scripts))
    for script in found:
        found += [name for name in CALLED.get(script, ()) if name not in found]
    return tuple(found)
