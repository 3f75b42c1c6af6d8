"""Continuous integration files: what CI installs before it builds, and for which distributions.

Every value of a file is read as a possible command: install lines look the same for every CI service. A file that is
not YAML (a Jenkinsfile, a broken file) is searched line by line.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose import mentions
from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.merged import Prose, merge
from roslab.evidence.prose.other_branches import told
from roslab.evidence.prose.pages import pages
from roslab.knowledge.distros import ever
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from roslab.evidence.lex.yaml import Scalar

MAX_SIZE = 128 * 1024
_OTHER = pattern(
    r"(?:^|/)(?:.*(?:docs?|pages|release|publish|deploy|stale|label|lint|format|windows|macos?|osx|cla|"
    r"pre-commit|codeql).*)\.ya?ml$"
)
_PREFIX = pattern(
    r"^\s*(?:-\s+)?(?:(?:run|script|command|sh|bash|cmd|install|before_install|"
    r"before_script)\s*:\s*)?(?:-\s+)?[|>]?-?\s*"
)
_BRANCHES = pattern(r"branches|ref(?:_\w+)?")
"""A key whose value is a branch that the file builds."""
_WORD = pattern(r"[a-z]+")
_EXPRESSION = pattern(r"\$\{\{[^}\n]*\}\}")
_WITH_MATRIX = pattern(r"([\w.+-]{0,40})\$\{\{ {0,9}matrix\.([A-Za-z]\w*) {0,9}\}\}([\w.+-]{0,40})")
MAX_VALUES = 4
"""Most values of a matrix that are filled in."""
_IMAGE = pattern(
    r"^\s*(?:-\s*)?(?:image|container|docker_image|DOCKER_IMAGE|docker|box)\s*:\s*[\"']?([\w./-]+:[\w.${}-]+)",
    re.MULTILINE,
)
_DEBS = pattern(
    r"^\s*(?:-\s*)?(?:ADDITIONAL_DEBS|apt_packages|apt-packages|extra_packages|"
    r"packages)\s*[:=]\s*[\"']?([a-z][\w .+-]{2,})[\"']?\s*$",
    re.MULTILINE,
)
_TRAVIS_APT = pattern(r"^([ \t]*)packages:[ \t]*\n((?:\1[ \t]*-[ \t]*[\w.+-]+[ \t]*(?:\n|\Z))+)", re.MULTILINE)
_FOLDED = pattern(r"^([ \t]*)(?:-[ \t]+)?\w+:[ \t]*>-?[ \t]*\n((?:\1[ \t]+\S.*\n?)+)", re.MULTILINE)


def read(repository: Repository) -> Prose:
    """Return the install lines, container images and versions in CI files; release workflows are left out.

    So is what only builds other branches, each named after a distribution, where other files name one for this branch,
    or a page tells the branches apart.
    """
    found, others = repository.once(_all)
    return merge(prose for path, prose in found.items() if path not in others)


def files(repository: Repository) -> tuple[str, ...]:
    """Return the paths of the CI files that ``read`` reads."""
    found, others = repository.once(_all)
    return tuple(path for path in found if path not in others)


def of_others(repository: Repository) -> frozenset[str]:
    """Return the files that ``read`` leaves out because they only build other branches."""
    return repository.once(_all)[1]


def _all(repository: Repository) -> tuple[dict[str, Prose], frozenset[str]]:
    """Return what each file says, and which are only for other branches."""
    files = [file for file in (*repository.suffixed(".yml", ".yaml"), *repository.named("Jenkinsfile")) if _is_ci(file)]
    found: dict[str, Prose] = {}
    others: set[str] = set()
    for file in sorted(files, key=lambda file: file.path):
        if file.size < MAX_SIZE:
            from roslab.evidence.lex.yaml import scalars  # noqa: PLC0415 - many trees have no CI
            from roslab.evidence.prose.ci_hooks import hooks  # noqa: PLC0415 - many trees have no CI

            text = repository.read(file)
            values = None if file.path.endswith("Jenkinsfile") else scalars(text)
            found[file.path] = merge((_read(text, values, file.path), *hooks(repository, values or (), file.path)))
            if values and repository.branch and _for_others(values, repository.branch):
                others.add(file.path)
    own = any(mention.topic == "distro" for path in found.keys() - others for mention in found[path].mentions)
    own = own or (bool(others) and any(told(repository, page) for page in pages(repository)))
    return found, frozenset(others if own else ())


def _is_ci(file: File) -> bool:
    other = _OTHER.search(file.path.lower().rpartition("/")[2])
    return places.ci(file.path) and not (other or places.vendored(file.path))


def _read(text: str, values: tuple[Scalar, ...] | None, path: str) -> Prose:
    found = _by_lines(text, path) if values is None else _by_values(values, text, path)
    uncommented = re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)
    from roslab.evidence.prose.ci_wheels import without_runners  # noqa: PLC0415 - a tree without CI has none

    said = without_runners(mentions.read(uncommented, path, "ci"), uncommented, path)
    return replace(found, mentions=(*found.mentions, *said))


def _for_others(values: tuple[Scalar, ...], branch: str) -> bool:
    """Tell whether a file only builds other branches, each named after a distribution.

    Those are what it checks out (``ref: jazzy``, as reusable workflows are given it, too) and what starts it.
    """
    named = {value.text.strip() for value in values if _BRANCHES.fullmatch(value.key)} - {""}
    return bool(named) and branch not in named and all(ever() & set(_WORD.findall(name.lower())) for name in named)


def _by_values(values: tuple[Scalar, ...], text: str, path: str) -> Prose:
    """Read the values of a YAML file as shell, and those of some keys as package lists or images."""
    from roslab.evidence.prose.ci_conditions import titled  # noqa: PLC0415 - many trees have no CI
    from roslab.evidence.prose.ci_deploys import without_deploys  # noqa: PLC0415 - many trees have no CI
    from roslab.evidence.prose.ci_variables import filled  # noqa: PLC0415 - many trees have no CI
    from roslab.evidence.prose.taken_out import conditional, taken_out  # noqa: PLC0415 - many trees have no CI
    from roslab.evidence.prose.upstream import upstream  # noqa: PLC0415 - many trees have no CI

    collector = Collector(path, "ci")
    images = []
    for value in without_deploys(values, text, path):
        if value.key == "packages" and value.item:
            if re.fullmatch(r"[\w.+-]+", value.text):
                collector.logical(f"apt-get install {value.text}", value.line)
            continue
        shell = "\n".join(_matrix(line, text) for line in filled(value).split("\n"))
        collector.text(_known(shell), value.line)
        written = f"{value.key}: {value.text}"
        for match in _DEBS.finditer(value.text if "=" in value.text else written):
            if "cache-apt-pkgs" in text or value.key != "packages":
                collector.logical(f"apt-get install {match[1]}", value.line)
        if not value.item and (image := _IMAGE.match(written)):
            images.append(_image(image, path, value.line))
    found = collector.prose()
    sources = dict.fromkeys((*found.sources, *upstream(values, path)))
    said = (each for each in found.mentions if not conditional(each, text))
    return replace(
        found,
        dependencies=tuple(titled(found.dependencies, text)),
        mentions=(*said, *images, *taken_out(values, path)),
        sources=tuple(sources),
    )


def _by_lines(text: str, path: str) -> Prose:
    """Search a file that does not parse."""
    text = _FOLDED.sub(
        lambda match: match[0].split("\n", 1)[0] + "\n" + match[2].rstrip("\n").replace("\n", " \\\n") + "\n",
        text,
    )
    collector = Collector(path, "ci")
    collector.text(_known("\n".join(_matrix(_unquoted(_PREFIX.sub("", line)), text) for line in text.split("\n"))))
    for match in _DEBS.finditer(text):
        if "cache-apt-pkgs" in text or not match[0].lstrip().startswith("packages"):
            collector.logical(f"apt-get install {match[1]}", _line(text, match))
    for match in _TRAVIS_APT.finditer(text):
        for offset, line in enumerate(match[2].split("\n")):
            if line.strip():
                collector.logical(f"apt-get install {line.strip(' -')}", _line(text, match) + 1 + offset)
    found = collector.prose()
    images = (_image(match, path, _line(text, match)) for match in _IMAGE.finditer(text))
    return replace(found, mentions=(*found.mentions, *images))


def _known(shell: str) -> str:
    """Return shell text in which expressions of the CI service are unknown values, except that for the distribution."""
    return _EXPRESSION.sub(lambda match: match[0] if "distro" in match[0].lower() else "$UNKNOWN", shell)


def _image(match: re.Match[str], path: str, line: int) -> Mention:
    return Mention(topic="base", value=match[1], source="ci", file=path, line=line, text=match[0].strip())


def _unquoted(line: str) -> str:
    """Return a command without the quotes that YAML needs around a colon."""
    text = line.rstrip()
    quote = text[:1]
    inner = text[1:-1].replace(f"\\{quote}", "")
    if len(text) < 2 or quote not in {'"', "'"} or text[-1] != quote or quote in inner:
        return line
    return text[1:-1].replace(f"\\{quote}", quote)


def _matrix(line: str, text: str) -> str:
    """Fill ``lib${{ matrix.python }}-dev`` in an apt line with every value of the matrix."""
    if "${{" not in line or "apt" not in line:
        return line

    def written(match: re.Match[str]) -> str:
        before, key, after = match.groups()
        found = re.findall(rf"^[ \t]*(?:-[ \t]+)?{key}:[ \t]*[\"']?([a-z][\w.+-]*)[\"']?[ \t]*$", text, re.MULTILINE)
        values = list(dict.fromkeys(found))
        if not 0 < len(values) <= MAX_VALUES or before.endswith("ros-") or "distro" in key.lower():
            return match[0]
        return " ".join(f"{before}{value}{after}" for value in values)

    return _WITH_MATRIX.sub(written, line)


def _line(text: str, match: re.Match[str]) -> int:
    return text.count("\n", 0, match.start()) + 1
