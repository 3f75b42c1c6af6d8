"""The images that an author's containers run: Docker Compose files, and Dev Containers of editors.

https://docs.docker.com/reference/compose-file/services/#image, https://containers.dev/implementors/json_reference/
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose import mentions
from roslab.evidence.prose.merged import Prose
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_DEPTH = 2
FAMILY = 2
"""A file that names more distributions than this has one container for each: none of them is meant."""
_COMPOSE = pattern(r"(?:docker-)?compose(?:[-_.][\w.-]+)?\.ya?ml")
_KEY = pattern(r"image|(?:\w+_)?(?:distro|ros_version|variant|base_image|from_image)", re.IGNORECASE)
"""Keys of an image's name, and of what its Dockerfile is given."""
_COMMENT = pattern(r"(?:^|(?<=[\s,{}\[\]]))//[^\n]*$", re.MULTILINE)


def read(repository: Repository) -> Prose:
    """Return the versions that these files name, each as if the author's Dockerfile did."""
    found: list[Mention] = []
    for file in _files(repository):
        said = tuple(_named(repository.read(file), file))
        if len({mention.value for mention in said if mention.topic == "distro"}) <= FAMILY:
            found += said
    return Prose(mentions=tuple(dict.fromkeys(found)))


def _files(repository: Repository) -> Iterator[File]:
    files = [*repository.suffixed(".yml", ".yaml"), *repository.named("devcontainer.json", ".devcontainer.json")]
    for file in sorted(files, key=lambda file: file.path):
        of_compose = file.name.endswith(".json") or _COMPOSE.fullmatch(file.name.lower())
        near = file.size <= MAX_SIZE and file.path.count("/") <= MAX_DEPTH
        if of_compose and near and not (places.aside(file.path) or places.documentation(file.path)):
            yield file


def _named(text: str, file: File) -> Iterator[Mention]:
    from roslab.evidence.lex.yaml import scalars  # noqa: PLC0415 - few pages name one

    if file.name.endswith(".json"):
        yield from mentions.read(_COMMENT.sub("", text), file.path, "dockerfile")
        return
    for value in scalars(text) or ():
        if _KEY.fullmatch(value.key):
            line = f"{value.key}: {value.text}"
            for mention in mentions.read(line, file.path, "dockerfile"):
                yield replace(mention, line=value.line)
