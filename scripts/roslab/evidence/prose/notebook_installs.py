"""What the cells of notebooks install, where nothing else tells what their Python needs."""

from __future__ import annotations

from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.merged import Prose, merge
from roslab.evidence.python import notebooks
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_DECLARING = pattern(
    r"(?:setup\.py|setup\.cfg|pyproject\.toml|pixi\.toml|Pipfile|(?:requirements|environment|env)\b.*)"
)


def read(repository: Repository) -> Prose:
    """Return the packages that cells install by name, where the root has no other Python and no list of packages.

    Beside other code, a notebook is for a machine such as Colab's.

    Its options, its own folder and what it clones are left out: nobody runs its cells while the image is built.
    """
    found: list[Prose] = []
    if any(_DECLARING.fullmatch(file.name) for file in repository.listing.files if "/" not in file.path):
        return merge(found)
    for path in notebooks.alone(repository):
        collector = Collector(path, "script")
        for line, command in notebooks.installs(repository.read(path, limit=notebooks.MAX_SIZE)):
            collector.logical(command, line)
        said = collector.prose()
        named = tuple(each for each in said.requirements if each.name and not (each.role or each.url))
        found.append(Prose(dependencies=said.dependencies, requirements=named))
    return merge(found)
