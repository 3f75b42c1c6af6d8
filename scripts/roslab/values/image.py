"""Names of images, as a ``FROM`` or a registry has them."""

from __future__ import annotations


def without_tag(reference: str) -> str:
    """Return the name of an image without its tag and digest; a registry may have a port."""
    folder, slash, name = reference.partition("@")[0].rpartition("/")
    return f"{folder}{slash}{name.partition(':')[0]}"
