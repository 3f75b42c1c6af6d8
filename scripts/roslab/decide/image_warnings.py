"""What is told of the author's Dockerfile that is built: steps that may stop, and what its image lacks."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.values.origin import Place


def empty_folders(authored: AuthorDockerfile) -> tuple[Warning_, ...]:
    """Return a warning where the steps of a Dockerfile name submodules that are not checked out: its build stops."""
    if not authored.enters:
        return ()
    names, (_, line) = ", ".join(name for name, _ in authored.enters), authored.enters[0]
    message = f"the build of the author's Dockerfile stops here: nothing is in {names} until it is checked out"
    return (warn(f"{message}; git submodule update --init --recursive", Place(file=authored.file, line=line)),)


def unbounded_jobs(authored: AuthorDockerfile, evidence: Evidence) -> tuple[Warning_, ...]:
    """Return a warning for each step that starts all compilers at once, which may need more memory than there is."""
    return tuple(
        warn(
            f"“{each.text}” of the author's Dockerfile starts every compiler at once, for -j has no number: where "
            "memory runs out, the build stops here, and no variable bounds it; write -j$(nproc), or -j2",
            each,
        )
        for each in evidence.mentions
        if each.topic == "unbounded" and each.inside == authored.file
    )


def without_source(authored: AuthorDockerfile) -> tuple[Warning_, ...]:
    """Return a warning where a Dockerfile that roslab.yaml names copies nothing of the repository into its image."""
    if authored.copies_repository or authored.clones_itself or authored.copied:
        return ()
    message = (
        f"{authored.file} copies nothing of the repository: what its image is to run from there only docker run -v "
        "can give it; add COPY . to the folder that is mounted, or leave `dockerfile` out of roslab.yaml"
    )
    return (warn(message, Place(file=authored.file, line=authored.base_line)),)


def without_use(config: Config) -> tuple[Warning_, ...]:
    """Return a warning for each key that is for an author's Dockerfile, where one is generated."""
    given = {"args": config.args, "context": config.context, "target": config.target}
    return tuple(
        warn(
            f"`{key}` is for a Dockerfile of your own and has no effect: one is generated here "
            "(`roslab inspect --explain dockerfile` says why)",
            config.origin(key),
        )
        for key, value in given.items()
        if value
    )
