"""Paths of the author's machine in code, CMake, launch files, parameters and worlds, and what of the tree they mean."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable

from roslab.evidence import places
from roslab.evidence.author_path import AuthorPath
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.repository.checkout import Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.home import HOME
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 2_000
"""Most files that are opened, those nearest to the root first."""
MOST = 20
"""Most paths of one file."""
_XML = (".launch", ".xml", ".xacro", ".urdf", ".world", ".sdf")
_CODE = (".cpp", ".cc", ".cxx", ".h", ".hpp")
_SUFFIXES = (*_XML, *_CODE, *SHELL_SCRIPTS, ".py", ".yaml", ".yml", ".rviz")
_HINTS = (pattern(r"/(?:(?:home|Users|root|src)/|(?<=_ws/))"), pattern(r":\\\\?Users"))
"""What a file with such a path has. Each begins with a sign of its own, which is looked for once for all words."""
_PATH = pattern(
    r"(?:(?<=file://)|(?<![\w.}$)~/\\*-]))/(?:[\w.+@-]+/){2,30}[\w.+@-]*|\b[A-Z]:\\{1,2}Users\\{1,2}[\w.\\-]+"
)
_AT_HOME = pattern(
    r"(?:(?:(?<![\w./~$\\-])~|\$HOME|\$\{HOME\}|\$\((?:opt)?env\s{1,9}HOME\))/"
    r"|\bHOME[\"']\s?\]?\){0,3}\s{0,9}[,+]\s{0,9}[\"']/?|\bPath\.home\(\)\s{0,9}/\s{0,9}[\"'])"
    r"((?:[\w.+@-]+/){2,30}[\w.+@-]*)"
)
"""A path below the home of whoever runs it, as a shell, a launch file or code writes it."""
_STARTS = pattern(r"^[^\n#]{0,200}\b(?:ros2[ \t]{1,9}(?:launch|run)|roslaunch|rosrun)[ \t]", re.MULTILINE)
_SETS_UP = pattern(
    r"^[^\n#]{0,200}\b(?:(?:apt|apt-get|git|catkin|colcon|rosdep)[ \t]{1,9}(?:-\S{1,20}[ \t]{1,9}){0,3}"
    r"(?:install|clone|pull|build|update)|catkin_make)\b",
    re.MULTILINE,
)
"""A script that also installs, fetches or builds is for the author's machine: the image has done that."""
_HOMES = ("~/", "HOME", "Path.home()")
"""What each of these has."""
_ANYBODY = "/home/~/"
"""What stands for that home while a path is looked at."""
_HOME = pattern(r"/(?:home|Users)/[A-Za-z][\w.-]*/.|/root/.|[A-Z]:\\")
_BUILT = pattern(r"(/.+)/(install|devel)/(?:[\w-]+/)?(?:share|lib)/([\w-]+)/.+")
_SETUP = pattern(r"(/.+)/(install|devel)/(?:local_)?setup\.(?:ba|z)?sh")
_NAMED = pattern(r"^[ \t]*(\w+)[ \t]*(?::[ \t]*\w+[ \t]*)?=[ \t]*(?:\w+\()?[rRfF]?[\"']$")
"""What stands before a path that gets a name."""
_IF = (
    r"\b(?:el)?if[ \t]+(?:(?:os\.)?(?:path\.)?(?:exists|isdir|isfile)\([ \t]*{0}[ \t]*\)|"
    r"{0}\.(?:exists|is_dir|is_file)\(\))[ \t]*:"
)
_MADE = pattern(r"(?:^|/)(?:build|devel|install|log)/")
_SYSTEM = frozenset(
    ("bin", "boot", "dev", "etc", "lib", "lib32", "lib64", "proc", "root", "run", "sbin", "snap", "sys", "tmp", "usr"),
) | {"var", "Users"}
"""Folders at the top of the image that are its own, into which its user cannot look, or that no Linux has."""
_MOUNTED = frozenset(("content", "data", "dataset", "datasets", "workspace"))
"""Folders at the top that users mount, or that a service has, rather than of one author."""
_KEPT = (f"{HOME}/", "/opt/ros/", "/opt/conda/")
"""Folders of the image, which are never the author's."""
_OF_ALL = frozenset(("home", "media", "mnt", "opt", "srv"))
"""Folders at the top in which others of the author's may lie, while they are no author's themselves."""


