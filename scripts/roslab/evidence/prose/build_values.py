"""What a Dockerfile expects of whoever builds it: values of arguments, and secrets."""

from __future__ import annotations

import re

from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

_ACCOUNT = pattern(r"\b(?:adduser|useradd|usermod|groupadd|addgroup|groupmod|chown|su|gosu)\s[^\n&|;]*")
"""A command of accounts: it fails where a name is empty."""
_GIVEN = pattern(r"(?:TARGET|BUILD)(?:PLATFORM|OS|ARCH|VARIANT)|(?:HTTPS?|FTP|NO|ALL)_PROXY", re.IGNORECASE)
"""What BuildKit gives by itself.

https://docs.docker.com/reference/dockerfile/#automatic-platform-args-in-the-global-scope"""


@dataclass
class Values:
    """The arguments without a default that a Dockerfile has declared so far."""

    open: set[str] = field(default_factory=set)

    def missing(self, name: str, body: str, line: int) -> str | None:
        """Read an instruction; return what it lacks where it makes an account, or becomes a user, without a value."""
        if name in {"ARG", "ENV"}:
            for word in body.split():
                variable, given, _ = word.partition("=")
                self.open.discard(variable)
                if name == "ARG" and not given and not _GIVEN.fullmatch(variable):
                    self.open.add(variable)
            return None
        text = body if name == "USER" else " ".join(_ACCOUNT.findall(body)) if name == "RUN" else ""
        for variable in sorted(self.open):
            if re.search(rf"\$(?:{re.escape(variable)}\b|\{{{re.escape(variable)}\}})", text):
                return f"line {line} needs a value for {variable}, which has no default"
        return None


def secret_of(mount: str) -> str:
    """Return the name of the secret that a mount asks for, by BuildKit's own rules for what is left out.

    https://docs.docker.com/reference/dockerfile/#run---mounttypesecret
    """
    said = dict(part.partition("=")[::2] for part in mount.split(","))
    if said.get("type") == "ssh":
        return "ssh"
    target = said.get("target") or said.get("dst") or said.get("destination") or ""
    return said.get("id") or said.get("source") or said.get("src") or target.rpartition("/")[2]
