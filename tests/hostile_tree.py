"""A tree written to attack whoever builds it, and what a runner would take for a command in a log.

It is written by code when a test wants it: nobody who checks this repository out gets its links.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import secrets
import stat
import sys
from html.parser import HTMLParser
from pathlib import Path

MARK = "FORGED"
"""What every forged command says, so that it is known from the program's own."""
BEACON = "beacon.example"
COMMANDS = (
    f"::error::{MARK}",
    f"::notice file=x,line=1::{MARK}",
    f"::set-output name=digest::{MARK}",
    f"::set-output name=push::{MARK}",
    f"::set-env name=PATH::{MARK}",
    f"::save-state name=tmpDir::{MARK}",
    f"::add-mask::{MARK}",
    f"::add-matcher::{MARK}",
    f"::stop-commands::{MARK}",
    f"text ##[error]{MARK}",
    f"text ##[set-output name=digest;]{MARK}",
    f"##[set-env name=PATH;]{MARK}",
    f"##[add-mask]{MARK}",
    f"##[command]{MARK}",
)
MARKUP = (
    "</code></pre></summary></details>",
    f"<script src=https://{BEACON}/a.js></script>",
    f"<img src=https://{BEACON}/a.png>",
    f"![beacon](https://{BEACON}/b.png)",
    f"[click](https://{BEACON}/c) <https://{BEACON}/d> www.{BEACON} https://{BEACON}/e",
    "| a | b |",
    "| --- | --- |",
    "```mermaid",
    f"graph TD; A-->{MARK}",
    "```",
    "`````",
    "~~~mermaid",
    "@everyone #1 $`x`$ $$x$$",
    "\x1b]0;title\x07\x1b[2J\x1b[31mred\r::error::" + MARK,
)
SHOUT = " ".join([*COMMANDS[:3], *MARKUP[:5], "`", "|"])
"""The same on one line, for values that can have but one."""
BRANCH = f"x%0A<img/src={BEACON}/f.png>$(touch${{IFS}}ran)`id`'\"&;#,{MARK}"
"""git allows it as the name of a branch."""
SUBJECT = f"{COMMANDS[0]} {MARKUP[2]}"
LINKS = (
    ".dockerignore", "Dockerfile.dockerignore", "docker_build.sh", "docker_run.sh", "README.ipynb", "plan.json", "run",
    "build.json", "job.json", "index.json", "published.json", "report-linux-amd64.json", "artifact", "artifacts",
    "dockerfile", "home", "reports", "summary.md", "screenshots", "config.json", ".docker", ".gitconfig", ".config",
    ".cache", "out", "roslab", "requirements.lock",
)  # fmt: skip
"""Names that a step of the action, or a command of the program, writes somewhere: here each leads out of the tree."""
PROGRAMS = (
    "scripts/__main__.py", "scripts/environment.py", "scripts/roslab/__init__.py", "yaml.py", "json.py", "pip.py",
    "venv.py", "ensurepip/__init__.py", "sitecustomize.py", "usercustomize.py", "conftest.py", "setup.py",
    "evil/scripts/__main__.py", "evil/scripts/environment.py",
)  # fmt: skip
"""Modules that Python would import in place of the program's, were the tree on its path."""
TOOLS = ("python3", "python", "docker", "git", "bash", "sh", "node", "git-lfs", "Xvfb")
DOCKERFILE = """\
FROM ubuntu:24.04
LABEL said="{shout}"
COPY Dockerfile main.sh says /source/
RUN cat /source/says; cat /source/says >&2
CMD ["sh", "/source/main.sh"]
"""
MODULES = (
    ("ext", "sub/ext", "ext::touch {ran}"),
    ("option", "sub/option", "--upload-pack=touch {ran}"),
    ("file", "sub/file", "file://{outside}/repository"),
    ("plain", "sub/plain", "{outside}/repository"),
    ("../../../outside", "sub/name", "http://127.0.0.1:9/x"),
    ("out", "../outside/file", "http://127.0.0.1:9/x"),
    ("-c core.fsmonitor=x", "sub/dash", "-u"),
    ("line", "sub/two\\nlines", "http://127.0.0.1:9/\\n::error::" + MARK + "\\n" + MARKUP[2]),
)
"""Name, path and address of submodules."""