def read(repository: Repository, packages: Iterable[tuple[str, str]]) -> tuple[AuthorPath, ...]:
    """Return the paths below somebody's home, and others that mean what is in the tree; each once for a file.

    ``packages``: the name and the folder of each. What stands in a comment is none. One below the home of whoever runs
    it begins with ``~``.
    """
    tree = _Tree(repository, tuple(packages))
    found: dict[tuple[str, str], AuthorPath] = {}
    code = (*repository.suffixed(*_SUFFIXES), *repository.named("CMakeLists.txt"))
    files = (f for f in code if f.size <= MAX_SIZE and not places.vendored(f.path))
    for file in nearest(f for f in files if not _MADE.search(f.path))[:MAX_FILES]:
        text = repository.read(file)
        shell = file.path.endswith(SHELL_SCRIPTS)
        if not (any(hint.search(text) for hint in _HINTS) or (shell and "/setup." in text)):
            continue
        if shell and (not _STARTS.search(text) or _SETS_UP.search(text)):
            continue
        if file.path.endswith(_XML):
            text = without_xml_comments(text)
        here, sourced = 0, _sourced(text) if shell else ""
        for at, path in _written(text):
            if (file.path, path) in found or here >= MOST or path.startswith(_KEPT):
                continue
            if _commented(file.path, text, at):
                continue
            prefix, folder, made, there = tree.meant(path) or tree.of_setup(path, sourced) or ("", "", False, False)
            if prefix or (_HOME.match(path) and not path.startswith(_ANYBODY)):
                here += 1
                found[file.path, path] = AuthorPath(
                    path=_spelled(path),
                    file=file.path,
                    line=text.count("\n", 0, at) + 1,
                    prefix=_spelled(prefix),
                    folder=folder,
                    made=made,
                    there=there,
                    asked=file.path.endswith(".py") and _asked(text, at),
                )
    return tuple(found.values())


def _written(text: str) -> list[tuple[int, str]]:
    """Return the paths of a text with their places, those below the home of whoever runs it at the end."""
    homes = _AT_HOME.finditer(text) if any(home in text for home in _HOMES) else ()
    at_home = {match.end(): match for match in homes}
    paths = [(match.start(), match[0].rstrip(".")) for match in _PATH.finditer(text) if match.end() not in at_home]
    return paths + [(match.start(), _ANYBODY + match[1].rstrip(".")) for match in at_home.values()]


def _sourced(text: str) -> str:
    """Return the only setup file of a workspace that a script names, ``""`` for none or several: some are others'."""
    found = {path for _, path in _written(text) if _SETUP.fullmatch(path) and not path.startswith(_KEPT)}
    return found.pop() if len(found) == 1 else ""


def _spelled(path: str) -> str:
    return f"~/{path.removeprefix(_ANYBODY)}" if path.startswith(_ANYBODY) else path


def of_image(folder: str) -> bool:
    """Tell whether a folder is the image's own, or has a name that programs take for an option: none for a link."""
    parts = folder.strip("/").split("/")
    if parts[0] in _SYSTEM | {""} or any(part.startswith("-") or part in {".", ".."} for part in parts):
        return True
    return f"/{'/'.join(parts)}/".startswith(_KEPT) or (len(parts) == 1 and parts[0] in _OF_ALL)


def _asked(text: str, at: int) -> bool:
    """Tell whether code of Python asks whether the path at a place is there, and uses it only then."""
    named = _NAMED.match(text[text.rfind("\n", 0, at) + 1 : at])
    return bool(named and re.search(_IF.format(re.escape(named[1])), text))


def _commented(file: str, text: str, at: int) -> bool:
    before = text[text.rfind("\n", 0, at) + 1 : at]
    if file.endswith(_CODE):
        return "//" in before.replace("://", "") or before.lstrip().startswith(("*", "/*"))
    return "#" in before and not file.endswith(_XML)


