"""README pages, CI files and install scripts."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import pytest

from roslab.evidence.prose import ci, mentions, readme
from roslab.evidence.prose import install_scripts as scripts
from roslab.evidence.prose.merged import Prose
from roslab.evidence.prose.preformatted import as_markdown
from roslab.repository.checkout import Repository


def read(module: ModuleType, tmp_path: Path, files: dict[str, str]) -> Prose:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    found: Prose = module.read(Repository.open(tmp_path))
    return found


def named(prose: Prose, namespace: str = "apt") -> list[tuple[str, int]]:
    if namespace == "pip":
        return [(asked.written, asked.line) for asked in prose.requirements]
    return [(d.name, d.line) for d in prose.dependencies if d.namespace == namespace]


README = """\
# Thing
Tested on Ubuntu 18.04 with ROS Melodic, Python 3.6, 3.7 or 3.8 and CUDA 10.2.

## Install
```bash
sudo apt-get install liba-dev \\
    ros-YOUR_DISTRO-b
git clone https://github.com/x/dep.git -b v2
```
1. `pip install numpy==1.2` and `sudo apt install libc`
2. $ sudo apt-get install libd

    sudo apt-get install libe

You need to install the libf package.
```
roslaunch thing it.launch
```

## Windows
```
pip install pywin32
```
## Real robot
    sudo apt-get install librealsense2-dkms
