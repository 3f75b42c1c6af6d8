"""Signing a published image: when it is possible, and the command that checks the signature.

https://docs.github.com/en/actions/concepts/security/artifact-attestations
"""

from __future__ import annotations

from roslab.github.event import Event

RIGHTS = "`id-token: write` and `attestations: write`"
FAILED = (
    "grant the calling job `attestations: write` beside `id-token: write`; if it has both, the log of the step that "
    "signs says why"
)


def unsigned(event: Event) -> str:
    """Return why an image is not signed, ``""`` if signing can be tried.

    For a private repository that is no enterprise's GitHub keeps no signature: trying would be an error at every push.
    """
    if event.proposed:
        return "a pull request's image is there to be tried, and its next commit replaces it"
    if not event.signing:
        return f"grant the calling job {RIGHTS}"
    if not event.public and not event.enterprise:
        return "GitHub signs for a private repository only if it belongs to an enterprise"
    return ""


def verification(image: str, digest: str, event: Event, signer: str) -> tuple[str, ...]:
    """Return the command that checks the signature, in groups of words that belong together.

    ``signer`` is the repository of the workflow that signed, ``""`` if that is not known. It must be named if the
    workflow is another repository's: https://cli.github.com/manual/gh_attestation_verify
    """
    words = ("gh attestation verify", f"oci://{image}@{digest}", f"--repo {event.repository}")
    other = signer and signer.lower() != event.repository.lower()
    return (*words, f"--signer-repo {signer}") if other else words
