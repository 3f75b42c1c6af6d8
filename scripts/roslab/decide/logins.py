"""A decision without the passwords and tokens in addresses that its author has left: an image and its files keep none.

Such an address comes from any page, script or list of the tree, and goes to any step; so that all of them are seen, the
whole decision is gone through. roslab.yaml is refused with one (``config``).
"""

from __future__ import annotations

from typing import Any

from roslab.decide.decision import Decision, Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.compiled import public_hosts
from roslab.values.dataclass import fields, is_dataclass, replace
from roslab.values.origin import Place
from roslab.values.redacted import bare, hosts_of_secrets

_TOLD = frozenset({"warnings", "reasons"})
"""What the decision says about itself, in which logins are redacted."""


def without_logins(decision: Decision) -> Decision:
    """Return the decision with addresses that have no password or token, at public hosts no user name either."""
    search = _Search()
    changed = {
        each.name: new
        for each in fields(decision)
        if each.name not in _TOLD and (new := search.cleaned(old := getattr(decision, each.name), None)) is not old
    }
    return replace(decision, **changed, warnings=(*decision.warnings, *search.told.values())) if changed else decision


class _Search:
    def __init__(self) -> None:
        self.told: dict[tuple[str, Place | None], Warning_] = {}

    def cleaned(self, value: Any, at: Place | None) -> Any:
        """Return the value itself if it has no such address; ``at``: the place that what it is part of comes from."""
        if isinstance(value, str):
            return self._bare(value, at) if "@" in value else value
        if isinstance(value, tuple):
            parts = [self.cleaned(each, at) for each in value]
            if all(new is old for new, old in zip(parts, value, strict=True)):
                return value
            return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
        return self._fact(value, at) if is_dataclass(value) else value

    def _fact(self, value: Any, at: Place | None) -> Any:
        file, line = getattr(value, "file", None), getattr(value, "line", None)
        at = Place(file=file, line=line) if file and line else getattr(value, "place", None) or at
        parted = ((each.name, getattr(value, each.name)) for each in fields(value) if each.init)
        changed = {name: new for name, old in parted if (new := self.cleaned(old, at)) is not old}
        return replace(value, **changed) if changed else value

    def _bare(self, text: str, at: Place | None) -> str:
        for host in hosts_of_secrets(text):
            message = (
                f"an address at {host} has a password or a token, which the image does not keep: it is taken without; "
                "let the host give another one, as who reads this file has it, and where the build needs one, name "
                "`netrc` under `secrets` in roslab.yaml"
            )
            self.told.setdefault((host, at), warn(message, at))
        found = bare(text, public_hosts())
        return text if found == text else found
