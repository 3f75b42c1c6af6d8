"""Dockerfile.dockerignore: the author's lines hold, the Dockerfile gets what it names, .git never goes in."""

from __future__ import annotations

import resource
from collections.abc import Callable

import pytest

from hanging import ends
from roslab.plan.plan import Plan, Rosdep
from roslab.render.ignore import ignore as ignore_file
from roslab.render.ignore import keeps_out

Plans = Callable[..., Plan]
MEGABYTES = 100
OWN = ("Dockerfile", "docker_build.sh")


def ignore(plan: Plan) -> str:
    return ignore_file(plan, OWN)


def rosdep(*manifests: str) -> Rosdep:
    return Rosdep(manifests=manifests, skip_keys=(), rosdistro_tag=None)


def lines_of(text: str) -> list[str]:
    return [line for line in text.splitlines() if line and not line.startswith("#")]


def test_without_an_ignore_file_of_the_authors(plan: Plans) -> None:
    assert lines_of(ignore(plan())) == [*OWN, "**/.git"]


def test_the_authors_lines_are_kept_in_their_order(plan: Plans) -> None:
    """The original wrote over .dockerignore: what its author had kept out was in the image."""
    lines = ("# secrets", "*.key", "", "data/", "!data/small.csv", "  spaced  ")
    text = ignore(plan(ignore=lines))
    assert "# secrets\n*.key\n\ndata/\n!data/small.csv\n  spaced" in text


def test_git_stays_out_whatever_the_author_excepts(plan: Plans) -> None:
    """The original let .git into the image, with the credentials that a checkout leaves in it."""
    lines = lines_of(ignore(plan(ignore=("*", "!.git", "!**"))))
    assert keeps_out(lines, ".git/config")
    assert keeps_out(lines, "third_party/library/.git")
    assert not keeps_out(lines, ".gitignore")


def test_the_notebook_goes_into_the_image(plan: Plans) -> None:
    assert not keeps_out(lines_of(ignore(plan())), "README.ipynb")


@pytest.mark.parametrize("line", ["*.txt", "**/*.txt", "requirements*", "/requirements.txt", "require?ents.txt"])
def test_a_requirements_file_comes_back(plan: Plans, line: str) -> None:
    lines = lines_of(ignore(plan(requirements=("requirements.txt",), ignore=(line, "*.key"))))
    assert lines[:3] == [line, "!requirements.txt", "*.key"]
    assert not keeps_out(lines, "requirements.txt")


@pytest.mark.parametrize("line", ["*", "**", "/*", "  **/*"])
@pytest.mark.parametrize(
    "needs",
    [
        {"requirements": ("requirements.txt",)},
        {"kind": "cpp"},
        {"kind": "ros2", "rosdep": rosdep("package.xml", "part/package.xml")},
    ],
)
def test_all_comes_back_where_the_repository_itself_is_built(plan: Plans, line: str, needs: dict[str, object]) -> None:
    """``*`` and what is excepted from it is what the author's own Dockerfile takes, and no more."""
    lines = lines_of(ignore(plan(**needs, ignore=("*.key", line, "!requirements.txt", "**/build"))))
    assert lines[:3] == ["*.key", line.rstrip(), "!**"]
    assert not keeps_out(lines, "src/main.cpp")
    assert not keeps_out(lines, "CMakeLists.txt")
    assert keeps_out(lines, "part/build")


@pytest.mark.parametrize(
    ("let_in", "whole"),
    [
        (("!src",), False),
        (("!src/*.py", "!requirements.txt"), False),
        (("!requirements.txt",), True),
        (("!config",), True),  # an argument is no program
        (("!src", "src/train.py"), True),
    ],
)
def test_a_list_that_lets_in_the_program_stays_as_it_is(plan: Plans, let_in: tuple[str, ...], *, whole: bool) -> None:
    """What else lies there, as a .env or data, the author keeps from every image of the program."""
    command = ("python3", "src/train.py", "--config", "config/a.yaml")
    lines = lines_of(ignore(plan(command=command, python_projects=(".",), ignore=("*", *let_in))))
    assert ("!**" in lines) is whole
    assert keeps_out(lines, ".env") is not whole
    assert not keeps_out(lines, "src/train.py")


