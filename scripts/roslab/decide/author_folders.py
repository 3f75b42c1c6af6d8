"""Folders of the author's machine that files of the tree name: links in their places lead to what they mean."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import BuildTool, Config
from roslab.decide.cuda.toolkit_links import TOOLKIT, toolkit_links
from roslab.decide.decision import Choice, Warning_
from roslab.decide.reasons import because
from roslab.decide.ros.layout import Layout
from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.author_path import AuthorPath
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.launch_file import LaunchFile
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.origin import Place

LINKED = 40
"""Weight of the reason; nothing competes with it."""
MOST = 12
"""Most folders that links stand for."""
_MADE: dict[BuildTool, str] = {"catkin_make": "devel", "catkin_tools": "devel", "colcon": "install"}
_PLAIN = frozenset({"cmake", "pip", "conda", "none"})
"""Tools that build no packages of ROS."""
_LISTED = (".yaml", ".yml", ".launch", ".xml", ".xacro", ".urdf", ".rviz")
"""Files in which a path is no place that a program writes to."""


def decide_author_folders(
    evidence: Evidence, config: Config, packages: Packages, layout: Layout, build_tool: BuildTool, *, image: str
) -> Choice[tuple[tuple[str, str], ...]]:
    """Return the folders that links stand for: the author's, and those of releases of CUDA that the image has not."""
    choice = _of_author(evidence, config, packages, layout, build_tool)
    toolkits = () if config.compatible else tuple(toolkit_links(evidence, image))
    why = f"CMake names it, and the image has another release of CUDA: a link there leads to {TOOLKIT}"
    return replace(
        choice,
        answer=(*choice.answer, *((folder, TOOLKIT) for folder, _ in toolkits)),
        reasons=(*choice.reasons, *(because("workspace", f, why, said, weight=LINKED) for f, said in toolkits)),
    )


def _of_author(
    evidence: Evidence, config: Config, packages: Packages, layout: Layout, build_tool: BuildTool
) -> Choice[tuple[tuple[str, str], ...]]:
    """Return the author's folders, each with what a link there leads to: ``source/...`` or ``workspace/install``.

    Only those that files of packages name which are built, or scripts that start programs: the rest of a tree may be of
    another machine altogether.
    Of a tree without packages those of which it has all that a path names. ``~/NAME`` is a folder of the home: beside
    the repository's, for code that imports it by that name, or where files look for the author's workspace.
    """
    if layout.workspace == "none" and not config.compatible and (said := _imported(evidence)):
        why = "code imports it by this name from the folder above: a link of that name leads to the repository"
        reason = because("workspace", said.value, why, said, weight=LINKED)
        plain = _of_paths(evidence, config, packages, layout, build_tool)
        return Choice(answer=((f"~/{said.value}", "source"), *plain.answer), reasons=(reason, *plain.reasons))
    return _of_paths(evidence, config, packages, layout, build_tool)


def _imported(evidence: Evidence) -> Mention | None:
    return next((said for said in evidence.mentions if said.topic == "own_spelling"), None)


def _of_paths(
    evidence: Evidence, config: Config, packages: Packages, layout: Layout, build_tool: BuildTool
) -> Choice[tuple[tuple[str, str], ...]]:
    made = _MADE.get(build_tool) if layout.workspace != "none" else None
    mounted = tuple(_mounted(layout.mounted, made)) if made and not config.compatible else ()
    if config.compatible or (build_tool in _PLAIN and evidence.manifests) or not (evidence.author_paths or mounted):
        return Choice(answer=())
    built = tuple(each.file.rpartition("/")[0] for each in packages.built)
    inside = tuple(f"{folder}/" if folder else "" for folder in built)
    named = (p for p in evidence.author_paths if _by_script(p) or any(_holds(folder, p.file) for folder in inside))
    if not evidence.manifests:
        named = (p for p in evidence.author_paths if p.there and not places.aside(p.file))
    named = (p for p in named if not (mounted and f"{p.path}/".startswith(f"{layout.mounted}/")))
    found = [each for each in _folders(named) if not each.made or each.folder == made][:MOST]
    why = "a file names it, and the tree has what is meant: a link there leads to it"
    return Choice(
        answer=tuple(sorted((*((p.prefix, _target(p)) for p in found), *mounted))),
        reasons=tuple(
            because("workspace", p.prefix, why, Place(file=p.file, line=p.line), weight=LINKED) for p in found
        ),
    )


