"""What a container shares with its machine: the folders that Docker Compose mounts, the port that a page opens."""

from __future__ import annotations

from roslab.config.model import Config, Volume
from roslab.decide.candidate import Candidate
from roslab.evidence.facts import AuthorDockerfile, Evidence


def volumes_of(authored: AuthorDockerfile | None, config: Config) -> tuple[Volume, ...]:
    """Return the folders that Docker Compose mounts, without those for which roslab.yaml has another."""
    taken = {each.container_path for each in config.volume}
    mounted = authored.service.volumes if authored and authored.service else ()
    return tuple(Volume(host_path=h, container_path=c, options=o, made=True) for h, c, o in mounted if c not in taken)


def ports_of_page(page: Candidate, evidence: Evidence) -> tuple[str, ...]:
    """Return the port at which the section that runs a command has its reader open it, if that names only one.

    An address that the command is given is of another server.
    """
    said = (m for m in evidence.mentions if m.topic == "port" and (m.file, m.heading) == (page.file, page.heading))
    addresses = [word for word in page.argv if "://" in word]
    found = {m.value for m in said if not any(f":{m.value}" in word for word in addresses)}
    return tuple(f"{port}:{port}" for port in found) if len(found) == 1 else ()