def test_what_the_author_shuts_out_beside_it_stays_out(plan: Plans) -> None:
    lines = lines_of(ignore(plan(kind="cpp", ignore=("data", "*.bag", "*.*", "[a-m]*"))))
    assert "!**" not in lines
    assert all(keeps_out(lines, path) for path in ("data/a", "x.bag", "a.b", "main.cpp"))


def test_all_that_the_author_lets_in_again_is_in(plan: Plans) -> None:
    assert lines_of(ignore(plan(kind="cpp", ignore=("*", "!**"))))[:2] == ["*", "!**"]


def test_what_is_not_shut_out_is_not_named(plan: Plans) -> None:
    lines = lines_of(ignore(plan(requirements=("requirements.txt",), ignore=("*.txt", "!requirements.txt"))))
    assert lines == ["*.txt", "!requirements.txt", *OWN, "**/.git"]


def test_a_package_comes_back_whole_where_its_folder_was_shut_out(plan: Plans) -> None:
    keys = rosdep("src/robot/package.xml")
    lines = lines_of(
        ignore(plan(kind="ros1", command=("bash",), rosdep=keys, ignore=("*", "!docs", "**/build", "*.bag")))
    )
    assert lines[:2] == ["*", "!src/robot"]
    assert not keeps_out(lines, "src/robot/src/main.cpp")
    assert keeps_out(lines, "src/robot/build")
    assert keeps_out(lines, "notes.md")


def test_a_package_comes_back_whole_where_the_author_lets_in_its_manifest_alone(plan: Plans) -> None:
    keys = rosdep("robot/package.xml", "src/arm/package.xml")
    shut = ("**", "!**/package.xml", "*.bag", "robot/data")
    lines = lines_of(ignore(plan(kind="ros2", command=("bash",), rosdep=keys, ignore=shut)))
    assert lines[:4] == ["**", "!robot", "!src/arm", "!**/package.xml"]
    assert not keeps_out(lines, "robot/CMakeLists.txt")
    assert not keeps_out(lines, "src/arm/src/main.cpp")
    assert keeps_out(lines, "robot/data/x")
    assert keeps_out(lines, "notes.md")


def test_a_package_comes_back_as_its_manifest_where_only_that_was_shut_out(plan: Plans) -> None:
    lines = lines_of(ignore(plan(rosdep=rosdep("robot/package.xml", "package.xml"), ignore=("robot/data", "**/*.xml"))))
    assert lines[:4] == ["robot/data", "**/*.xml", "!package.xml", "!robot/package.xml"]
    assert keeps_out(lines, "robot/data/x.bag")
    assert keeps_out(lines, "robot/launch.xml")


@pytest.mark.parametrize(
    ("projects", "line", "again"),
    [
        ((".",), "README.md", ["!README.md"]),
        ((".",), "LICENSE", ["!LICENSE"]),
        ((".",), "**/*.md", ["!LICENSE.md", "!README.md"]),
        (("lib/arm",), "**/README*", ["!lib/arm/README.md", "!lib/arm/README.rst", "!lib/arm/README.txt"]),
        (("lib/arm",), "README.md", []),  # of the root, which is no project
        ((".",), "docs/README.md", []),
        ((), "README.md", []),
    ],
)
def test_what_the_description_of_a_project_is_read_from_comes_back(
    plan: Plans, projects: tuple[str, ...], line: str, again: list[str]
) -> None:
    lines = lines_of(ignore(plan(python_projects=projects, ignore=(line, "*.key"))))
    assert lines[: 2 + len(again)] == [line, *again, "*.key"]