def absent_paths(
    evidence: Evidence,
    command: tuple[str, ...] | str,
    launch: LaunchFile | None,
    linked: Iterable[tuple[str, str]],
    programs: Iterable[tuple[str, str]],
) -> Iterator[Warning_]:
    """Yield a warning for each file that a launch file loads and that names what no link stands for.

    One for all code that the command starts: a program may do without, and one that asks for it first does.
    ``linked``: folders that links stand for, ``programs``: interpreters.
    """
    there = {path for path, _ in programs}
    folders = tuple(f"{folder}/" for folder, _ in linked)
    loaded = launch.loaded if launch else ()
    started = {*loaded, *_started(evidence, command, launch)} if evidence.author_paths else set()
    told: set[str] = set()
    in_code: list[AuthorPath] = []
    for each in evidence.author_paths:
        if each.path.startswith("~/"):
            continue  # below the home of whoever runs it a program may write
        lists = each.file.endswith(_LISTED) or (launch is not None and each.file == launch.file)
        if each.path in there or (f"{each.path}/".startswith(folders) and (each.there or not lists)):
            continue
        if lists and each.file in loaded and each.file not in told:
            told.add(each.file)
            yield Warning_(
                message=f"the default command loads {each.file}, which names {each.path}, a path of its author's "
                "computer: it is not in the image; write a path of the tree there, or mount what is meant",
                file=each.file,
                line=each.line,
            )
        elif not (lists or each.asked) and each.file in started:
            in_code.append(each)
    if in_code:
        first, more = in_code[0], len(in_code) - 1
        rest = f", and there {'is one' if more == 1 else f'are {more}'} more" if more else ""
        yield Warning_(
            message=f"the default command starts {first.file}, which names {first.path}, a path of its author's "
            f"computer{rest}: where that is read, it stops, for it is not in the image",
            file=first.file,
            line=first.line,
        )


def _mounted(above: str, made: str) -> Iterator[tuple[str, str]]:
    """Yield the links that make the author's workspace, as whose ``src`` the repository was mounted."""
    if above:
        yield f"{above}/src", "source"
        yield f"{above}/{made}", f"workspace/{made}"


def _by_script(path: AuthorPath) -> bool:
    """Tell whether a script that starts programs goes to what the tree has: it lies in a package or beside them."""
    return path.there and path.file.endswith(SHELL_SCRIPTS) and not places.aside(path.file)


def _holds(folder: str, file: str) -> bool:
    """Tell whether a file is of a package, but none of its tests and examples; the package itself may be called so."""
    return file.startswith(folder) and not places.aside(file[len(folder) :])


def _target(path: AuthorPath) -> str:
    return f"workspace/{path.folder}" if path.made else f"source/{path.folder}".rstrip("/")


def _folders(paths: Iterable[AuthorPath]) -> Iterator[AuthorPath]:
    """Yield the first of the paths for each folder of the author's, of two inside each other that which most name."""
    often: dict[tuple[bool, str, str], list[AuthorPath]] = {}
    for each in paths:
        if each.prefix:
            often.setdefault((each.made, each.prefix, each.folder), []).append(each)
    kept: list[str] = []
    for (_, prefix, _), same in sorted(often.items(), key=lambda item: (item[0][0], -len(item[1]), item[0])):
        if not any(f"{prefix}/".startswith(f"{each}/") or f"{each}/".startswith(f"{prefix}/") for each in kept):
            kept.append(prefix)
            yield same[0]


def _started(evidence: Evidence, command: tuple[str, ...] | str, launch: LaunchFile | None) -> Iterator[str]:
    """Yield the files of code, of those that name a path, which a command names or which are called like its nodes."""
    of_package = {each.name: each.file.rpartition("/")[0] for each in evidence.manifests if each.name}
    words = () if isinstance(command, str) else command[1:] if command[:1] == ("rosrun",) else command[2:]
    nodes = launch.nodes if launch else (words[:2],)
    yield from () if launch or isinstance(command, str) else command
    for package, program in (node for node in nodes if len(node) == 2):
        folder = of_package.get(package)
        for each in evidence.author_paths if folder is not None else ():
            name = each.file.rpartition("/")[2].rpartition(".")[0]
            if name == program.removesuffix(".py") and each.file.startswith(f"{folder}/" if folder else ""):
                yield each.file
