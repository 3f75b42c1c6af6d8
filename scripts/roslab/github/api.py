"""GitHub's API: the commit a branch points to now, and the releases that exist."""

from __future__ import annotations

import json
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Mapping
from typing import Any
from urllib.parse import quote

from roslab.errors import BuildError, Problem
from roslab.github.event import Event

SECONDS = 20.0
ATTEMPTS = 4
PAGES = 100
"""The most pages that are read of one list; each page has a hundred entries."""
Ask = Callable[[str], Any]
"""A function that takes a path of the API and returns the answer, ``None`` if nothing exists there."""


def asker(environment: Mapping[str, str], *, method: str = "GET", pause: Callable[[float], None] = time.sleep) -> Ask:
    """Return a function that asks the API with the job's token in ROSLAB_GITHUB_TOKEN.

    The function raises ``BuildError`` if GitHub does not answer. https://docs.github.com/en/rest/git/refs
    """
    base = environment.get("GITHUB_API_URL") or "https://api.github.com"
    token = environment.get("ROSLAB_GITHUB_TOKEN", "")
    headers = {"Accept": "application/vnd.github+json", "User-Agent": "roslab"}
    headers |= {"Authorization": f"Bearer {token}"} if token else {}

    def ask(path: str) -> Any:
        request = urllib.request.Request(base + path, headers=headers, method=method)  # noqa: S310 - the runner's own address
        for attempt in range(1, ATTEMPTS + 1):
            try:
                with urllib.request.urlopen(request, timeout=SECONDS) as reply:  # noqa: S310
                    return json.loads(reply.read() or b"{}")  # the answer to a DELETE is empty
            except urllib.error.HTTPError as error:
                if error.code == 404:
                    return None
                said = f"HTTP {error.code}"
                if error.code < 500 and error.code != 429:
                    break
            except (OSError, ValueError) as error:
                said = str(getattr(error, "reason", None) or error)
            if attempt < ATTEMPTS:
                pause(2.0 ** (attempt - 1))
        what = path.partition("/git/")[2] or path
        message = f"GitHub does not {f'say what {what} is' if method == 'GET' else f'remove {what}'}: {said}"
        raise BuildError(Problem(message=message, hint="no tag was moved; run the failed job again"))

    return ask


def send(method: str, path: str, body: Mapping[str, Any], environment: Mapping[str, str], *, right: str) -> Any:
    """Send a body to the API, once: what was asked twice might be done twice; return the answer.

    ``right`` is what the job's ``permissions`` need for it, named where it is refused. Raises ``BuildError``.
    """
    base = environment.get("GITHUB_API_URL") or "https://api.github.com"
    headers = {
        "Accept": "application/vnd.github+json",
        "Authorization": f"Bearer {environment.get('ROSLAB_GITHUB_TOKEN', '')}",
        "Content-Type": "application/json",
        "User-Agent": "roslab",
    }
    data = json.dumps(body).encode()
    request = urllib.request.Request(base + path, data=data, headers=headers, method=method)  # noqa: S310 - the runner's own address
    try:
        with urllib.request.urlopen(request, timeout=SECONDS) as reply:  # noqa: S310
            return json.loads(reply.read() or b"{}")
    except urllib.error.HTTPError as error:
        hint = f"`{right}` below `permissions:` of the job lets it" if error.code in (401, 403, 404) else None
        raise BuildError(Problem(message=f"GitHub refuses {method} {path}: HTTP {error.code}", hint=hint)) from None
    except (OSError, ValueError) as error:
        said = str(getattr(error, "reason", None) or error)
        raise BuildError(Problem(message=f"GitHub does not answer {method} {path}: {said}")) from None


def branch_head(event: Event, ask: Ask) -> str | None:
    """Return the commit that the event's branch points to, ``None`` if the branch does not exist (any more).

    The branch of a pull request, which must be the repository's own, is the one that it comes from.
    """
    branch = event.head_branch if event.proposed else event.branch
    if not branch:
        return None
    answer = ask(f"/repos/{event.repository}/git/ref/heads/{quote(branch)}")
    return str(answer["object"]["sha"]) if answer else None


def releases(event: Event, ask: Ask) -> tuple[str, ...]:
    """Return the names of the git tags that share the event's tag up to its last dot, such as ``v1.2.``."""
    if not event.tag or "." not in event.tag:
        return ()
    series = event.tag.rpartition(".")[0] + "."
    answer = ask(f"/repos/{event.repository}/git/matching-refs/tags/{quote(series)}")
    return tuple(str(entry["ref"]).removeprefix("refs/tags/") for entry in answer or ())


def pages(ask: Ask, path: str, *, whole: bool = True) -> list[dict[str, Any]] | None:
    """Return the entries of a list of the API, ``None`` if there is no such list.

    Raises ``BuildError`` if ``whole`` demands every entry and the list is longer than the pages that are read.
    https://docs.github.com/en/rest/using-the-rest-api/using-pagination-in-the-rest-api
    """
    found: list[dict[str, Any]] = []
    for page in range(1, PAGES + 1):
        answer = ask(f"{path}{'&' if '?' in path else '?'}per_page=100&page={page}")
        if answer is None:
            return None
        found += answer
        if len(answer) < 100:
            return found
    if whole:
        raise BuildError(Problem(message=f"GitHub lists more than {len(found)} entries of {path}"))
    return found
