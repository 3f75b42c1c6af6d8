"""What a requirement line, a specifier and a package of conda's say."""

from __future__ import annotations

from itertools import product

import pytest
from packaging.requirements import Requirement as Standard
from packaging.specifiers import SpecifierSet

from roslab.values.conda import conda_package
from roslab.values.interpreter import Interpreter
from roslab.values.requirement_line import requirement, stated
from roslab.values.specifier import Specifiers, admits, specifiers

WHEEL = "https://e.org/whl/cu113/torch-1.10.0%2Bcu113-cp38-cp38-linux_x86_64.whl"


@pytest.mark.parametrize(
    ("line", "key", "text", "release", "role"),
    [
        ("PyYAML >= 5, <6", "pyyaml", "PyYAML>=5,<6", None, ""),
        ("torch==1.10.0+cu113", "torch", "torch==1.10.0+cu113", "1.10.0+cu113", ""),
        ("opencv-python==4.*", "opencv-python", "opencv-python==4.*", "4", ""),
        ("open3d==v0.12", "open3d", "open3d==v0.12", "0.12", ""),
        ("a[b, c]>1 ; python_version>'3'", "a", 'a[b,c]>1; python_version > "3"', None, ""),
        ("six>=1.0.*", "six", "six>=1.0", None, "repaired"),
        ("six (>=1)", "six", "six>=1", None, ""),
        ("six; python_version<3.8", "six", "six", None, "repaired"),
        ("six==1.0-odd", "six", "six==1.0-odd", None, ""),
        ("numpy=>1.2", "numpy", "numpy>=1.2", None, "repaired"),
        ("numpy =< 2, => 1.2", "numpy", "numpy<=2,>=1.2", None, "repaired"),
        ("numpy=~1.2", "numpy", "numpy~=1.2", "1.2", "repaired"),
        ("Pillow=-7.0.0", "pillow", "Pillow==7.0.0", "7.0.0", "repaired"),
        ("Pillow==-7.0.0", "pillow", "Pillow==7.0.0", "7.0.0", "repaired"),
        ("Pillow==7.0.", "pillow", "Pillow==7.0", "7.0", "repaired"),
        ("numpy[a]:1.2", "numpy", "numpy[a]==1.2", "1.2", "repaired"),
        ("numpy   1.2.3", "numpy", "numpy==1.2.3", "1.2.3", "repaired"),
        ("numpy=latest", "numpy", "numpy", None, "repaired"),
        ("certifi=2020.6.20=py37_0", "certifi", "certifi==2020.6.20", "2020.6.20", "repaired"),
        (
            "git+https://github.com/a/Some_Thing.git@v1",
            "some-thing",
            "git+https://github.com/a/Some_Thing.git@v1",
            None,
            "",
        ),
        ("git+https://e.org/a/b/#subdirectory=c/torch", "b", "git+https://e.org/a/b/#subdirectory=c/torch", None, ""),
        ("git+ssh://git@e.org/a/b.git@fix/it", "b", "git+ssh://git@e.org/a/b.git@fix/it", None, ""),
        ("-e git+https://e.org/a.git#egg=b", "b", "git+https://e.org/a.git#egg=b", None, "editable"),
        ("https://e.org/a/b.git", "b", "git+https://e.org/a/b.git", None, "repaired"),
        ("https://e.org/a/b.git@v1#egg=c", "c", "git+https://e.org/a/b.git@v1#egg=c", None, "repaired"),
        ("-e https://e.org/a/b.git", "b", "git+https://e.org/a/b.git", None, "editable"),
        ("https://github.com/a/b", "b", "git+https://github.com/a/b", None, "repaired"),
        ("https://e.org/a/b.git.zip", "b-git-zip", "https://e.org/a/b.git.zip", None, ""),
        ("https://github.com/a/b/archive/v1.zip", "v1-zip", "https://github.com/a/b/archive/v1.zip", None, ""),
        (WHEEL, "torch", WHEEL, "1.10.0+cu113", ""),
        ("-e .[dev]", "", ".[dev]", None, "project"),
    ],
)
def test_a_line_is_read_once(line: str, key: str, text: str, release: str | None, role: str) -> None:
    asked = requirement(line, "manifest")
    assert asked is not None
    assert (asked.key, asked.text, asked.release, asked.role) == (key, text, release, role)


@pytest.mark.parametrize(
    "line", ["two words", "numpy 3", "a<>1.2", "numpy: 1.2 or so", "", "==1", "$NAME", "a==", "<name>"]
)
def test_what_names_nothing_is_none(line: str) -> None:
    assert requirement(line, "manifest") is None


def test_bounds_wheels_and_reports() -> None:
    assert (stated("a>=1,>=2,<5,<4").at_least, stated("a>=1,>=2,<5,<4").below) == ("2", "4")
    assert [stated(line).limited for line in ("a", "a>=1", "a<2", "a~=1.2", "a @ https://e.org/a.zip")] == [
        False, False, True, True, True,
    ]  # fmt: skip
    wheel = stated(WHEEL).wheel
    assert wheel is not None
    assert (wheel.python, wheel.amd64_only) == ("3.8", True)
    assert stated("git+https://e.org/x/A.git").told == "a @ git+https://e.org/x/A.git"


