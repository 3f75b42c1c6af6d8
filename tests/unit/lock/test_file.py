"""roslab.lock as a file: read back as it was written, refused where it was not."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from roslab.errors import ConfigurationError
from roslab.pipeline import plan_repository
from roslab.plan.lock import from_text, to_text, use, without
from roslab.plan.locked import Distribution, Environment, Lock, LockedSource, Machine, Missing, Package
from roslab.plan.plan import from_json, to_json
from roslab.render.dockerfile import dockerfile, question

DIGEST = "sha256:" + "1" * 64
HASH = "sha256:" + "2" * 64


def package(name: str, version: str, step: str = "packages", architecture: str = "amd64") -> Package:
    return Package(name=name, version=version, architecture=architecture, source=name, origin="", step=step)


def pip(name: str, version: str, *hashes: str, url: str = "") -> Distribution:
    return Distribution(name=name, version=version, hashes=hashes, url=url)


def machine(platform: str = "linux/amd64", **changes: Any) -> Machine:
    environment = Environment(name="image", packages=(pip("numpy", "1.26.4", HASH), pip("pip", "24.0", HASH)))
    made = Machine(
        platform=platform,
        apt=(package("libc6", "2.36-9", "base"), package("libeigen3-dev", "3.4.0-4", architecture="all")),
        python=(environment,),
        conda=(),
    )
    return dataclasses.replace(made, **changes)


def lock(*machines: Machine, **changes: Any) -> Lock:
    made = Lock(
        base="ubuntu:24.04",
        digest=DIGEST,
        python="venv 3.12",
        rosdistro=None,
        tools=(("roslab", "1.0.0"),),
        sources=(LockedSource(name="ceres", url="https://github.com/ceres-solver/ceres-solver.git", commit="3" * 40),),
        machines=machines or (machine(),),
    )
    return dataclasses.replace(made, **changes)


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    (tmp_path / "roslab.yaml").write_text(
        "format: 3\nkind: python\nbase: {python: '3.12'}\napt: [libeigen3-dev]\npip: [numpy]\nplatforms: linux/amd64\n"
    )
    (tmp_path / "main.py").write_text("print('hello')\n")
    return tmp_path


def text_of(repository: Path) -> str:
    return dockerfile(plan_repository(repository).plan)


def test_it_is_read_back_as_it_was_written() -> None:
    made = lock(machine(), machine("linux/arm64", conda=(f"https://conda.anaconda.org/x/a-1-0.conda#{'4' * 32}",)))
    text = to_text(made)
    assert from_text(text) == made
    assert to_text(from_text(text)) == text
    assert text.count('"name": "libeigen3-dev"') == 2
    assert all(line.count('"name"') <= 1 for line in text.splitlines()), "one row a line"


def test_what_fits_the_schema_is_what_is_written() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((Path(use.__code__.co_filename).parent / "lock.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    validator.validate(json.loads(to_text(lock())))
    data = json.loads(to_text(lock()))
    data["platforms"]["linux/amd64"]["apt"][0]["version"] = "1.0; reboot"
    assert not validator.is_valid(data)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda d: d.update(version=2), "its format has version 2"),
        (lambda d: d.pop("sources"), "no lock: KeyError: 'sources'"),
        (lambda d: d["base"].update(digest="latest"), "'latest' is no digest"),
        (lambda d: d["platforms"]["linux/amd64"]["apt"][0].update(version="1 && reboot"), "is no version"),
        (lambda d: d["platforms"]["linux/amd64"]["apt"][0].update(name="-o"), "'-o' is no name"),
        (lambda d: d["platforms"]["linux/amd64"]["apt"][0].pop("step"), "a row has the fields"),
        (lambda d: d["platforms"]["linux/amd64"]["pip"]["image"][0].update(url="https://a/b; reboot\nEOF"), "no url"),
        (lambda d: d.update(materials=[{"source": "x", "digest": "sha256:1"}]), "'sha256:1' is no digest"),
        (lambda d: d["sources"][0].update(commit="main"), "'main' is no commit"),
    ],
)
def test_anything_else_is_refused_with_what_to_do(change: Callable[[dict[str, Any]], Any], message: str) -> None:
    data = json.loads(to_text(lock()))
    change(data)
    with pytest.raises(ConfigurationError) as raised:
        from_text(json.dumps(data))
    (problem,) = raised.value.problems
    assert message in problem.message
    assert problem.file == "roslab.lock"
    assert "roslab build --no-lock" in (problem.hint or "")


def test_each_step_gets_its_own_versions_and_nothing_else(repository: Path) -> None:
    before = text_of(repository)
    assert "lock" not in before.partition("\nFROM ubuntu")[2].replace("sharing=locked", "")
    (repository / "roslab.lock").write_text(to_text(lock()))
    text = text_of(repository)
    assert f"FROM ubuntu:24.04@{DIGEST}\n" in text
    pinned = text.partition("/usr/local/share/roslab/lock/apt-packages\n")[2].partition("EOF")[0]
    assert pinned == "libeigen3-dev 3.4.0-4\n", "the base's own packages come with its digest"
    assert "\\\n    pin-packages apt-packages \\\n && apt-get update" in text
    assert " && rm /etc/apt/preferences.d/roslab-lock" in text
    assert f"\nnumpy==1.26.4 --hash={HASH}\n" in text
    assert "--no-deps --require-hashes --requirement /usr/local/share/roslab/lock/pip-image" in text


def test_a_new_version_of_pip_repeats_no_step_of_apt(repository: Path) -> None:
    (repository / "roslab.lock").write_text(to_text(lock()))
    old = text_of(repository)
    newer = Environment(name="image", packages=(pip("numpy", "2.0.0", HASH),))
    (repository / "roslab.lock").write_text(to_text(lock(machine(python=(newer,)))))
    new = text_of(repository)
    (first,) = [i for i, (a, b) in enumerate(zip(old.splitlines(), new.splitlines(), strict=False)) if a != b][:1]
    assert "numpy" in new.splitlines()[first] or "lock/" in new.splitlines()[first]
    assert old.index("    pin-packages apt") < sum(len(line) + 1 for line in old.splitlines()[:first])


def test_what_differs_by_machine_is_told_apart(repository: Path) -> None:
    other = machine(
        "linux/arm64",
        apt=(package("libeigen3-dev", "3.4.0-5", architecture="all"),),
        python=(Environment(name="image", packages=(pip("numpy", "1.26.4", "sha256:" + "5" * 64),)),),
    )
    (repository / "roslab.lock").write_text(to_text(lock(machine(), other)))
    text = text_of(repository)
    assert "libeigen3-dev 3.4.0-4 amd64\nlibeigen3-dev 3.4.0-5 arm64\n" in text
    assert f"numpy==1.26.4 --hash={HASH} --hash=sha256:{'5' * 64}\n" in text
    assert "pip==24.0; platform_machine == 'x86_64' --hash" in text


def test_a_commit_of_git_has_no_hash(repository: Path) -> None:
    from_git = pip("robot", "1.0", url=f"git+https://github.com/a/robot@{'6' * 40}")
    made = lock(machine(python=(Environment(name="image", packages=(from_git,)),)))
    (repository / "roslab.lock").write_text(to_text(made))
    text = text_of(repository)
    assert f"\ngit+https://github.com/a/robot@{'6' * 40}#egg=robot\n" in text
    assert "--require-hashes" not in text


def test_a_clone_that_is_installed_editable_comes_at_its_commit_in_its_own_step(repository: Path) -> None:
    page = "git clone -b v1 https://github.com/a/robot.git\ncd robot/python\npip install {}.\n"
    url, commit = "git+https://github.com/a/robot.git", "6" * 40
    from_git = pip("robot", "1.0", url=f"{url}@{commit}#subdirectory=python")
    made = lock(machine(python=(Environment(name="image", packages=(from_git,)),)))
    for option, line in (
        ("-e ", f" --editable={url}@{commit}#subdirectory=python'"),
        ("", f"\n{url}@{commit}#subdirectory=python&egg=robot\n"),
    ):
        (repository / "README.md").write_text(f"# Install\n```\n{page.format(option)}```\n")
        (repository / "roslab.lock").unlink(missing_ok=True)
        assert f"{url}@v1#subdirectory=python'" in text_of(repository)
        (repository / "roslab.lock").write_text(to_text(made))
        text = text_of(repository).replace(" '", " ")
        assert line in text
        assert ("pip-unchecked" in text) == (not option)


def test_a_lock_of_another_base_or_python_is_told(repository: Path) -> None:
    (repository / "roslab.lock").write_text(to_text(lock(base="python:3.8-slim", python="conda 3.8")))
    with pytest.raises(ConfigurationError) as raised:
        plan_repository(repository)
    said = [problem.message for problem in raised.value.problems]
    assert said == [
        "it was made for the base python:3.8-slim, and the plan has ubuntu:24.04",
        "it was made for Python conda 3.8, and the plan has venv 3.12",
    ]
    assert plan_repository(repository, locked=False).plan.lock is None


def test_it_goes_with_the_plan_from_job_to_job(repository: Path) -> None:
    (repository / "roslab.lock").write_text(to_text(lock()))
    plan = plan_repository(repository).plan
    assert plan.lock == lock()
    assert from_json(to_json(plan)) == plan


def test_what_is_gone_is_not_asked_for_any_more(repository: Path) -> None:
    (repository / "roslab.lock").write_text(to_text(lock()))
    plan = plan_repository(repository).plan
    gone = [
        Missing(kind="apt", name="libeigen3-dev", wanted="3.4.0-4", nearest="3.4.1"),
        Missing(kind="pip", name="numpy", wanted="1.26.4", nearest=None),
        Missing(kind="base", name="ubuntu:24.04", wanted=DIGEST, nearest=None),
    ]
    text = dockerfile(without(plan, gone))
    assert "FROM ubuntu:24.04\n" in text
    assert "pin-packages" not in text
    assert "numpy==" not in text
    assert "pip==24.0" in text
    assert without(plan, []) == plan


def test_the_question_names_what_the_steps_would_pin(repository: Path) -> None:
    (repository / "roslab.lock").write_text(to_text(lock()))
    text = question(plan_repository(repository).plan)
    assert "\nlibeigen3-dev 3.4.0-4\nEOF\n" in text
    assert "libc6" not in text
    assert text.endswith("FROM scratch\nCOPY --from=base /answer /\n")
