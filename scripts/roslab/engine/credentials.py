"""Whether a registry accepts a password and allows a push, asked before an hour of building.

The dialogue is the distribution project's: https://distribution.github.io/distribution/spec/auth/token/
"""

from __future__ import annotations

import base64
import json
import re
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Mapping
from email.message import Message
from typing import Literal, Protocol
from urllib.parse import urlencode, urljoin, urlsplit

from roslab.engine.registry import PAUSE
from roslab.errors import BuildError, Problem
from roslab.values.dataclass import dataclass

Verdict = Literal["granted", "wrong password", "forbidden", "unreachable", "unknown"]
SECONDS = 20.0
ATTEMPTS = 4
LONGEST = 8 * 1024 * 1024
"""Characters of an answer that is read whole; registries take no manifest above 4 MiB."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Access:
    """The registry's answer."""

    verdict: Verdict
    detail: str = ""


@dataclass(frozen=True, kw_only=True, slots=True)
class Reply:
    """What a registry answered."""

    headers: Message
    body: str


class Session(Protocol):
    """Asks a registry about one image."""

    def __call__(self, method: str, path: str, accept: str = "") -> Reply | None:
        """Return its answer, ``None`` where there is no such thing.

        ``path`` is relative to the image, or begins at the host with a slash. Raises ``BuildError`` for a refusal.
        """


@dataclass(frozen=True, kw_only=True, slots=True)
class _Answer:
    status: int
    """0 if there was no answer."""
    headers: Message
    body: str


def may_push(image: str, username: str, password: str, *, pause: Callable[[float], None] = time.sleep) -> Access:
    """Ask whether an image may be pushed: start an upload, as every push does, and cancel it at once.

    ``image`` is ``HOST/PATH``. ``unknown`` means that the registry's answer was not understood: the push will tell.
    """
    url = _url(image)
    answer = _ask("GET", urljoin(url, "/v2/"), {}, pause)
    if answer.status == 0 or answer.status >= 500:
        return Access(verdict="unreachable", detail=answer.body or f"HTTP {answer.status}")
    secret = "Basic " + base64.b64encode(f"{username}:{password}".encode()).decode()
    headers, refused = _authorise(answer, image, secret, pause)
    if refused:
        return refused
    upload = _ask("POST", f"{url}/blobs/uploads/", headers, pause)
    if upload.status == 202:
        location = urljoin(url, upload.headers.get("Location") or "")
        if location != url and same_host(location, url):
            _ask("DELETE", location, headers, pause)
        return Access(verdict="granted")
    # There was a token, so the password is right: only the right to write is missing
    bearer = headers.get("Authorization", "").startswith("Bearer ")
    return _judged(upload, "forbidden" if bearer or upload.status == 403 else "wrong password")


def is_public(image: str, reference: str, *, pause: Callable[[float], None] = time.sleep) -> bool | None:
    """Tell whether anybody may pull a tag or digest, ``None`` if the registry does not say."""
    url = _url(image)
    headers, refused = _authorise(_ask("GET", urljoin(url, "/v2/"), {}, pause), image, None, pause)
    if refused:
        return False if refused.verdict == "wrong password" else None
    accept = "application/vnd.oci.image.index.v1+json, application/vnd.oci.image.manifest.v1+json"
    answer = _ask("HEAD", f"{url}/manifests/{reference}", {**headers, "Accept": accept}, pause)
    return True if answer.status == 200 else False if answer.status in (401, 403, 404) else None


def session(
    image: str, username: str, password: str, actions: str, *, pause: Callable[[float], None] = time.sleep
) -> Session:
    """Return what asks a registry about one image by a user's rights, ``actions`` such as ``pull,delete``.

    A token that ran out is renewed once. It raises ``BuildError`` where the registry does not answer or refuses.
    """
    url, held = _url(image), [dict[str, str]()]
    secret = "Basic " + base64.b64encode(f"{username}:{password}".encode()).decode() if password else None

    def renew() -> None:
        headers, refused = _authorise(
            _ask("GET", urljoin(url, "/v2/"), {}, pause), image, secret, pause, actions=actions
        )
        if refused:
            raise BuildError(
                Problem(
                    message=f"{image}: the registry gives no right to {actions}: {refused.detail or refused.verdict}"
                )
            )
        held[0] = headers

    def ask(method: str, path: str, accept: str = "") -> Reply | None:
        address = urljoin(url, path) if path.startswith("/") else f"{url}/{path}"
        for again in (True, False):
            answer = _ask(
                method, address, {**held[0], **({"Accept": accept} if accept else {})}, pause, longest=LONGEST
            )
            if answer.status != 401 or not again:
                break
            renew()
        if answer.status == 404:
            return None
        if not 200 <= answer.status < 300:
            said = _message(answer) if answer.status else answer.body
            raise BuildError(Problem(message=f"{image}: the registry refuses {method} {path}: {said}"))
        return Reply(headers=answer.headers, body=answer.body)

    renew()
    return ask