## Run
python run.py --go
"""


def test_a_readme(tmp_path: Path) -> None:
    prose = read(readme, tmp_path, {"README.md": README})
    assert named(prose) == [("liba-dev", 6), ("ros-{distro}-b", 7), ("libc", 10), ("libd", 11), ("libe", 13)]
    assert named(prose, "pip") == [("numpy==1.2", 10)]
    assert [(s.name, s.ref) for s in prose.sources if s.kind == "clone"] == [("dep", "v2")]
    mentions = {(m.topic, m.value) for m in prose.mentions}
    assert {("ubuntu", "18.04"), ("distro", "melodic"), ("cuda", "10.2")} <= mentions
    assert {("python", "3.6"), ("python", "3.7"), ("python", "3.8")} <= mentions
    assert {("command", "roslaunch thing it.launch"), ("command", "python run.py --go")} <= mentions


def test_inline_code_in_three_backquotes_opens_no_block(tmp_path: Path) -> None:
    text = (
        "1. Install:\n\n   ```sudo apt install liba```\n* Then: ```sudo apt-get install libb```\n"
        "Now install libc with apt install libd of old.\n```\napt install libe\n```\n"
    )
    assert named(read(readme, tmp_path, {"README.md": text})) == [("liba", 3), ("libb", 4), ("libe", 7)]


def test_a_licence_holds_no_other_section(tmp_path: Path) -> None:
    text = (
        "# Thing\n# License\n    apt install liba\n## Prerequisites\n    apt install libb\n"
        "# Windows\n## Install\n    apt install libc\n# Linux\n    apt install libd\n"
    )
    assert named(read(readme, tmp_path, {"README.md": text})) == [("libb", 5), ("libd", 10)]


def test_other_pages_and_formats(tmp_path: Path) -> None:
    files = {
        "README.rst": "Install\n=======\n\n.. code-block:: bash\n\n   sudo apt-get install liba\n",
        "docs/installation.md": "```\nsudo apt-get install libb\n```\n",
        "docs/theory.md": "```\nsudo apt-get install libc\n```\n",
        "third_party/x/README.md": "```\nsudo apt-get install libd\n```\n",
        "INSTALL": "apt-get install libe\n",
    }
    assert {name for name, _ in named(read(readme, tmp_path, files))} == {"liba", "libb", "libe"}


@pytest.mark.parametrize(
    ("page", "found"),
    [
        ("# Arm\n\n## Install\n### Ubuntu\nKinetic:\n```\ngit clone https://a/b\n```\n", {"kinetic"}),
        ("# Arm\n\n## Build\n**For kinetic**:\n\n```\ngit clone https://a/b\n```\n", {"kinetic"}),
        ("# Arm\n\n## Installation\n\n### Kinetic\n\nRun this.\n", {"kinetic"}),
        ("# Arm\n\n## Energies\nKinetic:\n```\ne = m * v**2 / 2\n```\n", set()),
        ("# Arm\n\n## Install\nKinetic:\nwhat moves.\n", set()),
        ("# Arm\n\n## Install\nKinetic energy:\n```\npip install energy\n```\n", set()),
    ],
)
def test_a_distribution_as_a_label_of_what_is_installed(tmp_path: Path, page: str, found: set[str]) -> None:
    prose = read(readme, tmp_path, {"README.md": "# Arms\n", "arm/README.md": page})
    assert {m.value for m in prose.mentions if m.topic == "distro"} == found


@pytest.mark.parametrize("line", ["a rolling stone", "the iron rod", "kinetic energy"])
def test_words_that_only_look_like_distros(tmp_path: Path, line: str) -> None:
    assert not [m for m in read(readme, tmp_path, {"README.md": line}).mentions if m.topic == "distro"]


@pytest.mark.parametrize(("name", "found"), [(".travis.yaml", {"kinetic"}), ("arm/.travis.yaml", set())])
def test_a_ci_file_with_the_other_ending(tmp_path: Path, name: str, found: set[str]) -> None:
    prose = read(ci, tmp_path, {name: "env:\n  global:\n    - ROS_DISTRO=kinetic\n"})
    assert {m.value for m in prose.mentions if m.topic == "distro"} == found


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("Recommended for Ubuntu 24", ["24.04"]),
        ("Ubuntu 22, ROS 2", ["22.04"]),
        ("On Ubuntu 20 and later", ["20.04"]),
        ("Tested on Ubuntu 18.", ["18.04"]),
        ("Ubuntu 22.10", []),
        ("Ubuntu 18.04.5", ["18.04"]),
        ("Ubuntu 16 GB, 20 cores", []),
        ("Ubuntu 24th", []),
        ("Ubuntu 21", []),
    ],
)
def test_an_ubuntu_may_be_named_by_its_year(line: str, said: list[str]) -> None:
    assert [m.value for m in mentions.read(line, "README.md", "readme") if m.topic == "ubuntu"] == said


@pytest.mark.parametrize(
    "line", ["Ubuntu 64-bit 16.04", "Ubuntu (64bit) 16.04", "Ubuntu Linux 16.04", "ubuntu version 16.04 or 18.04"]
)
def test_words_before_the_number_of_an_ubuntu(tmp_path: Path, line: str) -> None:
    said = [
        m.value for m in read(readme, tmp_path, {"README.md": f"Tested on {line}."}).mentions if m.topic == "ubuntu"
    ]
    assert said[0] == "16.04"


@pytest.mark.parametrize("line", ["apt-get install ros-`rosversion -d`-tf", "    apt install ros-`rosversion -d`-tf"])
def test_the_shell_names_the_distribution_in_the_name_of_a_package(tmp_path: Path, line: str) -> None:
    assert [name for name, _ in named(read(readme, tmp_path, {"README.md": f"# Install\n{line}\n"}))] == [
        "ros-{distro}-tf"
    ]


CI = """\
on: push
jobs:
  build:
    strategy:
      matrix:
        distro: [humble, jazzy]  # ROS
    container:
      image: ros:${{ matrix.distro }}
    steps:
      - run: |
          sudo apt-get update
          sudo apt-get install -y liba \\
            ros-${{ matrix.ros_distro }}-b
      - run: sudo apt-get install libc
      - name: folded
        run: >
          sudo apt-get install
          libd
          libe
      # - run: sudo apt-get install libx
    env:
      ADDITIONAL_DEBS: "libf libg"
"""


def test_github_actions(tmp_path: Path) -> None:
    prose = read(
        ci, tmp_path, {".github/workflows/main.yml": CI, ".github/workflows/docs.yml": "run: apt-get install z\n"}
    )
    assert {name for name, _ in named(prose)} == {"liba", "ros-{distro}-b", "libc", "libd", "libe", "libf", "libg"}
    assert ("liba", 12) in named(prose)
    assert {m.value for m in prose.mentions if m.topic == "distro"} == {"humble", "jazzy"}


def test_quoted_commands_and_the_values_of_a_matrix(tmp_path: Path) -> None:
    circle = '  - run:\n      command: "source /opt/ros/noetic/setup.bash && catkin build --say \\"so\\""\n'
    matrix = (
        "matrix:\n  include:\n  - os: a\n    py: python\n  - os: b\n    py: python3\n"
        "run: sudo apt install -y lib${{ matrix.py }}-dev ros-${{ matrix.ros_distro }}-b x${{ matrix.none }}y\n"
    )
    prose = read(ci, tmp_path, {".circleci/config.yml": circle, ".github/workflows/ci.yml": matrix})
    assert [m.value for m in prose.mentions if m.topic == "build_tool"] == ["catkin_tools"]
    assert [name for name, _ in named(prose)] == ["libpython-dev", "libpython3-dev", "ros-{distro}-b"]


YAML = """\
env: {DEPS: libz}
jobs:
  build:
    container: ros:noetic-ros-base
    env:
      ADDITIONAL_DEBS: libd libe
    steps:
      - name: sudo apt-get install is what this does
      - run: sudo apt-get install -y liba
          libb
      - run: |
          cd x

          # apt-get install libnot
          apt-get install libc
      - run: >-
          apt-get install
          libf
      - &again
        run: apt-get install libg
      - *again
