"""A code block of a README: is it shell that can run in the image, and which of its lines are typed, which are output?"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

SHELLS = frozenset(
    [
        "bash",
        "sh",
        "shell",
        "zsh",
        "ksh",
        "shellscript",
        "shell-script",
        "bash-script",
        "commandline",
        "command",
        "cmdline",
    ]
)
SESSIONS = frozenset(
    [
        "console",
        "terminal",
        "session",
        "shell-session",
        "shellsession",
        "bash-session",
        "sh-session",
        "bashsession",
        "tty",
    ]
)
"""Languages of a block that shows what was typed and what came back."""
HOST = frozenset(
    [
        "docker",
        "docker-compose",
        "podman",
        "nvidia-docker",
        "nvidia-docker2",
        "rocker",
        "apptainer",
        "singularity",
        "xhost",
        "roslab",
        "docker_build.sh",
        "docker_run.sh",
        "act",
        "gh",
        "minikube",
        "kubectl",
        "vagrant",
        "code",
        "firefox",
        "google-chrome",
        "brew",
        "choco",
        "winget",
    ]
)
"""Programs of the machine that the image runs on: a block that needs one cannot run in the image."""
INSTALLERS = frozenset(
    [
        "sudo",
        "su",
        "apt",
        "apt-get",
        "aptitude",
        "dpkg",
        "snap",
        "add-apt-repository",
        "apt-key",
        "systemctl",
        "service",
    ]
)
"""What only root does. The image's user is not root, and what the README installs is in the image."""
COMMANDS = (
    HOST
    | INSTALLERS
    | frozenset(
        [
            ".",
            "[",
            "ament",
            "ant",
            "autoreconf",
            "awk",
            "bash",
            "bazel",
            "bunzip2",
            "bzip2",
            "cargo",
            "cat",
            "catkin",
            "catkin_make",
            "catkin_make_isolated",
            "cd",
            "chmod",
            "clang",
            "clang++",
            "cmake",
            "colcon",
            "conda",
            "cp",
            "ctest",
            "curl",
            "cut",
            "date",
            "diff",
            "dot",
            "echo",
            "env",
            "eval",
            "evo_ape",
            "evo_traj",
            "export",
            "ffmpeg",
            "find",
            "for",
            "g++",
            "gazebo",
            "gcc",
            "gdb",
            "git",
            "gnuplot",
            "go",
            "grep",
            "gunzip",
            "gz",
            "gzip",
            "head",
            "if",
            "ign",
            "java",
            "jupyter",
            "ldd",
            "less",
            "ln",
            "ls",
            "make",
            "mamba",
            "micromamba",
            "mkdir",
            "mpirun",
            "mv",
            "nano",
            "ninja",
            "node",
            "npm",
            "nvcc",
            "nvidia-smi",
            "octave",
            "pip",
            "pip2",
            "pip3",
            "pipenv",
            "poetry",
            "printenv",
            "printf",
            "ps",
            "pushd",
            "popd",
            "pwd",
            "pytest",
            "python",
            "python2",
            "python3",
            "rm",
            "rmdir",
            "roscd",
            "roscore",
            "rosdep",
            "rosed",
            "rosbag",
            "roslaunch",
            "rosmsg",
            "rosnode",
            "rosparam",
            "rosrun",
            "rosservice",
            "rostopic",
            "rosversion",
            "rosws",
            "ros2",
            "rqt",
            "rqt_graph",
            "rsync",
            "rviz",
            "rviz2",
            "scp",
            "sed",
            "set",
            "setenv",
            "sh",
            "sleep",
            "source",
            "sort",
            "ssh",
            "tail",
            "tar",
            "tee",
            "test",
            "time",
            "tmux",
            "torchrun",
            "touch",
            "tree",
            "uniq",
            "unset",
            "unzip",
            "uv",
            "vcs",
            "vi",
            "vim",
            "virtualenv",
            "wc",
            "wget",
            "which",
            "while",
            "wstool",
            "xacro",
            "xargs",
            "yarn",
            "yes",
            "zip",
        ]
    )
)
"""First words by which a block without a language is known as shell. From the READMEs of robotics repositories."""
_LANGUAGE = re.compile(r"\{?\s*\.?([\w+#-]+)")
_PROMPT = re.compile(
    r"\s*(?:\([\w.-]+\)\s*)?"  # (venv)
    r"(?:\[?[\w.-]+@[\w.-]+(?:[: ]\s*[~/][^\s$#%>]*)?\]?\s?[$#%]|[~/][\w./~-]*\$|\$)"  # user@host:~/folder$
    r"(?:\s+(?=\S)|\s*$)"
)
_ROOT = re.compile(r"\s*#\s+(?=(\S+))")
_FIRST = re.compile(r"(?:^|&&|\|\||;|\|)\s*(?:(?:\w+=\S*|time|exec|nohup|env)\s+)*([^\s;&|]+)(?:\s+(\S+))?")
_NO_COMMAND = re.compile(r"[<>=~]+|v?\d+(?:\.\d+)+|[:=].*|is|are|and|or|version")
"""Second words of a list of requirements (``cmake >= 3.5``) or of prose."""
_OPEN = re.compile(r"(?:\\|&&|\|\|?|\{|\(|\b(?:do|then|else))\s*$")
_HEREDOC = re.compile(r"<<-?\s*(['\"]?)(\w+)\1")


