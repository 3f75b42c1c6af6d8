"""A setup.py, read from its syntax tree: constants, lists and names are followed, nothing is run."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Collection
from functools import cache

from roslab.evidence.python import asked_history
from roslab.evidence.python.console_scripts import ENTRIES
from roslab.evidence.python.parsed import parsed
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

_FILE = pattern(r"^[\w./-]*(?:require|dep)[\w./-]*\.(?:txt|in)$", re.IGNORECASE)
_KEYS = {"install_requires": "", "requires": "", "tests_require": "test"}
_STRINGS = pattern(r"[\"']([A-Za-z][^\"'\n]*)[\"']")
_OPENERS = frozenset({"open", "io.open", "codecs.open"})
_MAKES = pattern(
    r"(?:shutil|subprocess)\.|os\.(?:system|popen|rename|replace|link|symlink)$|"
    r"(?:copy\w*|move|run|call|check_call|check_output|Popen|system)$|.*\.write_(?:text|bytes)$"
)
"""Calls that may make a file."""
MAX_DEPTH = 12
_THERE = sys.stdlib_module_names | {"setuptools", "distutils", "pkg_resources", "pip", "wheel", "__future__"}
"""Modules that every build has."""


@dataclass
class SetupScript:
    """The arguments of the call of ``setup``."""

    line: int = 1
    name: str | None = None
    version: str | None = None
    requires_python: str | None = None
    catkin: bool = False
    """It is called by catkin, not by people."""
    requirements: dict[str, tuple[list[str], list[str]]] = field(default_factory=dict)
    """Requirement lines and their files, by role; that of an extra is ``extra:NAME`` or ``extra:NAME:MARKER``."""
    build_requires: tuple[str, ...] = ()
    scripts: tuple[str, ...] = ()
    """Programs as they are written: ``run = planner.node:main``."""
    script_files: tuple[str, ...] = ()
    """Files that are installed as programs of the same names, as ``scripts`` lists them."""
    more_programs: bool = False
    """It may install others: it computes some, or has files for ``lib``, where ROS 2 keeps its programs."""
    packages: tuple[str, ...] = ()
    """The folders that it installs, where it names each of them and calls nothing that finds others."""
    classifiers: tuple[str, ...] = ()
    commands: tuple[str, ...] = ()
    """Commands of setuptools for which it has classes of its own."""
    imports: tuple[str, ...] = ()
    """Modules that it imports at the top, without those of the standard library."""
    opened: tuple[str, ...] = ()
    """Files that it reads in any case."""
    history: str = ""
    """The call of git for which the repository needs a commit, where it stops without one."""
    arguments: frozenset[str] = frozenset()
    """Names of the arguments of ``setup``; ``**`` for a dictionary that was not followed."""


@cache
def read(text: str) -> SetupScript:
    """Read a script, for all who ask for it, and none changes it; one for Python 2 is read by patterns."""
    script = SetupScript(catkin="catkin_pkg" in text or "generate_distutils_setup" in text)
    tree = parsed(text)
    if tree is None:
        return _by_pattern(text, script)
    names, functions, call = _bound(tree)
    if call is None:
        return script
    script.imports, script.opened, script.history = _imports(tree), _opened(tree), asked_history.asked(tree)
    keywords = {keyword.arg: keyword.value for keyword in call.keywords if keyword.arg}
    for keyword in call.keywords:
        if keyword.arg is None:
            keywords.update(_dictionary(keyword.value, names) or {"**": keyword.value})
    script.arguments = frozenset(keywords)
    reader = _Reader(names, functions)
    for key, role in _KEYS.items():
        if key in keywords:
            lines, files = script.requirements.setdefault(role, ([], []))
            lines += reader.strings(keywords[key])
            files += reader.files(keywords[key])
    for extra, value in _dictionary(keywords.get("extras_require"), names).items():
        script.requirements[f"extra:{extra}"] = (reader.strings(value), [])

    def given(key: str) -> list[str]:
        return reader.strings(keywords[key]) if key in keywords else []

    script.line = call.lineno
    script.name = next(iter(given("name")), None)
    script.version = next(iter(given("version")), None)
    script.requires_python = next(iter(given("python_requires")), None)
    script.build_requires = tuple(given("setup_requires"))
    script.classifiers = tuple(given("classifiers"))
    script.packages = () if _finds(keywords.get("packages"), names) else tuple(given("packages"))
    entries = _dictionary(keywords.get("entry_points"), names)
    script.scripts = tuple(line for kind in ENTRIES if kind in entries for line in reader.strings(entries[kind]))
    script.script_files = tuple(given("scripts"))
    script.more_programs = any(_finds(entries[kind], names) for kind in ENTRIES if kind in entries) or _fills_lib(tree)
    script.commands = tuple(_dictionary(keywords.get("cmdclass"), names))
    return script


def _finds(node: ast.expr | None, names: dict[str, ast.expr], depth: int = 0) -> bool:
    """Tell whether an expression calls something or is not written out, so that its strings are not all that it is."""
    if node is None or depth > MAX_DEPTH:
        return True
    unread = (ast.Call, ast.ListComp, ast.JoinedStr, ast.Attribute, ast.Subscript)
    return any(
        isinstance(part, unread)
        or (isinstance(part, (ast.List, ast.Tuple)) and any(isinstance(each, ast.BinOp) for each in part.elts))
        or (isinstance(part, ast.Name) and (part.id not in names or _finds(names[part.id], names, depth + 1)))
        for part in ast.walk(node)
    )


def _fills_lib(tree: ast.Module) -> bool:
    said = (node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, str))
    return any(text == "lib" or text.startswith("lib/") for text in said)


def _imports(tree: ast.Module) -> tuple[str, ...]:
    """Return the modules that the script always imports: not those in a function, a condition or a ``try``."""
    found: list[str] = []
    for node in tree.body:
        if isinstance(node, ast.Import):
            found += [alias.name.partition(".")[0] for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            found.append(node.module.partition(".")[0])
    return tuple(name for name in dict.fromkeys(found) if name not in _THERE)


def _opened(tree: ast.Module) -> tuple[str, ...]:
    """Return the files that a script reads in any case: not those in a function, a condition or a ``try``.

    Nor those after a line at the top that starts a program, copies, or calls a function of the script and may so make
    them.
    """
    own = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)} - asked_history.only_ask(tree)
    found: dict[str, None] = {}
    written: set[str] = set()
    made = False
    for statement in tree.body:
        if not isinstance(statement, (ast.FunctionDef, ast.ClassDef)):
            made = made or any(_makes(node, own) for node in ast.walk(statement) if isinstance(node, ast.Call))
        always = not made and isinstance(statement, (ast.With, ast.Assign, ast.Expr))
        for node in ast.walk(statement):
            if isinstance(node, ast.Call) and _opens(node) and node.args:
                name, mode = node.args[0], _mode(node)
                if not isinstance(name, ast.Constant) or not isinstance(name.value, str):
                    continue
                if mode.startswith("r"):
                    found |= {name.value: None} if always and not _guarded(statement) else {}
                else:
                    written.add(name.value)
    return tuple(name for name in found if name not in written)


def _opens(call: ast.Call) -> bool:
    return _called(call) == "open" and ast.unparse(call.func) in _OPENERS  # to write out every call takes long


def _makes(call: ast.Call, own: Collection[str]) -> bool:
    name = ast.unparse(call.func)
    return name in own or bool(_MAKES.match(name))


def _mode(call: ast.Call) -> str:
    given = [*call.args[1:2], *(each.value for each in call.keywords if each.arg == "mode")]
    return str(given[0].value) if given and isinstance(given[0], ast.Constant) else "r" if not given else ""


def _guarded(statement: ast.stmt) -> bool:
    return any(isinstance(node, (ast.If, ast.IfExp, ast.Try, ast.Lambda)) for node in ast.walk(statement))


Bound = tuple[dict[str, ast.expr], dict[str, ast.AST], "ast.Call | None"]


def _bound(tree: ast.AST) -> Bound:
    """Return the values bound to names, the functions, and the call of ``setup``."""
    names: dict[str, ast.expr] = {}
    functions: dict[str, ast.AST] = {}
    call: ast.Call | None = None
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign):
            names.update((target.id, node.value) for target in node.targets if isinstance(target, ast.Name))
        elif isinstance(node, ast.AugAssign):
            _extend(names, node.target, node.value)
        elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            functions[node.name] = node
        elif isinstance(node, ast.With):
            opened = ((item.optional_vars, item.context_expr) for item in node.items)
            names.update((target.id, value) for target, value in opened if isinstance(target, ast.Name))
        elif isinstance(node, ast.Call) and _called(node) == "setup":
            call = node
        elif isinstance(node, ast.Call) and _called(node) in {"append", "extend"} and node.args:
            _extend(names, node.func.value if isinstance(node.func, ast.Attribute) else None, node.args[0])
    return names, functions, call


def _extend(names: dict[str, ast.expr], target: ast.AST | None, value: ast.expr) -> None:
    if isinstance(target, ast.Name) and target.id in names:
        names[target.id] = ast.BinOp(names[target.id], ast.Add(), value)


def _called(node: ast.Call) -> str:
    """Return the last part of the name that is called."""
    if isinstance(node.func, ast.Name):
        return node.func.id
    return node.func.attr if isinstance(node.func, ast.Attribute) else ""


def _dictionary(node: ast.expr | None, names: dict[str, ast.expr], depth: int = 0) -> dict[str, ast.expr]:
    if isinstance(node, ast.Name) and depth < MAX_DEPTH:
        return _dictionary(names.get(node.id), names, depth + 1)
    if isinstance(node, ast.Dict):
        return {
            key.value: value
            for key, value in zip(node.keys, node.values, strict=True)
            if isinstance(key, ast.Constant) and isinstance(key.value, str)
        }
    if isinstance(node, ast.Call) and _called(node) == "dict":
        return {keyword.arg: keyword.value for keyword in node.keywords if keyword.arg}
    return {}


class _Reader:
    """Follows names from an expression to the strings or the file that it stands for."""

    def __init__(self, names: dict[str, ast.expr], functions: dict[str, ast.AST]) -> None:
        self.names, self.functions = names, functions

    def strings(self, node: ast.expr, depth: int = 0) -> list[str]:  # noqa: PLR0911 - one kind of node each
        """Return the strings in a constant, list, tuple, sum, name, or the constant parts of an f-string."""
        if depth > MAX_DEPTH:
            return []
        if isinstance(node, ast.Constant):
            return (
                [line.strip() for line in node.value.splitlines() if line.strip()]
                if isinstance(node.value, str)
                else []
            )
        if isinstance(node, (ast.List, ast.Tuple, ast.Set)):
            return [text for element in node.elts for text in self.strings(element, depth + 1)]
        if isinstance(node, ast.Starred):
            return self.strings(node.value, depth + 1)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            return self.strings(node.left, depth + 1) + self.strings(node.right, depth + 1)
        if isinstance(node, ast.IfExp):
            return self.strings(node.body, depth + 1)
        if isinstance(node, ast.Name) and node.id in self.names:
            return self.strings(self.names[node.id], depth + 1)
        return []

    def files(self, node: ast.AST) -> list[str]:
        """Return the requirement files that an expression opens or passes to a helper."""
        found: list[str] = []
        seen: set[str] = set()
        pending = [node]
        while pending:
            node = pending.pop()
            if isinstance(node, (ast.List, ast.Tuple)):
                continue
            for part in ast.walk(node):
                if isinstance(part, ast.Constant) and isinstance(part.value, str) and _FILE.match(part.value):
                    found.append(part.value)
                elif isinstance(part, ast.Name) and part.id not in seen:
                    seen.add(part.id)
                    following = self.names.get(part.id) or self.functions.get(part.id)
                    if following is not None:
                        pending.append(following)
        return list(dict.fromkeys(found))


def _by_pattern(text: str, script: SetupScript) -> SetupScript:
    if match := re.search(r"install_requires\s*=\s*\[(.*?)\]", text, re.DOTALL):
        script.requirements[""] = (_STRINGS.findall(match[1]), [])
    if match := re.search(r"\bname\s*=\s*[\"']([\w.-]+)", text):
        script.name = match[1]
    return script
