"""Install scripts: the apt, pip and clone lines of the author's shell scripts."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.fixtures import of_tests
from roslab.evidence.lex.shell import fill_placeholders
from roslab.evidence.prose import author_dockerfile, here_lists, package_lists
from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.merged import Prose, merge
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.prose.release_branches import headed
from roslab.knowledge.distros import ever
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

MAX_SIZE = 128 * 1024
MAX_SCRIPTS = 400
_NAME = pattern(
    r"install|setup|dep(?:s|end)|require|bootstrap|prepare|build|provision|prereq|environment|docker|ci|"
    r"catkin|apt|init|configure|compile|make|third"
)
_ROBOT = pattern(r"jetson|tegra|raspberry|nvidia[-_]?driver|udev|kernel|windows|macos?|osx|homebrew|uninstall")
_ENGINES = r"(?:docker|podman|singularity|apptainer|nvidia[-_]?(?:docker|container)\w*)"
_ENGINE = pattern(rf"(?:install|setup|get|build)[-_]?{_ENGINES}[\w.-]*|{_ENGINES}[-_](?:install|setup)[\w.-]*")
"""The name of a script that installs what runs containers."""
_BRINGS_ENGINE = pattern(
    r"docker-(?:ce|engine)\b|docker\.io\b|get\.docker\.com|nvidia-(?:docker|container)|podman|"
    r"singularity(?:-ce)?[-/]|(?:sylabs|hpcng|apptainer)/(?:singularity|apptainer)|install[^\n]*\bapptainer\b"
)
_LIST = pattern(
    r"^(?:apt|debian|ubuntu|system|os)?[-_]?(?:additional[-_]?)?(?:apt|debs?|packages|"
    r"dependencies)(?:[-_]?(?:packages|requirements|dependencies|list|deps))?\.txt$"
)
_SCRIPT = pattern(r"([\w+.-]+\.(?:sh|bash))\b")
_INSTALLERS = frozenset({"dpkg", "apt", "apt-get", "gdebi"})
_BESIDE = frozenset({"cd", "echo", "set", "rm", "wget", "curl", "exit"})
"""What a script that only installs packages calls besides."""
MAX_INSTALLER = 4 * 1024
_INSTALLS = pattern(
    r"^[ \t]*(?:sudo[ \t]+)?(?:(?:apt|apt-get)[ \t]+(?:-\S+[ \t]+){0,3}install|pip[23]?[ \t]+install)[ \t]",
    re.MULTILINE,
)
"""A line that installs packages."""
_RUNNING = frozenset({"RUN", "ENTRYPOINT", "CMD"})
_TOLD = ("install", "clone", "cmake", "docker", "catkin", "colcon", "dpkg")
"""What stands in every script that is read."""
_KEPT = frozenset({"build_tool", "compiled", "step", "image_built", "image_pulled", "own_package"})
"""What is believed of a script that nobody may run."""
_ASSIGNED = pattern(
    r"^[ \t]*(?:export[ \t]+|readonly[ \t]+|local[ \t]+)?([A-Za-z_]\w*)=(\"[^\"`]*\"|'[^'$`]*'|[\w./:${}~-]+)",
    re.MULTILINE,
)
_HOME = pattern(r"\$HOME\b|\$\{HOME\}")
_USED = pattern(r"\$\{?(\w+)\}?")
_ROS = pattern(r"ros-([a-z]+)-")


def read(repository: Repository) -> Prose:
    """Return the install lines of shell scripts and of plain lists of system packages, and what scripts compile."""
    parts: list[Prose] = []
    by_images = _run_by_images(repository)
    shells = [
        file
        for file in repository.suffixed(".sh", ".bash", "")
        if (file.name.endswith(("sh",)) or "install" in file.name.lower())
        and (
            file.name in by_images
            or _NAME.search(file.path.lower())
            or _installs_packages(repository, file)
            or _installs_first(repository, file)
        )
        and not _ROBOT.search(file.path.lower())
        and not places.vendored(file.path)
        and not of_tests(repository, file.path)
        and file.size < MAX_SIZE
        and (file.name in by_images or not _of_host(repository, file))
    ]
    given = _given(repository)
    for file in nearest(shells)[:MAX_SCRIPTS]:
        text = repository.read(file)
        if any(word in text for word in _TOLD):
            from roslab.evidence.prose.cloners import spelled_out  # noqa: PLC0415 - few scripts install

            collector = Collector(file.path, "script")
            _assignments(text, collector)
            collector.text(spelled_out(here_lists.spelled_out(text)))
            found = collector.prose()
            found = replace(
                found,
                requirements=_of_one_branch(found.requirements, text),
                dependencies=headed(found.dependencies, text),
            )
            kept = (*(m for m in found.mentions if m.topic in _KEPT), *_distros(found.dependencies))
            if file.path.count("/") <= 1:
                from roslab.evidence.prose import only_on  # noqa: PLC0415 - few scripts install

                kept = (*kept, *only_on.read(text, file.path))
            parts.append(replace(found, mentions=kept))
        given += package_lists.given_to_apt(repository, text, file)
    lists = [
        file
        for file in repository.suffixed(".txt")
        if _LIST.match(file.name.lower())
        and not places.vendored(file.path)
        and file.size < MAX_SIZE
        and file.name.lower() not in {"packages.txt", "dependencies.txt"}
    ]
    parts += (package_lists.listed(repository.read(file), file.path) for file in dict.fromkeys((*lists, *given)))
    return merge(parts)


def _of_host(repository: Repository, file: File) -> bool:
    """Tell whether a script brings what runs containers to the machine that they run on: no container needs that."""
    return bool(_ENGINE.fullmatch(file.name.lower()) and _BRINGS_ENGINE.search(repository.read(file)))


def _run_by_images(repository: Repository) -> frozenset[str]:
    """Return the names of the shell scripts that a Dockerfile runs, or starts its containers with."""
    authored = [file for file in author_dockerfile.files(repository) if not places.vendored(file.path)]
    if not authored:
        return frozenset()
    from roslab.evidence.lex.dockerfile import instructions  # noqa: PLC0415 - most trees have no Dockerfile

    found = (each for file in authored for each in instructions(repository.read(file, limit=MAX_SIZE)))
    return frozenset(name for each in found if each.name in _RUNNING for name in _SCRIPT.findall(each.text))


def _installs_packages(repository: Repository, file: File) -> bool:
    """Tell whether a script, whatever its name, does no more than install packages by their files (``dpkg -i``)."""
    text = repository.read(file) if file.size < MAX_INSTALLER else ""
    if "dpkg" not in text:
        return False
    from roslab.evidence.lex.shell import commands, logical_lines  # noqa: PLC0415 - few scripts install such files

    called = {each.words[0] for start, line in logical_lines(text) for each in commands(line, start)}
    return called <= _INSTALLERS | _BESIDE and not called.isdisjoint(_INSTALLERS)


def _installs_first(repository: Repository, file: File) -> bool:
    """Tell whether a page at the root runs a script of the root, whatever its name, that installs what it starts."""
    if file.folder or not file.name.endswith(SHELL_SCRIPTS) or file.size >= MAX_INSTALLER:
        return False
    runs = re.compile(rf"(?:\./|\b(?:ba)?sh[ \t]+(?:\./)?){re.escape(file.name)}(?![\w.-])")
    said = (page for page in pages(repository) if not page.folder)
    return bool(_INSTALLS.search(repository.read(file))) and any(
        runs.search(text_of(repository, page)) for page in said
    )


def _given(repository: Repository) -> list[File]:
    """Return the lists that Dockerfiles and the pages at the root give to apt."""
    authored = (file for file in author_dockerfile.files(repository) if not places.vendored(file.path))
    authored = (file for file in authored if not (places.documentation(file.path) or _ROBOT.search(file.path.lower())))
    own = [(file, repository.read(file, limit=MAX_SIZE)) for file in authored]
    own += [(page, text_of(repository, page)) for page in pages(repository) if not page.folder]
    return [file for by, text in own for file in package_lists.given_to_apt(repository, text, by)]


def _distros(asked: tuple[Dependency, ...]) -> Iterator[Mention]:
    """Yield the distributions in names of packages: ``ros-melodic-tf``, each once; also one without an image."""
    named = {match[1]: each for each in reversed(asked) if (match := _ROS.match(each.name)) and match[1] in ever()}
    for name, each in named.items():
        yield Mention(topic="distro", value=name, source="script", file=each.file, line=each.line, text=each.name)


def _of_one_branch(asked: tuple[Requirement, ...], text: str) -> tuple[Requirement, ...]:
    """Keep of the branches of one ``if`` or ``case`` the first that installs a package: they are alternatives."""
    from roslab.evidence.lex.branches import branches  # noqa: PLC0415 - few scripts choose

    if len({each.key for each in asked}) == len(asked):
        return asked
    places = branches(text)
    first: dict[tuple[int, str], int] = {}
    kept = []
    for each in asked:
        block, branch = places.get(each.line or 0, (0, 0))
        if not block or not each.name or first.setdefault((block, each.key), branch) == branch:
            kept.append(each)
    return tuple(kept)


def _assignments(text: str, collector: Collector) -> None:
    """Pass the script's assignments to the collector: package lists are often kept in a variable."""
    known: dict[str, str] = {}
    for match in _ASSIGNED.finditer(fill_placeholders(text)):
        value = _USED.sub(lambda used: known.get(used[1], used[0]), _HOME.sub("~", match[2]))
        if "$" not in value:
            known[match[1]] = " ".join(value.strip("\"'()").replace("\\\n", " ").split())
    collector.variables = known