def write(root: Path, outside: Path) -> None:
    """Write the tree to a folder, and beside it what its links lead to; ``outside/ran`` appears when its code runs."""
    ran = outside / "ran"
    (outside / "folder").mkdir(parents=True)
    for name in ("file", "folder/kept", ".bashrc"):
        (outside / name).write_text(f"{name} of somebody else\n")
    root.mkdir(exist_ok=True)
    # A number of this tree alone: a builder that knows the tree already would not run its Dockerfile again
    says = "\n".join([*COMMANDS, *MARKUP, SHOUT, secrets.token_hex(8), ""])
    quoted = json.dumps(SHOUT)
    python = f"open({str(ran)!r}, 'a').write(__file__)\nraise SystemExit(1)\n"
    texts = {
        "Dockerfile": DOCKERFILE.format(shout=SHOUT.replace('"', "").replace("$", "")),
        "Dockerfile.base": f"FROM ##[error]{MARK}\n",
        "Dockerfile.broken": DOCKERFILE.format(shout="x") + f"RUN echo {json.dumps(SHOUT).replace('`', '')} && false\n",
        "says": says,
        "main.sh": "cat /source/says\n",
        "fails.sh": "cat /source/says\nexit 1\n",
        "README.md": f"# {SHOUT}\n\n{says}\n\n```\nrosrun x {SHOUT}\n```\n",
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.10)\nproject(robot CXX)\n# {SHOUT}\n",
        "package.xml": f"<package><name>{MARKUP[2].replace('<', '&lt;')}{COMMANDS[0]}</name></package>\n",
        "requirements.txt": f"# {SHOUT}\nnumpy\n{COMMANDS[0]}\n",
        "roslab.yaml": _recipe("Dockerfile", f"cat /source/says; echo {SHOUT!r}"),
        "fails.yaml": _recipe("Dockerfile", "cat /source/says; exit 1"),
        "broken.yaml": _recipe("Dockerfile.broken", "true"),
        "base.yaml": _recipe("Dockerfile.base", "true"),
        "generated.yaml": f"format: 3\nkind: cpp\nbase: {{image: 'ubuntu:24.04'}}\ntest: {quoted}\n",
        "wrong.yaml": f"format: 3\nkind: {quoted}\napt: [{quoted}, 'a\tb']\nname: {quoted}\n{quoted}: {quoted}\n",
        ".lfsconfig": f'[lfs]\n\turl = file://{outside}\n[lfs "customtransfer.x"]\n\tpath = touch\n\targs = {ran}\n',
        ".gitattributes": "*.bin filter=lfs\n",
        f"{COMMANDS[0]}\n{COMMANDS[1]}.bin".replace("/", "-"): (
            f"version https://git-lfs.github.com/spec/v1\noid sha256:{'0' * 64}\nsize 5\n"
        ),
        ".github/matcher.json": json.dumps({"problemMatcher": [{"owner": "x", "pattern": [{"regexp": "(.*)"}]}]}),
        "bare/HEAD": "ref: refs/heads/main\n",
        "bare/config": f"[core]\n\tbare = true\n\tfsmonitor = touch {ran}\n[credential]\n\thelper = !touch {ran}\n",
        "bare/objects/info/none": "",
        "bare/refs/heads/none": "",
        **dict.fromkeys(PROGRAMS, python),
    }
    for command in COMMANDS:
        texts[f"names/{command}.launch".replace("/", "-").replace("names-", "names/", 1)] = (
            f"<launch>{SHOUT}</launch>\n"
        )
    for path, text in texts.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    for tool in TOOLS:
        (root / tool).write_text(f"#!/bin/sh\necho {tool} >> '{ran}'\nexit 1\n")
        (root / tool).chmod(0o755)
    targets = (outside / "file", outside / "folder", outside / "new", Path("../../../../../../../../etc/passwd"))
    for number, name in enumerate(LINKS):
        (root / name).symlink_to(targets[number % len(targets)])
    (root / ".repro-action").symlink_to("evil")
    (root / ".gitmodules").write_text(
        "".join(
            f'[submodule "{name}"]\n\tpath = "{path}"\n\turl = "{url.format(ran=ran, outside=outside)}"\n'
            for name, path, url in MODULES
        )
    )


def _recipe(dockerfile: str, test: str) -> str:
    values = {"A": SHOUT.replace('"', ""), "B": "<b>x</b>", "C": "a # b, c=d"}
    said = {"format": 3, "kind": "cpp", "dockerfile": dockerfile, "args": values, "test": test}
    return json.dumps(said) + "\n"