"""


def test_values_of_yaml_are_commands_with_their_lines(tmp_path: Path) -> None:
    prose = read(ci, tmp_path, {".github/workflows/main.yml": YAML})
    names = [("liba", 9), ("libb", 9), ("libc", 15), ("libf", 18), ("libg", 20)]
    assert [entry for entry in named(prose) if entry[0] in {name for name, _ in names} | {"libnot"}] == names
    assert [entry for entry in named(prose) if entry[0] in {"libd", "libe"}] == [("libd", 6), ("libe", 6)]
    assert [(m.value, m.line) for m in prose.mentions if m.topic == "base"] == [("ros:noetic-ros-base", 4)]


@pytest.mark.parametrize(
    "text",
    [
        "a: [\nrun: apt-get install liba\n",
        "run: apt-get install liba\n\tb: c\n",
        "x: " + "[" * 200 + "\nrun: apt-get install liba\n",
    ],
    ids=["cut", "tab", "deep"],
)
def test_a_broken_file_still_speaks(text: str, tmp_path: Path) -> None:
    assert ("liba", text.split("run:", maxsplit=1)[0].count("\n") + 1) in named(
        read(ci, tmp_path, {".travis.yml": text})
    )


def test_aliases_are_read_once(tmp_path: Path) -> None:
    bomb = "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]\n" for n in range(1, 30))
    text = f"a0: &a0 [apt-get install liba]\n{bomb}own: &own [*own, apt-get install libb]\n"
    assert [name for name, _ in named(read(ci, tmp_path, {".travis.yml": text}))] == ["liba", "libb"]


@pytest.mark.parametrize(
    ("path", "text"),
    [
        (
            "wercker.yml",
            "box: osrf/ros:lunar-desktop-full\nbuild:\n  steps:\n    - script:\n      code: |\n        RUN\n",
        ),
        ("shippable.yml", "build:\n  pre_ci_boot:\n    image: osrf/ros:lunar-desktop-full\n  ci:\n    - RUN\n"),
        (
            ".semaphore/semaphore.yml",
            "containers:\n  - image: osrf/ros:lunar-desktop-full\n    commands:\n      - RUN\n",
        ),
        (
            ".woodpecker.yml",
            "pipeline:\n  build:\n    image: osrf/ros:lunar-desktop-full\n    commands:\n      - RUN\n",
        ),
    ],
)
def test_services_that_few_use(path: str, text: str, tmp_path: Path) -> None:
    text = text.replace("RUN", "sudo apt install -y libone-dev")
    prose = read(ci, tmp_path, {path: text, f"deeper/{path}": text.replace("one", "two")})
    assert [name for name, _ in named(prose)] == ["libone-dev"]
    assert [m.value for m in prose.mentions if m.topic == "base"] == ["osrf/ros:lunar-desktop-full"]


def test_travis_lists(tmp_path: Path) -> None:
    text = "dist: xenial\naddons:\n  apt:\n    packages:\n    - liba\n    - libb\nscript:\n  - catkin_make\n"
    prose = read(ci, tmp_path, {".travis.yml": text})
    assert named(prose) == [("liba", 5), ("libb", 6)]
    assert {(m.topic, m.value) for m in prose.mentions} == {("ubuntu", "xenial"), ("build_tool", "catkin_make")}


@pytest.mark.parametrize(
    ("path", "dockerfile"),
    [
        ("tools/get_things.sh", "FROM ros:noetic\nCOPY tools /tmp/tools\nRUN bash /tmp/tools/get_things.sh --all\n"),
        ("start.sh", 'FROM ros:noetic\nCOPY start.sh /\nENTRYPOINT ["/start.sh"]\n'),
        ("start.sh", "FROM ros:noetic\nCOPY start.sh /\nCMD /start.sh\n"),
    ],
)
def test_a_script_of_any_name_that_an_image_runs_is_read(tmp_path: Path, path: str, dockerfile: str) -> None:
    files = {path: "#!/bin/bash\napt-get install -y libzmq3-dev\n", "tools/other.sh": "apt-get install -y libodd-dev\n"}
    assert named(read(scripts, tmp_path, files)) == []
    assert named(read(scripts, tmp_path, {**files, "docker/Dockerfile": dockerfile})) == [("libzmq3-dev", 2)]


def test_install_scripts_and_lists(tmp_path: Path) -> None:
    files = {
        "scripts/install_deps.sh": 'SUDO=""\nDEPS="liba ros-$ROS_DISTRO-b"\n$SUDO apt-get install -y $DEPS sudo libc\n',
        "scripts/plot.sh": "apt-get install libx\n",
        "install_jetson.sh": "apt-get install liby\n",
        "apt.txt": "libd\nlibe\n",
    }
    found = {name for name, _ in named(read(scripts, tmp_path, files))}
    assert found == {"liba", "ros-{distro}-b", "sudo", "libc", "libd", "libe"}
    assert not {name for name, _ in named(read(scripts, tmp_path, files))} & {"libx", "liby"}


def test_pipx_and_the_pages_on_compiling(tmp_path: Path) -> None:
    pages = {
        "tools/README.md": '```bash\npipx install --include-deps --force "thing==10.*"\n```\n',
        "doc/Compilation.md": "```bash\npip install cmake\n```\n",
        "doc/Contributors.md": "```bash\npip install never\n```\n",
    }
    assert sorted(named(read(readme, tmp_path, pages), "pip")) == [("cmake", 2), ("thing==10.*", 2)]


@pytest.mark.parametrize(
    "prompt", ["robot", "me@host:~/catkin_ws", "me@host:~", "(venv) robot", "me@host", "(venv)[robot]", "[me@host ws]"]
)
def test_what_a_shell_prints_before_a_command_is_none_of_it(tmp_path: Path, prompt: str) -> None:
    page = f"`{prompt}$ python -m plan.run`\n\n```\n{prompt}$ roslaunch robot go.launch\n```\n"
    prose = read(readme, tmp_path, {"README.md": page})
    assert [mention.value for mention in prose.mentions if mention.topic == "command"] == [
        "python -m plan.run",
        "roslaunch robot go.launch",
    ]


@pytest.mark.parametrize(
    ("typed", "read_as"),
    [
        ("python go.py --scene (packed/a | pile) --view 1", "python go.py --scene packed/a --view 1"),
        ("python go.py --scene \uff08packed \uff5c pile)", "python go.py --scene packed"),
        ("python go.py (slow)", "python go.py"),
    ],
)
def test_of_the_values_that_a_page_offers_for_an_option_the_first_is_taken(
    tmp_path: Path, typed: str, read_as: str
) -> None:
    prose = read(readme, tmp_path, {"README.md": f"```\n{typed}\n```\n"})
    assert [mention.value for mention in prose.mentions if mention.topic == "command"][:1] == [read_as]


def test_a_remark_behind_two_slashes_is_none_of_a_command(tmp_path: Path) -> None:
    page = "```\nroslaunch robot go.launch map:=//old // load the map\n```\n"
    prose = read(readme, tmp_path, {"README.md": page})
    assert [mention.value for mention in prose.mentions if mention.topic == "command"] == [
        "roslaunch robot go.launch map:=//old"
    ]


@pytest.mark.parametrize(
    ("page", "lines"),
    [
        ("Run\n<pre>\npython go.py &gt; log\n</pre>\npython is nice\n", [3]),
        ("<pre><code>\npython go.py\n</code></pre>\n", [2]),
        ("<pre>\n<code>\npython <b>go.py</b>\n</code>\n</pre>\n", [3]),
        ("<PRE lang='bash'>python go.py\n  python go.py --fast</PRE>\n", [1, 2]),
        ("```\n<pre>\npython go.py\n</pre>\n```\n", [3]),
        ("<pre>\npython go.py\n", [2]),
    ],
)
def test_blocks_of_html_show_code(tmp_path: Path, page: str, lines: list[int]) -> None:
    prose = read(readme, tmp_path, {"README.md": page, "go.py": ""})
    assert [mention.line for mention in prose.mentions if mention.topic == "command"] == lines
    assert as_markdown(page).count("\n") == page.count("\n")


def test_a_variable_is_no_prompt(tmp_path: Path) -> None:
    prose = read(readme, tmp_path, {"README.md": "```\ncost$ is 5\n$HOME/run.sh\nmake && echo a$ b\n```\n"})
    assert [mention.value for mention in prose.mentions if mention.topic == "command"] == []


def test_a_build_command_alone_on_its_line(tmp_path: Path) -> None:
    page = "Build it:\n\n    cd ~/catkin_ws\n    catkin_make\n\nThen catkin_make is done.\n"
    found = read(readme, tmp_path, {"README.md": page})
    assert [(m.value, m.line) for m in found.mentions if m.topic == "build_tool"] == [("catkin_make", 4)]


@pytest.mark.parametrize("substitution", ["`ros2 pkg prefix thing`", "$(ros2 pkg prefix thing)"])
def test_what_only_a_shell_knows_stays_unknown_in_a_command(tmp_path: Path, substitution: str) -> None:
    text = f"Run it:\n\n```bash\nros2 run thing load {substitution}/lib/libtalker.so --once\n```\n"
    prose = read(readme, tmp_path, {"README.md": text})
    assert [mention.value for mention in prose.mentions if mention.topic == "command"] == [
        "ros2 run thing load …/lib/libtalker.so --once"
    ]


SCRIPT = """\
#!/bin/bash
case $CUDA in
  10.2)
    pip install torch==1.8.0 spconv-cu102 ;;
  *) pip install torch==1.10.0 spconv-cu111
     pip install torchvision==0.11.1 ;;