@dataclass(frozen=True, kw_only=True, slots=True)
class Step:
    """A part of a block: what is typed (without prompts), or what came back."""

    typed: bool
    text: str


def steps(info: str, content: str) -> tuple[Step, ...]:
    """Return the parts of a block that can run in the image, ``()`` for one that is no shell or not for the image.

    ``info`` is what stands after the fence, ``""`` for an indented block. A block of which nothing but output can be
    told, and one that needs a program of the host, is left to the text.
    """
    match = _LANGUAGE.match(info.strip())
    language = match[1].lower() if match else ""
    if language and language not in SHELLS | SESSIONS:
        return ()
    lines = content.expandtabs(4).split("\n") if "\t$" in content else content.split("\n")
    prompt = _PROMPT
    if language in SESSIONS and not any(map(_PROMPT.match, lines)):
        prompt = _ROOT
    if any(_prompted(prompt, line) for line in lines):
        found = _transcript(lines, prompt)
    elif language in SHELLS or _all_commands(content):
        found = [Step(typed=True, text=content.strip("\n"))]
    else:
        return ()
    typed = [word for step in found if step.typed for word, _ in first_words(step.text)]
    if not typed or any(word in HOST for word in typed) or all(word in INSTALLERS for word in typed):
        return ()
    return tuple(found)


def _prompted(prompt: re.Pattern[str], line: str) -> re.Match[str] | None:
    match = prompt.match(line)
    return match if match and (prompt is not _ROOT or match[1] in COMMANDS) else None


def _transcript(lines: list[str], prompt: re.Pattern[str]) -> list[Step]:
    found: list[tuple[bool, list[str]]] = []

    def add(typed: bool, line: str) -> None:
        if not found or found[-1][0] != typed:
            found.append((typed, []))
        found[-1][1].append(line)

    for index, line in enumerate(lines):
        if match := _prompted(prompt, line):
            add(True, line[match.end() :])
        elif found and found[-1][0] and _unfinished("\n".join(found[-1][1])):
            add(True, line.removeprefix("> "))
        elif not line.strip():
            add(found[-1][0] if found else True, line)
        elif line.lstrip().startswith("#") and _typed_next(lines[index + 1 :], prompt):
            add(True, line)
        else:
            add(False, line)
    texts = [(typed, "\n".join(part).strip("\n")) for typed, part in found]
    return [Step(typed=typed, text=text) for typed, text in texts if text.strip()]


def _typed_next(lines: list[str], prompt: re.Pattern[str]) -> bool:
    following = next((line for line in lines if line.strip() and not line.lstrip().startswith("#")), "")
    return _prompted(prompt, following) is not None


def _unfinished(command: str) -> bool:
    """Tell whether a shell would ask for another line."""
    for match in _HEREDOC.finditer(command):
        if match[2] not in (line.strip() for line in command[match.end() :].split("\n")):
            return True
    last = command.rpartition("\n")[2]
    if _OPEN.search(last) and not last.endswith("\\\\"):
        return True
    bare = re.sub(r"\\.|#.*$", "", command, flags=re.MULTILINE)
    bare = re.sub(r"'[^']*'|\"[^\"]*\"", "", bare)
    return "'" in bare or '"' in bare


def first_words(text: str) -> Iterator[tuple[str, str]]:
    """Yield the first and the second word of each command, the first without its folder."""
    for line in re.sub(r"\\\n\s*", " ", text).split("\n"):
        if not line.lstrip().startswith("#"):
            for match in _FIRST.finditer(line):
                yield match[1].rpartition("/")[2] if match[1].endswith(".sh") else match[1], match[2] or ""


def _all_commands(content: str) -> bool:
    found = list(first_words(content))
    return bool(found) and all(
        (word in COMMANDS or re.match(r"\.{0,2}/\w|\w+=", word)) and not _NO_COMMAND.fullmatch(second)
        for word, second in found
    )