def _url(image: str) -> str:
    """Return the address of an image's part of the registry; docker uses plain HTTP only for this machine."""
    host, _, path = image.partition("/")
    name = host.partition(":")[0]
    scheme = "http" if name == "localhost" or name.startswith("127.") else "https"
    host = "registry-1.docker.io" if host in ("docker.io", "index.docker.io") else host
    return f"{scheme}://{host}/v2/{path}"


def _authorise(
    answer: _Answer, image: str, secret: str | None, pause: Callable[[float], None], *, actions: str = ""
) -> tuple[dict[str, str], Access | None]:
    """Return the headers that carry the right to push (or to pull, without a secret), or why there is none.

    ``actions`` names other rights than these: https://distribution.github.io/distribution/spec/auth/scope/
    """
    if answer.status == 200:
        return {}, None
    challenge = answer.headers.get("WWW-Authenticate", "")
    kind = challenge.partition(" ")[0].lower()
    fields = dict(re.findall(r'(\w+)="([^"]*)"', challenge))
    if kind == "basic":
        return ({"Authorization": secret}, None) if secret else ({}, Access(verdict="wrong password"))
    realm = fields.get("realm", "")
    if kind != "bearer" or not trusted(realm, _url(image)):
        return {}, Access(verdict="unknown", detail=f"HTTP {answer.status}, {kind or 'no'} authentication")
    scope = f"repository:{image.partition('/')[2]}:{actions or ('pull,push' if secret else 'pull')}"
    query = urlencode({"service": fields.get("service", ""), "scope": scope})
    token = _ask("GET", f"{realm}?{query}", {"Authorization": secret} if secret else {}, pause)
    if token.status != 200:
        return {}, _judged(token, "wrong password")
    try:
        data = json.loads(token.body)
        return {"Authorization": f"Bearer {data.get('token') or data['access_token']}"}, None
    except (ValueError, KeyError, AttributeError):
        return {}, Access(verdict="unknown", detail="the token server gave no token")


def trusted(realm: str, url: str) -> bool:
    """Tell whether the password of a registry at ``url`` may go to a token server.

    It is only sent by https; a registry on this machine, which has no https, may name itself.
    """
    return realm.startswith("https://") or (url.startswith("http://") and same_host(realm, url))


def same_host(address: str, url: str) -> bool:
    """Tell whether an address that a registry named has the registry's scheme, host and port."""
    asked, own = urlsplit(address), urlsplit(url)
    return (asked.scheme, asked.netloc) == (own.scheme, own.netloc)


def _judged(answer: _Answer, denial: Verdict) -> Access:
    """Interpret a refusal; ghcr.io's token server answers 403 where others answer 401."""
    if answer.status == 0 or answer.status >= 500:
        return Access(verdict="unreachable", detail=answer.body or f"HTTP {answer.status}")
    return Access(verdict=denial if answer.status in (401, 403) else "unknown", detail=_message(answer))


def _message(answer: _Answer) -> str:
    """Return the message in the registry's answer: https://distribution.github.io/distribution/spec/api/#errors."""
    try:
        errors = json.loads(answer.body)["errors"]
        return "; ".join(str(error.get("message") or error.get("code")) for error in errors)
    except (ValueError, KeyError, TypeError, AttributeError):
        return f"HTTP {answer.status}"


def _ask(
    method: str, url: str, headers: Mapping[str, str], pause: Callable[[float], None], *, longest: int = 65536
) -> _Answer:
    for attempt in range(1, ATTEMPTS + 1):
        answer = _ask_once(method, url, headers, longest)
        if attempt == ATTEMPTS or not (answer.status in (0, 429) or answer.status >= 500):
            break
        pause(PAUSE * 2 ** (attempt - 1))
    return answer


class _NoRedirect(urllib.request.HTTPRedirectHandler):
    """Refuse redirects, so that a header with a password goes nowhere else."""

    def redirect_request(self, *_: object) -> None:
        return None


def _said(error: OSError | ValueError) -> str:
    """Return an error's words, without its number."""
    reason = getattr(error, "reason", None) or error
    return str(getattr(reason, "strerror", None) or reason)


def _ask_once(method: str, url: str, headers: Mapping[str, str], longest: int) -> _Answer:
    request = urllib.request.Request(url, method=method, headers={"User-Agent": "roslab", **headers})  # noqa: S310
    if method == "POST":
        request.data = b""
    try:
        with urllib.request.build_opener(_NoRedirect).open(request, timeout=SECONDS) as reply:
            return _Answer(
                status=reply.status, headers=reply.headers, body=reply.read(longest).decode(errors="replace")
            )
    except urllib.error.HTTPError as error:
        with error:
            return _Answer(status=error.code, headers=error.headers, body=error.read(65536).decode(errors="replace"))
    except (OSError, ValueError) as error:
        return _Answer(status=0, headers=Message(), body=_said(error))
