"""The notebook that is meant where a page starts their server without one: "… and select `Planning.ipynb`"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from roslab.evidence.facts import Mention
from roslab.values.dataclass import replace

_SERVERS = ("jupyter notebook", "jupyter-notebook", "jupyter lab", "jupyter-lab")
_END = ".ipynb"


def with_notebooks(mentions: Iterable[Mention], pointed: Sequence[Mention]) -> Iterator[Mention]:
    """Yield the mentions, a bare ``jupyter notebook`` with the notebook that its section names nearest to it.

    ``pointed``: the files that the pages name in their sentences.
    """
    notebooks = [each for each in pointed if each.value.endswith(_END)]
    for mention in mentions:
        bare = notebooks and mention.topic == "command" and mention.value.startswith(_SERVERS)
        if not bare or mention.files or _END in mention.value:
            yield mention
            continue
        here = (each for each in notebooks if (each.file, each.heading) == (mention.file, mention.heading))
        near = [(abs(each.line - mention.line), each.value) for each in here]
        yield replace(mention, files=(min(near)[1],)) if near else mention
