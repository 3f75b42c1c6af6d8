"""What an author's old Dockerfile has pip install without a version: it is of the day of the last commit."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.author_bases import Base
from roslab.plan.plan import Plan
from roslab.render import bases as rendered
from trees import commit, tree_of

IMAGE = "python:3.9-slim-bookworm"
OLD, YOUNG = "2021-06-01", "2026-11-01"
FREE = "RUN pip install opencv-python"


def planned(folder: Path, steps: str, day: str = OLD, base: str = IMAGE, config: str = "", **files: str) -> Plan:
    written = {
        "main.py": "print(1)\n",
        "Dockerfile": f"FROM {base}\nCOPY . /app\nWORKDIR /app\n{steps}\n",
        "roslab.yaml": f"format: 3\nkind: python\ndockerfile: Dockerfile\n{config}",
        **files,
    }
    tree_of(folder, written)
    commit(folder, day)
    return plan_repository(folder).plan


def bases(plan: Plan) -> tuple[Base, ...]:
    assert plan.author_dockerfile
    return plan.author_dockerfile.bases


@pytest.mark.parametrize(
    ("steps", "said"),
    [
        (FREE, "line 4 has pip install opencv-python without a version"),
        ("RUN apt-get update\nRUN python3 -m pip install 'numpy<1.20' flask==2.0.1", "line 5 has pip install numpy"),
        ("RUN pip3 install -r requirements.txt", "line 4 has pip install requirements.txt"),
        ("RUN pip install .", "line 4 has pip install ."),
    ],
)
def test_it_is_of_the_last_commit(tmp_path: Path, steps: str, said: str) -> None:
    files = {
        "requirements.txt": "flask==2.0.1\nrequests\n",
        "setup.py": "from setuptools import setup\nsetup(name='a')\n",
    }
    (base,) = bases(planned(tmp_path, steps, **files))
    assert (base.name, base.image, base.pip_day, base.installers) == (IMAGE, IMAGE, "2021-06-01", ())
    assert base.why.startswith(said)
    text = rendered.bases((base,), "demo")
    assert 'SHELL ["/usr/local/bin/shell-as-of", "2021-06-01"]' in text
    assert "COPY --from=scripts /index-as-of /usr/local/bin/" in text
    assert text.index("FROM scratch AS scripts") < text.index(f"FROM {IMAGE} AS base-1")


@pytest.mark.parametrize(
    "steps",
    [
        "RUN pip install flask==2.0.1",
        "RUN pip install -r requirements.txt",
        "RUN pip install git+https://github.com/psf/requests@v2.25.1",
        "RUN apt-get install -y python3-flask",
        f'SHELL ["/bin/bash", "-c"]\n{FREE}',  # it would not have the index
        f"{FREE}\nCMD ./run.sh",  # which the shell would start
        f"{FREE}\nHEALTHCHECK --interval=1m CMD python -m pip --version",
    ],
)
def test_a_dockerfile_that_says_all_versions_is_left_alone(tmp_path: Path, steps: str) -> None:
    assert bases(planned(tmp_path, steps, **{"requirements.txt": "flask==2.0.1\n"})) == ()


@pytest.mark.parametrize(
    "base",
    [
        *("alpine:3.13", "python:3.9-alpine", "ghcr.io/somebody/something:1"),
        *(
            "mambaorg/micromamba:1.5-jammy",
            "quay.io/jupyter/scipy-notebook:ubuntu-22.04",
            "somebody/something:ubuntu22.04",
        ),
    ],
)
def test_an_image_that_may_have_no_bash_or_another_shell_is_left_alone(tmp_path: Path, base: str) -> None:
    assert bases(planned(tmp_path, FREE, base=base)) == ()


@pytest.mark.parametrize("start", ["CMD python main.py", 'CMD ["./run.sh"]', 'ENTRYPOINT ["/app/run.sh"]'])
def test_what_the_shell_does_not_start_or_starts_as_ever_is_no_reason(tmp_path: Path, start: str) -> None:
    (base,) = bases(planned(tmp_path, f"{FREE}\n{start}"))
    assert base.pip_day == "2021-06-01"


def test_a_young_one_takes_what_there_is(tmp_path: Path) -> None:
    assert bases(planned(tmp_path, FREE, day=YOUNG)) == ()


@pytest.mark.parametrize("config", ["pip_date: today\n", "repair: false\n"])
def test_the_author_may_want_it_otherwise(tmp_path: Path, config: str) -> None:
    assert bases(planned(tmp_path, FREE, config=config)) == ()


def test_the_author_may_name_the_day(tmp_path: Path) -> None:
    (base,) = bases(planned(tmp_path, FREE, day=YOUNG, config="pip_date: 2022-02-02\n"))
    assert base.pip_day == "2022-02-02"


def test_it_comes_to_what_else_an_image_lacks(tmp_path: Path) -> None:
    (base,) = bases(planned(tmp_path, "RUN pip3 install requests", base="ubuntu:18.04"))
    assert base.sources
    assert base.pip_day == "2021-06-01"
    assert "bionic ended" in base.why
    assert "requests" in base.why


def test_only_the_image_in_which_it_is_installed_gets_it(tmp_path: Path) -> None:
    steps = f"{FREE}\nFROM debian:12\nCOPY --from=0 /usr/local /usr/local\nCOPY . /app"
    assert [base.name for base in bases(planned(tmp_path, steps)) if base.pip_day] == [IMAGE]


def test_a_stage_on_another_stage_installs_in_the_image_of_that(tmp_path: Path) -> None:
    steps = f"FROM debian:12 AS two\nFROM one\n{FREE}\nCOPY . /app"
    plan = planned(tmp_path, steps, base=f"{IMAGE} AS one")
    assert [base.name for base in bases(plan) if base.pip_day] == [IMAGE]