@pytest.mark.parametrize(
    ("marker", "python", "may", "must"),
    [
        ("python_version < '3.8'", "3.7", True, True),
        ("python_version < '3.8'", "3.10", False, False),
        ("python_full_version < '3.8.10'", "3.8", False, False),
        ("platform_machine == 'aarch64'", "3.8", True, False),
        ("os_name == 'nt' or sys_platform == 'linux2'", "2.7", True, True),
        ("extra == 'dev'", "3.8", False, False),
        ("platform_release >= '5.4'", "3.8", True, False),
    ],
)
def test_markers(marker: str, python: str, may: bool, must: bool) -> None:
    interpreter, asked = Interpreter(pythons=(python,)), stated(f"x; {marker}")
    assert (interpreter.may(asked), interpreter.must(asked)) == (may, must)


@pytest.mark.parametrize(
    ("text", "fitting"),
    [
        ("~=3.8.2", ["3.8"]),
        ("!=3.9.*", ["3.7", "3.8", "3.10"]),
        ("<3.8.10", ["3.7", "3.8"]),
        (">=3.8.2", ["3.8", "3.9", "3.10"]),
        ("==3.8.*", ["3.8"]),
        ("==3.8", ["3.8"]),
        ("^3.8", ["3.8", "3.9", "3.10"]),
        ("~3.8", ["3.8"]),
        ("3.9", ["3.9"]),
        ("=3.9", ["3.9"]),
        (">=3.9.*", ["3.9", "3.10"]),
        (">3.9", ["3.9", "3.10"]),
        ("(>=3.8,<3.10)", ["3.8", "3.9"]),
    ],
)
def test_pythons_that_are_admitted(text: str, fitting: list[str]) -> None:
    allowed = specifiers(text)
    assert allowed is not None
    assert [python for python in ("3.7", "3.8", "3.9", "3.10") if admits(allowed, python)] == fitting


def test_a_specifier_that_is_none() -> None:
    assert specifiers("any") is None


@pytest.mark.parametrize(
    ("text", "name", "release", "build"),
    [
        ("pytorch::pytorch=1.12.1=py3.8_cuda11.3", "pytorch", "1.12.1", "py3.8_cuda11.3"),
        ("python 3.8", "python", None, ""),
        ("numpy>=1.2,<2", "numpy", None, ""),
        ("numpy=1.19.*", "numpy", "1.19", ""),
        ("PyYAML", "pyyaml", None, ""),
        ("ruamel_yaml==0.15", "ruamel-yaml", "0.15", ""),
    ],
)
def test_packages_of_conda(text: str, name: str, release: str | None, build: str) -> None:
    package = conda_package(text)
    assert package is not None
    assert (package.name, package.release, package.build) == (name, release, build)


@pytest.mark.parametrize("text", ["", "path/to/env.yml", "<name>", "--file"])
def test_no_package_of_conda(text: str) -> None:
    assert conda_package(text) is None


NUMBERS = ("0", "1", "1.0", "1.2", "1.2.0", "1.2.3", "1.10", "2", "02.0.0.1")
PARTS = [
    *(f"{sign}{number}" for sign in ("==", "!=", ">=", "<=", ">", "<") for number in NUMBERS),
    *(f"{sign}{number}.*" for sign in ("==", "!=") for number in NUMBERS),
    *(f"~={number}" for number in NUMBERS if "." in number),
]


@pytest.mark.parametrize("text", [*PARTS, *map(",".join, product(PARTS[::7], PARTS[::5])), "", " >=1 , < 2 "])
def test_plain_numbers_are_compared_as_the_standard_says(text: str) -> None:
    found, standard = specifiers(text), SpecifierSet(text)
    assert isinstance(found, Specifiers)
    for version in (*NUMBERS, "1.2rc1", "1.2.3+cu117", "1.2.post1", "2.dev0"):
        for early in (None, True, False):
            asked = (version, early)
            assert (asked, found.contains(version, prereleases=early)) == (
                asked,
                standard.contains(version, prereleases=early),
            )
    assert [(each.operator, each.version) for each in found] == [(each.operator, each.version) for each in standard]
    assert list(map(str, found)) == list(map(str, standard))
    assert (str(found), bool(found)) == (str(standard), bool(standard))


@pytest.mark.parametrize("text", [">=1.0.*", "~=1", "===1", "==1.0rc1", "==1.0+local", ">=1,", "==v1", "> = 1"])
def test_what_is_not_plain_is_the_librarys(text: str) -> None:
    assert not isinstance(specifiers(text), Specifiers)


@pytest.mark.parametrize(
    "text",
    ["a", "A.b_c-1", "numpy==1.26.4", "a >= 1 , < 2", "a[b]", "a [ b , c,b ] ~= 1.2", "a==1.*", "python-a9>1"],
)
def test_a_plain_line_is_read_as_the_standard_says(text: str) -> None:
    found, standard = requirement(text, "manifest"), Standard(text)
    assert found
    assert isinstance(found.specifier, Specifiers)
    assert (found.name, found.extras) == (standard.name, tuple(sorted(standard.extras)))
    assert found.written == "".join(text.split())
    assert str(found.specifier) == str(standard.specifier)
    assert (found.url, found.marker, found.role) == ("", None, "")
