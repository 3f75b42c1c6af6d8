"""What a registry's refusal means in a workflow, and the line of YAML that fixes it."""

from __future__ import annotations

import re

from roslab.engine.credentials import Access, Verdict
from roslab.errors import BuildError, Problem, RefusedError
from roslab.github.event import Event

OWN = "ghcr.io"
"""The only registry that may receive the run's own token: any other could keep it and write to the repository."""
REFUSALS: tuple[tuple[re.Pattern[str], Verdict], ...] = (
    (
        re.compile(
            r"permission_denied: (?:write_package|The token provided does not match expected scopes)|403 Forbidden|"
            r"installation not allowed to Create organization package|denied: requested access to the resource"
        ),
        "forbidden",
    ),
    (re.compile(r"401 Unauthorized|unauthorized: [^\n]+|denied: denied"), "wrong password"),
    (re.compile(r": (?P<said>(?:429|50\d) [A-Z][^\n]*)"), "unreachable"),
    (re.compile(r"dial tcp .*(?P<said>connection refused|no such host|i/o timeout)"), "unreachable"),
)
"""What BuildKit says after ``failed to push``, and what that means; the first match counts."""


def problem(access: Access, *, image: str, event: Event) -> Problem | None:
    """Return the problem to report when access is not granted, ``None`` if the push may be tried."""
    host = image.partition("/")[0]
    said = f": {access.detail}" if access.detail else ""
    if access.verdict == "wrong password":
        hint = (
            "leave the secret registry-token (the action's input token) out: the run's own token is then used"
            if host == OWN
            else f"set the input username and the password for {host}: a workflow's secret registry-token, "
            "the action's input token"
        )
        return Problem(message=f"{host} refuses the username or the token{said}", hint=hint)
    if access.verdict == "forbidden":
        return Problem(message=f"the token may not write {image}{said}", hint=_right(host, image, event))
    if access.verdict == "unreachable":
        hint = "run the job again later"
        return Problem(message=f"the registry {host} does not answer{said}", hint=hint)
    return None


def _right(host: str, image: str, event: Event) -> str:
    if host != OWN:
        return f"give the token's account the right to push to {image}"
    line = "add `packages: write` to the `permissions:` of the job that calls this"
    name = image.rpartition("/")[2]
    return (
        f"{line}; if it stands there, the package is another repository's: open the settings of the package {name} and "
        f"give {event.repository} the role Write under Manage Actions access"
    )


def require_secret(registry: str, *, name: str, given: bool) -> None:
    """Raise ``RefusedError`` if a push to another registry than ghcr.io would use the run's own token.

    ``name`` is the secret that the caller can set, ``given`` whether it holds anything but the run's own token.
    """
    if registry == OWN or given:
        return
    raise RefusedError(
        Problem(
            message=f"refused: {registry} needs a password of its own, and `{name}` holds none: the run's own token is "
            f"sent to {OWN} alone",
            hint=f"set `{name}` from a secret of the repository, or `push: false`",
        )
    )


def require(access: Access, *, image: str, event: Event) -> None:
    """Raise ``BuildError`` if a push cannot succeed."""
    if found := problem(access, image=image, event=event):
        raise BuildError(found)


def refusal(log: str) -> Access | None:
    """Return the registry's refusal of a push from a build's log, ``None`` if the build failed for another reason."""
    said = "\n".join(line for line in log.splitlines() if "failed to push" in line)
    for pattern, verdict in REFUSALS:
        if match := pattern.search(said):
            return Access(verdict=verdict, detail=match.groupdict().get("said") or match[0])
    return None
