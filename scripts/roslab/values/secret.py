"""The names under ``secrets`` in roslab.yaml that have a meaning of their own; any other is a file for the author."""

from __future__ import annotations

PIP_INDEX = "pip_index"
"""URL of a private index of Python packages with its user and password; several are separated by blanks.
https://pip.pypa.io/en/stable/cli/pip_install/#cmdoption-extra-index-url"""
NETRC = "netrc"
"""Text of a .netrc, by which git, pip and curl log in by https.
https://www.gnu.org/software/inetutils/manual/html_node/The-_002enetrc-file.html"""
SSH = "ssh"
"""A private key for git, or an agent that holds it. https://docs.docker.com/build/building/secrets/#ssh-mounts"""
APT_AUTH = "apt_auth"
"""Text of a file of apt's auth.conf.d. https://manpages.debian.org/apt_auth.conf"""


def variable(name: str) -> str:
    """Return the variable of the environment in which the value of a secret is expected."""
    return name.upper().replace("-", "_")
