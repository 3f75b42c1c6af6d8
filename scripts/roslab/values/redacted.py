"""Texts without the logins and tokens that an author has left in an address or a command.

The messages of a plan are printed in logs and pages that anybody may read.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from roslab.values.pattern import pattern

HIDDEN = "***"
_LOGIN = pattern(
    r"(\b(?:[a-z]+\+)?(?:https?|ftps?|wss?)://)[^/\s'\"]+@|(\b(?:[a-z]+\+)?\w+://)[^/\s@:'\"]*:[^/\s'\"]+@"
)
"""Before a host; of ``ssh://git@host`` the name is no secret, a password is."""
_QUERY = pattern(
    r"([?&](?:[\w-]*(?:token|secret|passw(?:or)?d|signature|credential)|api[-_]?key|key|auth|sig)=)[^&\s'\"]+",
    re.IGNORECASE,
)
_VALUE = r"(?:'[^'\n]*'|\"[^\"\n]*\"|[^\s'\"]+)"
_OPTION = pattern(
    r"(--(?:\w+-)?passw(?:or)?d[= ]\s*|"
    r"\bcurl\b[^\n|;&]{0,200}?\s(?:-u\s*|--user[= ]\s*)(?=['\"]?[^\s:'\"]+:)|"
    r"\b(?:sshpass|docker\s+login)\b[^\n|;&]{0,200}?\s-p\s*|"
    r"\b(?:wandb|huggingface-cli)\s+login\s+(?:--\w+\s+){0,4}(?=[^\s-]{8})|"
    r"\b(?:authorization|private-token|x-api-key):\s*(?:\w+\s+)?(?=[^\s'\"]{4}))" + _VALUE,
    re.IGNORECASE,
)
"""What programs are given on their command line; ``docker run --user 1000:1000`` names nobody."""
_VARIABLE = pattern(r"\b([A-Z][A-Z0-9_]*(?:TOKEN|SECRET|PASSWORD|PASSWD|API_?KEY|ACCESS_KEY)=)(?![$<{(])" + _VALUE)
_TOKEN = pattern(r"\b(?:gh[pousr]_\w{20,}|github_pat_\w{20,}|glpat-[\w-]{20,}|hf_[A-Za-z0-9]{20,})")
"""https://github.blog/engineering/platform-security/behind-githubs-new-authentication-token-formats/,
https://docs.gitlab.com/security/tokens/ and https://huggingface.co/docs/hub/security-tokens, read 2026-11-27."""

_ADDRESS = pattern(r"\b((?:[a-z]+\+)?(?:https?|ftps?|ssh|git|svn)://)((?![^/\s]*\$[\w({])[^/\s'\"]+)@(?=([\w.-]+))")
"""The scheme, the login and the host of an address; what a variable stands for is in no file."""
_OF_SSH = ("ssh://", "+ssh://")


def redacted(text: str) -> str:
    """Return a text with ``***`` in place of each login, password and token."""
    if "://" in text:
        text = _LOGIN.sub(lambda match: f"{match[1] or match[2]}{HIDDEN}@", text)
        text = _QUERY.sub(rf"\1{HIDDEN}", text)
    for form in (_OPTION, _VARIABLE):
        text = form.sub(rf"\1{HIDDEN}", text)
    return _TOKEN.sub(HIDDEN, text)


def bare(text: str, public: Collection[str] = ()) -> str:
    """Return a text with addresses that have no password or token; those at ``public`` hosts have no user name either.

    Unlike a redacted one, such an address can be taken.
    """

    def kept(match: re.Match[str]) -> str:
        if match[1].endswith(_OF_SSH):
            return f"{match[1]}{match[2].partition(':')[0]}@"
        return match[1] if _secret(match[2]) or match[3] in public else match[0]

    return _ADDRESS.sub(kept, text) if "://" in text and "@" in text else text


def hosts_of_secrets(text: str) -> Iterator[str]:
    """Yield the host of each address with a password or a token."""
    yield from (match[3] for match in _ADDRESS.finditer(text) if _secret(match[2]))


def _secret(login: str) -> bool:
    return ":" in login or bool(_TOKEN.search(login))
