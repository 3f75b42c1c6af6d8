"""The lock of a published image as a pull request, where the job's token may open one.

The branch belongs to the program: it is written anew as long as nobody else has committed to it. Nothing here fails the
run. https://docs.github.com/en/rest/git/refs, https://docs.github.com/en/rest/repos/contents
"""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import Any
from urllib.parse import quote

from roslab.errors import BuildError
from roslab.github import api, workflow
from roslab.github.event import Event
from roslab.github.issues import AUTHOR
from roslab.github.run import Folder, Run, slug
from roslab.lock.comparison import of_locks
from roslab.plan.lock import from_text
from roslab.plan.locked import NAME
from roslab.render import moved

RIGHTS = "contents: write, pull-requests: write"
SETTING = "Settings, Actions, General: allow GitHub Actions to create and approve pull requests"
"""https://docs.github.com/en/repositories/managing-your-repositorys-settings-and-features/enabling-features-for-your-repository/managing-github-actions-settings-for-a-repository"""


def offer(folder: Folder, run: Run, what: Event, digest: str, environment: Mapping[str, str]) -> None:
    """Offer the lock that the run kept for its default branch, unless the branch has it; say why if it cannot be.

    ``digest`` is that of the published index.
    """
    text = folder.read(NAME)
    if not text or what.branch != what.default_branch or not environment.get("ROSLAB_GITHUB_TOKEN"):
        return
    found = of_locks(run.plan.lock, from_text(text))
    if run.plan.lock and not found.changes:
        workflow.say(f"{NAME} holds what was published")
        return
    try:
        _offer(_Proposal(run, what, environment), text, moved.proposal(found, f"{run.image}@{digest}", what.page))
    except (BuildError, KeyError, TypeError, ValueError) as error:
        workflow.say(f"no pull request with {NAME}: {error}")


class _Proposal:
    """The branch and the file of a proposed lock, and the API."""

    def __init__(self, run: Run, what: Event, environment: Mapping[str, str]) -> None:
        self.file = str(PurePosixPath(run.path, run.config).parent / NAME) if run.config else f"{run.path}/{NAME}"
        self.file = self.file.lstrip("/")
        folder = str(PurePosixPath(self.file).parent)
        self.branch = f"roslab/lock-{slug(folder)}" if folder != "." else "roslab/lock"
        self.what = what
        self._environment = environment
        self._ask = api.asker(environment, pause=lambda _: None)

    def ask(self, path: str) -> Any:
        return self._ask(f"/repos/{self.what.repository}/{path}")

    def send(self, method: str, path: str, body: Mapping[str, Any]) -> Any:
        return api.send(method, f"/repos/{self.what.repository}/{path}", body, self._environment, right=RIGHTS)


def _offer(of: _Proposal, text: str, said: str) -> None:
    what, ref = of.what, f"heads/{of.branch}"
    there = of.ask(f"git/ref/{quote(ref)}")
    if there:
        author = (of.ask(f"commits/{there['object']['sha']}") or {}).get("author") or {}
        if author.get("login") != AUTHOR:
            workflow.say(f"no pull request with {NAME}: somebody else committed to the branch {of.branch}")
            return
    contents = f"contents/{quote(of.file)}"
    if not there or _text(of.ask(f"{contents}?ref={quote(of.branch)}")) != text:
        if there:
            of.send("PATCH", f"git/refs/{quote(ref)}", {"sha": what.sha, "force": True})
        else:
            of.send("POST", "git/refs", {"ref": f"refs/{ref}", "sha": what.sha})
        older = of.ask(f"{contents}?ref={quote(of.branch)}")
        body = {
            "message": f"Lock what the image of {what.sha[:7]} was made of",
            "content": base64.b64encode(text.encode()).decode(),
            "branch": of.branch,
            **({"sha": older["sha"]} if older else {}),
        }
        of.send("PUT", contents, body)
    _pull(of, said)


def _pull(of: _Proposal, said: str) -> None:
    """Open the pull request, or write its text anew."""
    what = of.what
    known = of.ask(f"pulls?state=open&head={quote(f'{what.owner}:{of.branch}')}&base={quote(what.default_branch)}")
    number = next((int(each["number"]) for each in known or () if each["head"]["ref"] == of.branch), None)
    if number:
        of.send("PATCH", f"pulls/{number}", {"body": said})
        workflow.say(f"the pull request {number} has the {NAME} of this image")
        return
    body = {"title": f"Lock what {what.repository.partition('/')[2]} is built of", "head": of.branch, "body": said}
    try:
        number = int(of.send("POST", "pulls", {**body, "base": what.default_branch})["number"])
    except BuildError as error:
        workflow.say(f"{NAME} is on the branch {of.branch}; no pull request: {error} ({SETTING})")
        return
    workflow.notice(f"the pull request {number} offers the {NAME} of this image")


def _text(found: Any) -> str | None:
    """Return the text of a file as the API sends it, ``None`` if there is none."""
    return base64.b64decode(found["content"]).decode() if found else None