class _Tree:
    """The files and folders of a tree by their names, and its packages."""

    def __init__(self, repository: Repository, packages: tuple[tuple[str, str], ...]) -> None:
        self.repository, self.packages = repository, {name for name, _ in packages}
        self.names = {repository.name, repository.folder_name}
        self.names |= {name for name, folder in packages if not folder}
        self.inside = {folder for _, folder in packages if folder}
        self.by_name: dict[str, list[str]] | None = None

    def meant(self, path: str) -> tuple[str, str, bool, bool] | None:
        """Return the author's folder, the tree's, whether a build writes it, and whether all of the path is there."""
        parts = path.strip("/").split("/")
        if parts[0] in _SYSTEM or "\\" in path or f"{path}/".startswith(_KEPT) or {".", ".."} & {*parts}:
            return None
        built = _BUILT.fullmatch(path)
        if built:
            known = built[3] in self.packages and len(_short(built[1])) == 0
            return (f"{built[1]}/{built[2]}", built[2], True, True) if known else None
        if found := self._found(parts):
            return (*found, False, True) if self._of_author(found[0]) else None
        found = self._found(parts[:-1])
        return (*found, False, False) if found and self._of_author(found[0]) else None

    def of_setup(self, path: str, sourced: str) -> tuple[str, str, bool, bool] | None:
        """Return the same of the one setup file that a script sources: the author built the tree's packages there.

        Not of one below a folder of the image's own.
        """
        setup = _SETUP.fullmatch(path) if path == sourced and self.packages else None
        if setup is None or _short(setup[1]) or of_image(f"{setup[1]}/{setup[2]}"):
            return None
        return f"{setup[1]}/{setup[2]}", setup[2], True, True

    def _of_author(self, folder: str) -> bool:
        """Tell whether a folder may be one author's: where the tree has no packages, none at the top of a machine."""
        first, *below = folder.strip("/").split("/")
        return bool(self.packages or self.inside) or (bool(below) and first not in _MOUNTED)

    def _found(self, parts: list[str]) -> tuple[str, str] | None:
        """Return the author's folder and the tree's for what only one file or folder of the tree ends like."""
        nested = any(folder.rpartition("/")[2] == parts[-1] for folder in self.inside)
        if len(parts) > 1 and parts[-1] in self.names and parts[-2] == "src" and not nested:
            return f"/{'/'.join(parts)}", ""
        best, means = -1, set[str]()
        for path in self._named(parts[-1]):
            has = path.split("/")
            same = next(
                (n for n, (a, b) in enumerate(zip(reversed(parts), reversed(has), strict=False)) if a != b), len(has)
            )
            same = min(same, len(parts))
            if same >= best and self._whole(path, has, parts, same):
                means = means if same == best else set()
                best = same
                means.add("/".join(has[: len(has) - same]))
        if len(means) != 1:
            return None
        (folder,) = means
        head, tail = parts[: len(parts) - best], parts[len(parts) - best :]
        while tail and _short("/" + "/".join(head)):
            head.append(tail[0])
            folder = f"{folder}/{tail.pop(0)}".lstrip("/")
        return (f"/{'/'.join(head)}", folder) if tail or folder in self.repository.folders else None

    def _whole(self, path: str, has: list[str], parts: list[str], same: int) -> bool:
        """Tell whether the end that both have holds the folder of a package, and one thing more or what is known."""
        before = parts[len(parts) - same - 1] if len(parts) > same else ""
        above = [folder for folder in self.inside if f"{path}/".startswith(f"{folder}/")]
        if above:
            package = max(above, key=len)
            return len(has) - same <= package.count("/") and (same > 1 or before == "src" or before in self.names)
        if same < len(has):
            return False  # of no package, and not from the root
        two = parts[len(parts) - same - 2] if len(parts) > same + 1 else ""
        return before in self.names or (same > 1 and (two == "src" or self._alone(path)))

    def _alone(self, path: str) -> bool:
        """Tell whether a path is a file of a tree without packages: its last two parts are known well enough."""
        return not self.inside and not self.packages and self.repository.has(path)

    def _named(self, name: str) -> Collection[str]:
        if self.by_name is None:
            self.by_name = {}
            for folder in self.repository.folders:
                if folder and not _MADE.search(f"{folder}/"):
                    self.by_name.setdefault(folder.rpartition("/")[2], []).append(folder)
        files = (each.path for each in self.repository.named(name) if not _MADE.search(each.path))
        return (*files, *self.by_name.get(name, ()))


def _short(folder: str) -> str:
    """Return a folder that is too near to the top for a link to take its place: somebody's home, the root."""
    depth = folder.strip("/").count("/") + 1 if folder.strip("/") else 0
    least = 3 if f"{folder}/".startswith(("/home/", "/media/", "/mnt/")) else 2 if folder in {"/opt", "/srv"} else 1
    return folder if depth < least else ""
