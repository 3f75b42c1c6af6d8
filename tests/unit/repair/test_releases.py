"""A pinned release that the index has not: the nearest one that it has."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.config.addition import added
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.change import Repair
from roslab.repair.repair import repair
from trees import tree_of

CODE = {"main.py": "import six\n"}
PYTHON = "format: 3\nkind: python\n"


def log(pinned: str, listed: str, by: str = "") -> str:
    return (
        "#6 [3/4] RUN pip install -r requirements.txt\n"
        f"#6 1.2 ERROR: Could not find a version that satisfies the requirement {pinned}{by} "
        f"(from versions: {listed})\n"
        f"#6 1.3 ERROR: No matching distribution found for {pinned}\n"
        '#6 ERROR: process "/bin/sh -c pip install -r requirements.txt" did not complete: exit code: 1\n'
    )


def repaired(folder: Path, files: dict[str, str], text: str) -> Repair:
    tree_of(folder, {**CODE, "roslab.yaml": PYTHON, **files})
    return repair(explain(io.BytesIO(text.encode())), given(plan_repository(folder)))


@pytest.mark.parametrize(
    ("pinned", "listed", "taken"),
    [
        ("six==1.99", "1.9.0, 1.16.0, 1.17.0", "six==1.17.0"),
        ("six==1.12.5", "1.9.0, 1.13.0, 1.17.0", "six==1.13.0"),
        ("six==1.12.5", "1.9.0, 1.13.0rc1, 2.0.0", "six==1.9.0"),
        ("six==1.12.5rc1", "1.9.0, 1.13.0rc1, 2.0.0", "six==1.13.0rc1"),
        ("six==1.12.5+cu110", "1.9.0, 1.12.5, 1.13.0", "six==1.12.5"),
        ("six==1.12.5+cu110", "1.9.0, 1.13.0", "six==1.13.0"),
        ("six[all]==1.99", "1.9.0, 1.17.0", "six[all]==1.17.0"),
        ("six==3.0", "1.9.0, 2.0.0", ""),
        ("six==1.2", "1.9.0, 1.17.0", ""),  # all are newer: this Python is too new for it
        ("six==1.99", "none", ""),
        ("six>=1.99", "1.9.0, 1.17.0", ""),
    ],
)
def test_the_nearest_release_with_the_same_first_number_is_taken(
    tmp_path: Path, pinned: str, listed: str, taken: str
) -> None:
    found = repaired(tmp_path, {"requirements.txt": f"attrs\n{pinned}\n"}, log(pinned, listed))
    assert [(change.value, change.certain, str(change.asked.place)) for change in found.changes] == (
        [(taken, True, "requirements.txt:2")] if taken else []
    )


def test_with_it_the_image_can_be_planned(tmp_path: Path) -> None:
    found = repaired(tmp_path, {"requirements.txt": "attrs\nsix==1.99\n"}, log("six==1.99", "1.16.0, 1.17.0"))
    text = added(PYTHON, found.entries)
    assert text == f'{PYTHON}pip:\n  - "six==1.17.0"  # for the package six (requirements.txt:2)\n'
    tree_of(tmp_path, {"roslab.yaml": text})
    plan = plan_repository(tmp_path).plan
    assert (plan.python.pip, plan.python.requirements) == (("six==1.17.0", "attrs", "six"), ())


def test_roslab_yaml_s_own_pin_is_replaced(tmp_path: Path) -> None:
    config = f"{PYTHON}pip: [attrs, six==1.99]\n"
    found = repaired(tmp_path, {"roslab.yaml": config}, log("six==1.99", "1.16.0, 1.17.0"))
    assert added(config, found.entries) == f"{PYTHON}pip: [attrs, six==1.17.0]\n"


def test_what_another_package_pins_is_left(tmp_path: Path) -> None:
    found = repaired(tmp_path, {"requirements.txt": "robot\n"}, log("six==1.99", "1.17.0", by=" (from robot)"))
    assert found.changes == ()
    assert found.refused == (("pip-no-version", "another package asks for six==1.99: pin one that does not"),)


def test_of_a_list_that_is_cut_only_what_is_whole_counts(tmp_path: Path) -> None:
    versions = ", ".join(f"1.{minor}.{patch}" for minor in range(60) for patch in range(10))
    files = {"requirements.txt": "six==1.2.77\n"}
    assert repaired(tmp_path, files, log("six==1.2.77", versions)).changes[0].value == "six==1.3.0"
    files = {"requirements.txt": "six==1.30.77\n"}
    assert repaired(tmp_path, files, log("six==1.30.77", versions)).changes == ()


GONE = (
    '#6 [3/4] RUN pip install -r requirements.txt\n#6 1.2 {}\n#6 ERROR: process "/bin/sh -c pip install -r '
    'requirements.txt" did not complete: exit code: 1\n'
)


@pytest.mark.parametrize(
    ("line", "project", "taken", "what"),
    [
        ("error: 'PyThreadState' {aka 'struct _ts'} has no member named 'use_tracing'", "", "3.9", "PyThreadState.use"),
        ("error: '_PyCFrame' {aka 'struct _PyCFrame'} has no member named 'use_tracing'", "3.12", "3.11", "_PyCFrame"),
        ("error: 'PyThreadState' has no member named 'robot'", "", "", ""),
        ("a.c:7:1: error: invalid use of incomplete typedef 'PyFrameObject' {aka 'struct _frame'}", "", "", ""),
        ("fatal error: longintrepr.h: No such file or directory", "3.12", "3.10", "longintrepr.h"),
        ("a.cpp:7:1: error: 'PyUnicode_GET_SIZE' was not declared in this scope", "3.12", "3.11", "PyUnicode_GET_SIZE"),
        ("ImportError: a.so: undefined symbol: PyEval_CallObjectWithKeywords", "3.13", "3.12", "PyEval_CallObject"),
        ("ImportError: cannot import name 'Mapping' from 'collections' (/a.py)", "", "3.9", "collections.Mapping"),
        ("AttributeError: module 'time' has no attribute 'clock'", "", "3.7", "time.clock"),
        ("AttributeError: 'HTMLParser' object has no attribute 'unescape'", "", "3.8", "HTMLParser.unescape"),
        ("error: 'PyThreadState {aka struct _ts}' has no member named 'exc_type'", "", "3.6", "PyThreadState.exc_type"),
        ("a.c:7:1: error: no member named 'curexc_type' in 'struct _ts'", "3.12", "3.11", "PyThreadState.curexc_type"),
        ("a.c:7:1: error: 'PyTypeObject' has no member named 'tp_print'", "", "3.8", "PyTypeObject.tp_print"),
        ("a.c:7:1: error: call to undeclared function '_PyGC_FINALIZED'; ISO", "3.13", "3.12", "_PyGC_FINALIZED"),
        ("ModuleNotFoundError: No module named 'imp'", "3.12", "3.11", "imp"),
        ("ModuleNotFoundError: No module named 'imp'", ">=3.12", "", ""),
    ],
)
def test_what_newer_pythons_no_longer_have_takes_an_older_one(
    tmp_path: Path, line: str, project: str, taken: str, what: str
) -> None:
    config = f'{PYTHON}base: {{python: "{project}"}}\n' if project[:1] == "3" else PYTHON
    own = f'[project]\nname = "robot"\nversion = "1"\nrequires-python = "{project}"\n' if project[:1] == ">" else ""
    files = {"roslab.yaml": config, **({"pyproject.toml": own} if own else {})}
    found = repaired(tmp_path, {**files, "requirements.txt": "attrs\n"}, GONE.format(line))
    assert [(each.key, each.value) for each in found.changes] == ([("base.python", taken)] if taken else [])
    assert all(each.certain == (not project) and each.asked.what.startswith(f"{what}") for each in found.changes)


NODE = "<package><name>robot</name><version>1.0.0</version><buildtool_depend>ament_cmake</buildtool_depend></package>"
OF_ROS = {"package.xml": NODE, "CMakeLists.txt": "project(robot)\n", "roslab.yaml": "format: 3\nbase: {ros: jazzy}\n"}
THREAD = "/tmp/pip-install-a1b2c3d4/cython_0123456789abcdef0123456789abcdef/a.c:7:1: error: "
THREAD += "'PyThreadState' {aka 'struct _ts'} has no member named 'exc_type'"


def test_ros_keeps_its_python(tmp_path: Path) -> None:
    found = repaired(tmp_path, OF_ROS, GONE.format("ModuleNotFoundError: No module named 'imp'"))
    assert found.changes == ()
    assert "the Python of ROS jazzy cannot be exchanged" in found.refused[0][1]


@pytest.mark.parametrize(
    ("files", "taken", "instead"),
    [
        ({"requirements.txt": "attrs\nCython==0.22.0\n"}, "Cython>0.22.0", ""),
        ({"roslab.yaml": f"{OF_ROS['roslab.yaml']}pip: [cython==0.22.0]\n"}, "cython>0.22.0", "cython==0.22.0"),
        ({"requirements.txt": "attrs\nCython\n"}, "", ""),
        ({"requirements.txt": "attrs==0.22.0\n"}, "", ""),
    ],
)
def test_there_a_newer_release_than_the_pinned_one_is_taken(
    tmp_path: Path, files: dict[str, str], taken: str, instead: str
) -> None:
    found = repaired(tmp_path, {**OF_ROS, **files}, GONE.format(THREAD))
    changes = [(each.key, each.value, each.instead, each.certain) for each in found.changes]
    assert changes == ([("pip", taken, instead, True)] if taken else [])
    assert bool(found.refused) == (not taken)
    tree_of(tmp_path, {"roslab.yaml": added((tmp_path / "roslab.yaml").read_text(), found.entries)})
    planned = plan_repository(tmp_path).plan.python.pip
    assert not taken or (taken in planned and "Cython==0.22.0" not in planned)


PROJECT = '[project]\nname = "robot"\nversion = "1"\ndependencies = ["jinja2{}"]\n'
ESCAPE = "ImportError: cannot import name 'escape' from 'jinja2' (/opt/venv/jinja2/__init__.py)"
JOBLIB = "ModuleNotFoundError: No module named 'sklearn.externals.joblib'"
BLUR = "ImportError: cannot import name 'gaussian_blur2d' from 'kornia' (/opt/venv/kornia/__init__.py)"
APPEND = "AttributeError: 'DataFrame' object has no attribute 'append'"
FLASK = '  File "/opt/venv/lib/python3.10/site-packages/flask/__init__.py", line 19, in <module>\n'
TRACE = 'Traceback (most recent call last):\n  File "/home/jovyan/robot/main.py", line 1, in <module>\n'


@pytest.mark.parametrize(
    ("asked", "python", "said", "taken"),
    [
        ("jinja2", "3.10", ESCAPE, "jinja2<3.1"),
        ("jinja2>=2.11", "3.10", ESCAPE, "jinja2<3.1"),
        (
            "jinja2==3.1.4",
            "3.10",
            ESCAPE,
            "not: requirements.txt:1 asks for jinja2==3.1.4: take a release of jinja2<3.1",
        ),
        ("jinja2>=3.1", "3.10", ESCAPE, "not: requirements.txt:1 asks for jinja2>=3.1: take a release of jinja2<3.1"),
        ("jinja2==2.11.3", "3.10", ESCAPE, "jinja2<3.1"),
        ("flask==1.1.2\njinja2==3.1.4", "3.10", FLASK + ESCAPE, "jinja2<3.1"),
        ("scikit-learn", "3.8", JOBLIB, "scikit-learn<0.23, numpy<2"),
        ("kornia", "3.10", BLUR, "kornia<0.6, numpy<2"),
        ("kornia", "3.10", "AttributeError: module 'kornia' has no attribute 'ssim'", "kornia<0.6, numpy<2"),
        ("kornia", "3.10", BLUR.replace("'kornia'", "'kornia.x'"), "not: Take versions that fit each other"),
        ("pandas", "3.11", APPEND, "pandas<2, numpy<2"),
        ("pandas\nnumpy>=2", "3.11", APPEND, "pandas<2"),
        (
            "scikit-learn",
            "3.10",
            JOBLIB,
            "not: scikit-learn<0.23 has no wheel for Python 3.10: `base.python: '3.8'` has one",
        ),
        ("six", "3.10", ESCAPE.replace("escape", "robot"), "not: Take versions that fit each other"),
    ],
)
def test_a_release_that_still_has_a_name_is_taken(
    tmp_path: Path, asked: str, python: str, said: str, taken: str
) -> None:
    files = {"requirements.txt": f"{asked}\n", "roslab.yaml": f"{PYTHON}base: {{python: '{python}'}}\n"}
    found = repaired(tmp_path, files, f"{TRACE}{said}\n")
    values = ", ".join(change.value for change in found.certain.changes)
    assert values == ("" if taken.startswith("not: ") else taken)
    assert not values or not found.refused
    assert values or f"not: {found.refused[0][1]}".startswith(taken)


@pytest.mark.parametrize(
    ("files", "why"),
    [
        ({"roslab.yaml": f"{PYTHON}pip: [six, jinja2==3.1.4]\n"}, "roslab.yaml:3 asks for jinja2==3.1.4: "),
        ({"pyproject.toml": PROJECT.format("==3.1.4")}, "pyproject.toml:4 asks for jinja2==3.1.4: "),
        ({"pyproject.toml": PROJECT.format(">=3"), "other/requirements.txt": "jinja2==3.1.4\n"}, ""),
    ],
)
def test_no_release_is_taken_that_somebody_else_rules_out(tmp_path: Path, files: dict[str, str], why: str) -> None:
    found = repaired(tmp_path, files, f"{TRACE}{ESCAPE}\n")
    assert [change.value for change in found.changes] == ([] if why else ["jinja2<3.1"])
    assert [reason[: len(why)] for _, reason in found.refused] == ([why] if why else [])


def test_beside_ros_no_other_python_is_named(tmp_path: Path) -> None:
    found = repaired(tmp_path, OF_ROS, f"{TRACE}{JOBLIB}\n")
    assert found.changes == ()
    assert "base.python" not in found.refused[0][1]


def test_what_pillow_is_compiled_with_is_installed(tmp_path: Path) -> None:
    said = (
        "#6 [3/4] RUN pip install -r requirements.txt\n"
        "#6 1.2       The headers or library files could not be found for jpeg,\n"
        "#6 1.2       a required dependency when compiling Pillow from source.\n"
        "#6 1.3   ERROR: Failed building wheel for pillow\n"
        '#6 ERROR: process "/bin/sh -c pip install -r requirements.txt" did not complete: exit code: 1\n'
    )
    found = repaired(tmp_path, {"requirements.txt": "pillow==7.2.0\n"}, said)
    assert [(change.key, change.value) for change in found.certain.changes] == [("apt", "libjpeg-dev")]
