"""Scripts of the shell, notebooks and tasks of pixi that a page starts."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping

from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose.octave import file_of
from roslab.knowledge.octave import OCTAVE
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

NOTEBOOK = ("jupyter", "notebook", "--ip=0.0.0.0", "--no-browser")
"""Reachable from outside of a container, which has no browser."""
LAB = ("jupyter", "lab", *NOTEBOOK[2:])
"""JupyterLab's, which takes the same options."""
PORT = "8888"
"""Where it listens: https://jupyter-server.readthedocs.io/en/latest/other/full-config.html, 2026-11-23"""
STREAMLIT = ("streamlit", "run")
"""It listens on every address, and asks nothing where there is no terminal."""
PORT_OF_STREAMLIT = "8501"
"""https://docs.streamlit.io/develop/api-reference/configuration/config.toml, read 2026-11-24"""
_VARIABLE = "…"
"""What stands in a command for a variable that the page does not set."""
RUNS = pattern(
    r"(?:run|demo|start|launch|play|exec\w*)(?:[_-]|(?:\.(?:ba)?sh)?$)|[\w-]{1,60}[_-](?:run|demo)\.(?:ba)?sh$",
    re.IGNORECASE,
)
"""The name of a script that starts something."""


def script_of(argv: tuple[str, ...], mention: Mention, ros: bool, compiled: bool) -> tuple[str, ...] | None:
    """Return the call of a shell script of the tree (``sh run.sh``), a notebook, a page of Streamlit, or Octave.

    A script that is given a variable of the reader's is none. One of compiled code has to be named like what starts
    something; a notebook is none of such code's, and none of a workspace's.
    """
    if argv[0].startswith("jupyter"):
        notebooks = [file for file in mention.files if file.endswith(".ipynb")]
        return (*NOTEBOOK, notebooks[0]) if notebooks and not (ros or compiled) else None
    if argv[:2] == STREAMLIT:
        return argv if not (ros or compiled) and {*argv[2:]} & {*mention.files} else None
    if argv[0] in OCTAVE:
        return None if ros or compiled or not file_of(mention) else argv
    script = argv[1:] if argv[0] in {"bash", "sh"} else argv
    known = bool(script) and script[0] in mention.files and (script[0].endswith(SHELL_SCRIPTS) or bare(script[0]))
    known = known and _VARIABLE not in mention.value  # without what that holds, it is another call
    known = known and (not compiled or bool(RUNS.match(posixpath.basename(script[0]))))
    return ("bash", *script) if known else None


def task_of(argv: tuple[str, ...], tasks: Mapping[str, str]) -> tuple[str, ...]:
    """Return what ``pixi run TASK`` starts, by the tasks' names; other commands as they are."""
    if argv[:2] != ("pixi", "run") or len(argv) < 3:
        return argv
    command = tasks.get(argv[2], "")
    words = command.split() if not re.search(r"[&|;$]", command) else []
    while words and re.fullmatch(r"\w+=\S*", words[0]):
        words = words[1:]
    return (*words, *argv[3:]) if words else argv


def bare(path: str) -> bool:
    """Tell whether the name of a file has no ending."""
    return "." not in posixpath.basename(path)


def ports_of(argv: tuple[str, ...]) -> tuple[str, ...]:
    """Return the port of the server that a command starts."""
    return (
        (PORT,) if argv[: len(NOTEBOOK)] in {NOTEBOOK, LAB} else (PORT_OF_STREAMLIT,) if argv[:2] == STREAMLIT else ()
    )


def ports_in(argv: tuple[str, ...], evidence: Evidence) -> tuple[str, ...]:
    """Return the ports on which the program of a command says in its code that it listens."""
    return tuple(dict.fromkeys(m.value for m in evidence.mentions if m.topic == "listens" and m.file in argv))