@pytest.mark.parametrize(
    ("command", "line", "again"),
    [
        (("python3", "bin/train.py", "--config", "config/a.yaml"), "**/bin", ["!bin"]),
        (("python3", "./tools/train.py"), "**/*.py", ["!tools/train.py"]),
        (("python3", "train.py", "--config", "config/a.yaml"), "config/*.yaml", ["!config/a.yaml"]),
        ("source setup.sh && python3 bin/train.py", "bin", ["!bin"]),
        (("ros2", "launch", "demo", "demo.launch.py"), "*.py", []),  # a package has it
        (("python3", "/opt/bin/train.py"), "opt", []),
        (("python3", "-m", "demo.train"), "demo", []),
        (("python3", "train.py"), "data", []),
    ],
)
def test_what_the_command_names_comes_back(
    plan: Plans, command: tuple[str, ...] | str, line: str, again: list[str]
) -> None:
    lines = lines_of(ignore(plan(command=command, ignore=(line, "*.key"))))
    assert lines[: 2 + len(again)] == [line, *again, "*.key"]


def test_a_name_with_wildcards_is_written_to_the_letter(plan: Plans) -> None:
    lines = lines_of(ignore(plan(requirements=("req[1]*.txt",), ignore=("*.txt",))))
    assert lines[1] == r"!req\[1]\*.txt"
    assert not keeps_out(lines, "req[1]*.txt")
    assert keeps_out(lines, "req1x.txt")


@pytest.mark.parametrize(
    ("pattern", "path", "out"),
    [
        ("data", "data/x/y", True),
        ("data", "more/data", False),
        ("**/data", "more/data/x", True),
        ("a/**/z", "a/z", True),
        ("a/**/z", "a/b/c/z", True),
        ("a/**", "a/b", True),
        ("a/*/c", "a/b/x/c", False),
        ("./a//b/", "a/b", True),
        ("[a-c]x", "bx", True),
        ("[^a-c]x", "bx", False),
        ("[^a-c]x", "dx", True),
        (r"\*x", "*x", True),
        (r"\*x", "yx", False),
        ("# data", "# data", False),
        ("*" * 40 + "b", "a" * 200, False),
        ("/".join(["**"] * 60) + "/b", "/".join("a" * 60), False),
    ],
)
def test_patterns_mean_what_docker_says(pattern: str, path: str, out: bool) -> None:
    """https://docs.docker.com/build/concepts/context/#syntax, and github.com/moby/patternmatcher."""
    assert keeps_out([pattern], path) is out


@pytest.mark.parametrize(
    "line",
    [
        pytest.param("*" * 500_000, id="stars"),
        pytest.param("*" * 500_000 + "\n" + "*.txt", id="stars-then-a-real-line"),
        pytest.param("a*" * 500_000, id="groups"),
        pytest.param("?" * 500_000, id="marks"),
        pytest.param("[ab]" * 200_000, id="classes"),
        pytest.param("/".join(["**"] * 300_000), id="depths"),
        pytest.param("/".join(["*", "**"] * 150_000), id="stars-and-depths"),
        pytest.param("\n".join(f"*{number}*x" for number in range(150_000)), id="lines"),
        pytest.param("/".join(f"a{number}*" for number in range(150_000)), id="parts"),
    ],
)
def test_a_hostile_ignore_file_ends_soon_and_in_little_memory(plan: Plans, line: str) -> None:
    paths = [f"src/{'deep/' * (number % 100)}{number}/package.xml" for number in range(500)]
    lines = tuple(line.splitlines())
    planned = plan(rosdep=rosdep(*paths), requirements=("requirements.txt",), ignore=lines)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with ends():
        text = ignore(planned)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MEGABYTES * 1024
    assert all(written in text for written in lines[:10]), "docker reads every line of the author's"
    if "*.txt" in lines:
        assert "!requirements.txt" in text, "stars say no more than one star"


def test_a_file_that_nobody_read_to_its_end_keeps_nothing_out() -> None:
    """It decides whether a build could see a credential: where that is not known, it could."""
    assert keeps_out(["**/.git"], ".git/config")
    assert not keeps_out(["**/.git", "x" * 100_000, "!**/.git"], ".git/config")
