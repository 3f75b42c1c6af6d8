"""The one issue that the watch keeps: found by a mark in its text, opened, updated, closed.

https://docs.github.com/en/rest/issues/issues
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from urllib.parse import quote

from roslab.github import api, workflow
from roslab.github.event import Event
from roslab.github.run import short
from roslab.values.dataclass import dataclass

AUTHOR = "github-actions[bot]"
"""Who opens issues with a job's own token: an issue of anybody else is not the watch's, whatever it says.
https://docs.github.com/en/actions/concepts/security/github_token"""
RIGHT = "issues: write"


@dataclass(frozen=True, kw_only=True, slots=True)
class Keeper:
    """Keeps the issue of one image."""

    event: Event
    subject: str
    """What the issue is about: an image, with what makes variants of it."""
    environment: Mapping[str, str]

    @property
    def mark(self) -> str:
        """The line of the text by which the next run finds the issue."""
        return f"<!-- roslab drift {short(self.subject)} -->"

    def tell(self, title: str, text: str) -> int:
        """Open the issue, or write its text anew; return its number. Raises ``BuildError``."""
        body = {"title": title, "body": f"{self.mark}\n{text}"}
        if found := self._open():
            number = int(found[0]["number"])
            if str(found[0].get("body", "")) != body["body"]:
                self._send("PATCH", f"/{number}", body)
            workflow.say(f"updated the issue {number}")
            return number
        number = int(self._send("POST", "", body)["number"])
        workflow.say(f"opened the issue {number}")
        return number

    def close(self, text: str) -> None:
        """Close the issue, with a comment, if it is open. Raises ``BuildError``."""
        for each in self._open():
            number = int(each["number"])
            self._send("POST", f"/{number}/comments", {"body": text})
            self._send("PATCH", f"/{number}", {"state": "closed", "state_reason": "completed"})
            workflow.say(f"closed the issue {number}")

    def _open(self) -> list[dict[str, Any]]:
        path = f"/repos/{self.event.repository}/issues?state=open&creator={quote(AUTHOR)}"
        found = api.pages(api.asker(self.environment), path) or []
        return [
            each
            for each in found
            if "pull_request" not in each
            and each.get("user", {}).get("login") == AUTHOR
            and self.mark in str(each.get("body", ""))
        ]

    def _send(self, method: str, path: str, body: Mapping[str, Any]) -> Any:
        return api.send(method, f"/repos/{self.event.repository}/issues{path}", body, self.environment, right=RIGHT)
