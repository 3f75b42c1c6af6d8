"""Whether a failed build is the source's fault, or the network's, a server's or the machine's."""

from __future__ import annotations

import socket
from collections.abc import Mapping

from roslab.explain.answer import Answer
from roslab.knowledge.failures import of_machine

Environment = Mapping[str, str]


def by_machine(answer: Answer, environment: Environment) -> bool:
    """Tell whether every failed step failed by the network, a server or the machine.

    A host whose name nobody knows while GitHub's is known is gone, and that is the source's.
    """
    known = of_machine()
    return bool(answer.explanations) and all(
        each.id in known and not (each.id == "host-unknown" and _gone(dict(each.names).get("host", ""), environment))
        for each in answer.explanations
    )


def _gone(host: str, environment: Environment) -> bool:
    """Tell whether a host's name is known to nobody, as far as this machine can tell."""
    api = (environment.get("GITHUB_API_URL") or "https://api.github.com").partition("://")[2].partition("/")[0]
    try:
        socket.getaddrinfo(api.partition(":")[0], None)
    except OSError:
        return False
    try:
        socket.getaddrinfo(host.partition(":")[0], None)
    except socket.gaierror as error:
        return bool(host) and error.errno == socket.EAI_NONAME
    except (OSError, ValueError):
        return False
    return False
