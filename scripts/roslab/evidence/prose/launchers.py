"""Programs that stop without the launcher that a page starts them with: ``torchrun --nproc_per_node=8 train.py``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
_LAUNCHER = pattern(
    r"(?<![\w./-])(?:torchrun|(?P<module>python[\d.]*[ \t]+-m[ \t]+torch\.distributed\.(?:launch|run))|"
    r"(?P<torchpack>torchpack[ \t]+dist-run))(?=[ \t])(?P<env>[^\n]*?[ \t]--use[_-]env\b)?"
)
_READ = pattern(r"\bos\.environ\[[\"'](?:LOCAL_RANK|RANK|WORLD_SIZE)[\"']\](?![ \t]*=[^=])")
"""https://docs.pytorch.org/docs/stable/elastic/run.html#environment-variables, read 2026-11-26."""
_JOINS = pattern(r"\binit_process_group\(([^()]{0,300}(?:\([^()]{0,100}\)[^()]{0,300}){0,5})\)")
"""The arguments of a call that joins the other processes; by default, what a launcher sets tells it where they are.
https://docs.pytorch.org/docs/stable/distributed.html#torch.distributed.init_process_group, read 2026-11-28."""
_OTHERWISE = pattern(r"\b(?:rank|store)[ \t]*=|\binit_method[ \t]*=[ \t]*(?![\"']env://)")
_ALONE = pattern(r"\blocal_rank\W{0,4}(?:[=!]=[ \t]*-1|>=[ \t]*0|<[ \t]*0|>[ \t]*-1)")
"""The file tells whether a launcher gave it the number of its process: it goes on without one."""
_GUARDED = pattern(r"\bin os\.environ\b|\bos\.environ\.setdefault\(|os\.environ\[[\"']\w*RANK[\"']\][ \t]*=[^=]")
"""The file does without them, or sets them itself."""
_TORCHPACK = pattern(r"^from torchpack import distributed\b|^import torchpack\.distributed\b", re.MULTILINE)
"""It reads MASTER_HOST, which its launcher alone sets: https://github.com/zhijian-liu/torchpack, read 2026-11-26."""
_IMPORT = pattern(r"^(?:from[ \t]+([\w.]+)[ \t]+import[ \t]+\(?([\w, \t]*)|import[ \t]+([\w.]+))", re.MULTILINE)


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield the launcher of each such command of a page, with one process, at the command's place."""
    texts = {page.path: page for page in pages(repository)}
    for mention in mentions:
        program = next((file for file in mention.files if file.endswith(".py")), "")
        if mention.topic != "command" or not program or mention.file not in texts:
            continue
        lines = text_of(repository, texts[mention.file]).split("\n")
        found = _LAUNCHER.search(lines[mention.line - 1]) if mention.line <= len(lines) else None
        if found is None:
            continue
        if found["torchpack"]:
            words, needed = "torchpack dist-run -np 1 python", _TORCHPACK.search(repository.read(program)) is not None
        else:
            env = " --use_env" if found["env"] else ""
            words = f"{' '.join(found['module'].split()) if found['module'] else 'torchrun'} --nproc_per_node=1{env}"
            needed = any(_reads(text) for text in _texts(program, repository))
        if needed:
            yield replace(mention, topic="launcher", text=words, files=(program,))


def _reads(text: str) -> bool:
    if _GUARDED.search(text):
        return False
    if _READ.search(text):
        return True
    joins = _JOINS.finditer(text) if "init_process_group(" in text and not _ALONE.search(text) else ()
    return any(not _OTHERWISE.search(match[1]) for match in joins)


def _texts(program: str, repository: Repository) -> Iterator[str]:
    """Yield a file of Python and what it imports of the tree, itself."""
    text = repository.read(program, limit=MAX_SIZE)
    yield text
    for match in _IMPORT.finditer(text):
        module = match[1] or match[3]
        names = [name.strip() for name in (match[2] or "").split(",")]
        paths = [module.replace(".", "/"), *(f"{module}.{name}".replace(".", "/") for name in names if name)]
        for start in dict.fromkeys(("", posixpath.dirname(program))):
            files = (posixpath.join(start, f"{path}.py") for path in paths)
            yield from (repository.read(file, limit=MAX_SIZE) for file in files if repository.has(file))