esac
if [ -n "$GPU" ]; then
  pip install tensorflow-gpu==1.15
else
  pip install tensorflow==1.15 numpy==1.18
fi
if true; then pip install numpy==1.19; fi
"""


def test_the_branches_of_a_script_are_alternatives(tmp_path: Path) -> None:
    (tmp_path / "install.sh").write_text(SCRIPT)
    written = [asked.written for asked in scripts.read(Repository.open(tmp_path)).requirements]
    assert [each for each in written if each.startswith("torch")] == ["torch==1.8.0", "torchvision==0.11.1"]
    assert [each for each in written if each.startswith("numpy")] == ["numpy==1.18", "numpy==1.19"]


@pytest.mark.parametrize(
    ("text", "read_lines"),
    [
        ("# Policies for Real Robots\n    apt install liba\n## Run\n    apt install libb\n", [2, 4]),
        ("# Hardware in the loop\n```\n# apt\napt install liba\n```\n## Real robots\n    apt install libb\n", [4]),
        ("# Real robots\n    apt install liba\n# Run\n    apt install libb\n", [4]),
        ("# Install on Windows\n    apt install liba\n## Run\n    apt install libb\n", []),
    ],
)
def test_the_title_of_a_page_tells_what_it_is_for(tmp_path: Path, text: str, read_lines: list[int]) -> None:
    assert [line for _, line in named(read(readme, tmp_path, {"README.md": text}))] == read_lines


@pytest.mark.parametrize(
    ("function", "call", "cloned"),
    [
        ('fetch() {\n  git clone "$1" || (cd x && git pull)\n}', "fetch https://github.com/lab/odd.git", ("odd", None)),
        (
            'function fetch {\n  local url=$1\n  local branch=$2\n  git clone -b "$branch" "$url"\n}',
            "  fetch https://github.com/lab/odd.git v1.2 # the last",
            ("odd", "v1.2"),
        ),
        ('function fetch(){\n  eval "$1"\n}', 'fetch "git clone -b v3 https://github.com/lab/odd.git"', ("odd", "v3")),
        (
            'fetch() {\n  git clone "$1"\n  git checkout $2\n}',
            'fetch "https://github.com/lab/odd" abc123',
            ("odd", "abc123"),
        ),
        ("fetch() {\n  wget $1\n}", "fetch https://github.com/lab/odd.git", None),
        ("fetch() {\n  git clone $1\n}", 'fetch "$URL"', None),
    ],
)
def test_a_function_of_a_script_clones_what_it_is_given(
    tmp_path: Path, function: str, call: str, cloned: tuple[str, str | None] | None
) -> None:
    (tmp_path / "install.sh").write_text(f"#!/bin/bash\n{function}\napt-get install -y cmake\n{call}\n")
    found = scripts.read(Repository.open(tmp_path)).sources
    assert [(git.name, git.ref) for git in found] == ([cloned] if cloned else [])
    assert all(git.line == function.count("\n") + 4 for git in found)


@pytest.mark.parametrize(
    ("line", "ref"),
    [
        ("git checkout 84bfc56 # the last that works", "84bfc56"),
        ("git checkout 84bfc56 // the last that works", "84bfc56"),
        ("git checkout 84bfc56 -b mine", "84bfc56"),
        ("git checkout -b mine origin/devel", "devel"),
        ("git checkout tags/v1.2 -b v1.2", "v1.2"),
        ("git -C arm checkout v1.2", "v1.2"),
        ("git switch --detach v1.2", "v1.2"),
        ("git reset --hard 84bfc56", "84bfc56"),
        ("git reset --hard HEAD~1", None),
        ("git reset 84bfc56", None),
        ("git checkout -b mine", None),
        ("git checkout .", None),
        ("git checkout v1.2 -- src/a.cpp", None),
    ],
)
def test_what_git_takes_of_a_clone(tmp_path: Path, line: str, ref: str | None) -> None:
    page = f"```\ngit clone https://github.com/lab/arm.git\ncd arm\n{line}\n```\n"
    found = read(readme, tmp_path, {"README.md": page}).sources
    assert [git.ref for git in found if git.kind == "clone"] == [ref]


@pytest.mark.parametrize(
    ("lines", "refs"),
    [
        ("cd arm\ngit checkout 84bfc56\ncd ../hand\ngit checkout v2", ["84bfc56", "v2"]),
        ("cd ~/ws/src/arm/\ngit checkout 84bfc56\ngit checkout main", ["84bfc56", None]),
        ("git -C ws/src/arm checkout 84bfc56", ["84bfc56", None]),
        ("git checkout v2", [None, "v2"]),
        ("cd hand && git checkout -b mine\ngit checkout v2", [None, None]),
    ],
)
def test_what_is_checked_out_is_of_the_clone_in_whose_folder_git_is_called(
    tmp_path: Path, lines: str, refs: list[str | None]
) -> None:
    clones = "git clone https://github.com/lab/arm.git\ngit clone https://github.com/lab/hand.git"
    found = read(readme, tmp_path, {"README.md": f"```\n{clones}\n{lines}\n```\n"}).sources
    assert [git.ref for git in found if git.kind == "clone"] == refs


@pytest.mark.parametrize(
    "page",
    [
        "> pip install einops \\\n> timm \\\n>   'yacs==0.1'\n",
        "```\n$ pip install einops \\\n> timm \\\n> yacs==0.1\n```\n",
        "    pip install einops \\\n      timm \\\n      yacs==0.1\n",
        '```\npip install "einops" \\\n  timm "yacs==0.1" \\\n  > log.txt\n```\n',
    ],
)
def test_a_command_that_goes_on_in_lines_with_a_mark(tmp_path: Path, page: str) -> None:
    prose = read(readme, tmp_path, {"README.md": f"# Thing\n\n{page}"})
    assert [asked.written for asked in prose.requirements] == ["einops", "timm", "yacs==0.1"]


@pytest.mark.parametrize(
    ("source", "text", "named"),
    [
        ("ci", 'build: ["humble", "jazzy"]\n', ["humble", "jazzy"]),
        ("ci", "build:\n  - humble\n  - jazzy\n  - 'rolling'\n", ["humble", "jazzy", "rolling"]),
        ("ci", 'build: ["humble", "proud"]\n', []),
        ("ci", "build:\n  - humble\n  - proud\ntune: jazzy\n", ["jazzy"]),
        ("readme", "It runs on foxy, galactic and humble.\n", ["foxy", "galactic", "humble"]),
        ("readme", "A humble page.\n\nA foxy one.\n", ["foxy"]),
    ],
)
def test_an_ordinary_word_is_a_distribution_beside_another_one(source: str, text: str, named: list[str]) -> None:
    found = mentions.read(text, "a", source)  # type: ignore[arg-type]
    assert sorted(each.value for each in found if each.topic == "distro") == named