def gitlinks() -> tuple[tuple[str, ...], ...]:
    """Return git's commands that add the submodules to the index; a path out of the tree git refuses by itself."""
    paths = [path.replace("\\n", "\n") for _, path, _ in MODULES if not path.startswith("..")]
    return tuple(("update-index", "--add", "--cacheinfo", f"160000,{'1' * 40},{path}") for path in paths)


def listing(*folders: Path) -> dict[str, str]:
    """Return what is below folders: kind, mode, and target or hash, by path."""
    found: dict[str, str] = {}
    for folder in folders:
        for place, names, files in os.walk(folder):
            for name in (*names, *files):
                path = Path(place) / name
                mode = path.lstat().st_mode
                if stat.S_ISLNK(mode):
                    said = f"link {path.readlink()}"
                elif stat.S_ISREG(mode):
                    said = hashlib.sha256(path.read_bytes()).hexdigest()
                else:
                    said = "-"
                found[str(path)] = f"{stat.filemode(mode)} {said}"
    return found


KNOWN = (
    "add-mask|add-matcher|add-path|debug|echo|endgroup|error|group|notice|remove-matcher|save-state|set-env|set-output|"
    "stop-commands|warning"
)
FIRST = re.compile(rf"##\[(?P<name>{KNOWN}|command)(?: [^\]]*)?\](?P<data>.*)", re.IGNORECASE)
SECOND = re.compile(r"\s*::(?P<name>[\w-]+)(?: .*?)?::(?P<data>.*)")


def commands(log: str) -> list[tuple[str, str]]:
    """Return the commands, name and data, that a runner reads in a log.

    https://github.com/actions/runner/blob/main/src/Runner.Common/ActionCommand.cs
    https://github.com/actions/runner/blob/main/src/Runner.Worker/ActionCommandManager.cs
    """
    found: list[tuple[str, str]] = []
    stopped = ""
    for line in re.split(r"\r\n|\r|\n", log):
        match = SECOND.match(line)
        if stopped:
            stopped = "" if match and match["name"] == stopped else stopped
        elif match and match["name"] == "stop-commands":
            stopped = match["data"]
        elif match and re.fullmatch(KNOWN, match["name"]):
            found.append((match["name"], match["data"]))
        elif match := FIRST.search(line):
            found.append((match["name"].lower(), match["data"]))
    return found


class _Page(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: dict[str, set[str]] = {}

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.setdefault(tag, set()).update(f"{name}={value}" for name, value in attrs)


OWN = {"h3", "h4", "p", "ul", "li", "ol", "code", "pre", "strong", "em", "details", "summary", "a", "table", "thead"}
OWN |= {"tbody", "tr", "th", "td", "br"}
"""Elements that the summary itself is made of."""
PLAIN = re.compile(r"open=None|class=language-(bash|text|mermaid|markdown)|href=https://github\.com/\S*")
"""Their attributes."""


def page(markdown: str) -> str:
    """Return Markdown as HTML, HTML in it included, as GitHub does before it removes what it does not allow."""
    from markdown_it import MarkdownIt

    html: str = MarkdownIt("commonmark", {"html": True}).enable(["table", "strikethrough"]).render(markdown)
    return html


def foreign(markdown: str) -> list[str]:
    """Return the elements, addresses and languages of code in a summary that are not the program's own."""
    html = page(markdown)
    reader = _Page()
    reader.feed(html)
    strange = sorted(set(reader.tags) - OWN)
    said = [(name, value) for name, values in sorted(reader.tags.items()) for value in sorted(values)]
    strange += [f"{name} {value}" for name, value in said if not PLAIN.fullmatch(value)]
    strange += [block for block in re.findall(r'language-mermaid">(.*?)</code>', html, re.DOTALL) if MARK in block]
    if html.count("<details") != html.count("</details>"):
        strange.append("details")
    outside = re.sub(r"<code.*?</code>", "", html, flags=re.DOTALL)
    return strange + re.findall(rf"(?:https?://|www\.){BEACON}", outside)


def main(file: Path, folders: list[Path]) -> None:
    """Keep the listing of folders in a file; the second time, print what differs from the first."""
    now = listing(*folders)
    if not file.exists():
        file.write_text(json.dumps(now))
        return
    before = json.loads(file.read_text())
    for path in sorted({*before, *now}):
        if before.get(path) != now.get(path):
            print("CHANGED", path)


if __name__ == "__main__":
    main(Path(sys.argv[1]), [Path(folder) for folder in sys.argv[2:]])
