"""The pip of an author's Dockerfile that upgrades it to the newest, which builds without what is installed."""

from __future__ import annotations

from pathlib import Path

import pytest
from packaging.requirements import Requirement

from roslab.pipeline import plan_repository
from roslab.plan.author_bases import Base
from roslab.plan.plan import Plan
from roslab.render import bases as rendered
from trees import commit, tree_of

IMAGE = "pytorch/pytorch:1.13.1-cuda11.6-cudnn8-devel"
GIT = "git+https://github.com/facebookresearch/pytorch3d.git@v0.7.2"
ARCHIVE = "https://github.com/facebookresearch/pytorch3d/archive/stable.zip"
SETUP = "import torch\nfrom setuptools import setup\n\nsetup(name='ops')\n"
BEFORE, AFTER = "2025-01-25", "2025-11-01"


def planned(folder: Path, steps: str, day: str | None = BEFORE, base: str = IMAGE, **files: str) -> Plan:
    written = {
        "requirements.txt": f"numpy\n{ARCHIVE}\n",
        "main.py": "import torch\n\nprint(torch.ones(1))\n",
        "Dockerfile": f"FROM {base}\nCOPY . /app\nWORKDIR /app\n{steps}\n",
        "roslab.yaml": "format: 3\nkind: python\ndockerfile: Dockerfile\npip_date: today\n",
        **files,
    }
    tree_of(folder, written)
    if day:
        commit(folder, day)
    return plan_repository(folder).plan


def bases(plan: Plan) -> tuple[Base, ...]:
    assert plan.author_dockerfile
    return plan.author_dockerfile.bases


UPGRADE = "RUN python -m pip install --upgrade pip"


@pytest.mark.parametrize(
    "steps",
    [
        f"{UPGRADE} && \\\n    python -m pip install --no-cache-dir -r ./requirements.txt",
        f"RUN pip3 install -U pip setuptools wheel\nRUN pip3 install {GIT}",
        f"RUN pip install -qU pip\nRUN pip install 'pytorch3d @ {GIT}'",
        f"{UPGRADE}\nRUN cd ops && pip install .",
        f"{UPGRADE}\nRUN pip install -e ./ops",
    ],
)
def test_pip_stays_as_it_was_where_a_setup_needs_what_is_installed(tmp_path: Path, steps: str) -> None:
    plan = planned(tmp_path, steps, **{"ops/setup.py": SETUP})
    (base,) = bases(plan)
    assert (base.name, base.image, base.sources, base.rosdistro_tag) == (IMAGE, IMAGE, None, None)
    (bound,) = map(Requirement, base.installers)
    assert (bound.name, str(bound.specifier)) == ("pip", "<25.3")
    assert "upgrades pip to the newest" in base.why
    assert "without the torch that is installed" in base.why
    text = rendered.bases((base,), "demo")
    assert f"FROM {IMAGE} AS base-1" in text
    assert "pip<25.3" in text
    assert "ENV PIP_CONSTRAINT=" in text


@pytest.mark.parametrize(
    "steps",
    [
        f"RUN pip install {GIT}",  # the pip of the image
        f"RUN pip install --upgrade 'pip<24'\nRUN pip install {GIT}",
        f"RUN pip install --upgrade pip==23.0\nRUN pip install {GIT}",
        f"RUN pip install --upgrade numpy\nRUN pip install {GIT}",
        f"RUN pip install {GIT}\n{UPGRADE}",
        f"{UPGRADE}\nRUN pip install --no-build-isolation {GIT}",
        f"{UPGRADE}\nRUN pip install --no-build-isolation -r requirements.txt",
        f"{UPGRADE}\nRUN pip install numpy",
        f"{UPGRADE}\nRUN pip install git+https://github.com/psf/requests",
        f"{UPGRADE}\nRUN pip install ./plain",
        f"{UPGRADE}\nRUN pip install ./stated",
        f"RUN echo pip install --upgrade pip\nRUN pip install {GIT}",
    ],
)
def test_the_image_stays_where_the_newest_pip_is_as_good(tmp_path: Path, steps: str) -> None:
    files = {
        "plain/setup.py": "from setuptools import setup\n\nsetup(name='plain')\n",
        "stated/setup.py": SETUP,
        "stated/pyproject.toml": '[build-system]\nrequires = ["setuptools", "torch"]\n',
    }
    assert bases(planned(tmp_path, steps, **files)) == ()


@pytest.mark.parametrize("day", [AFTER, None])
def test_what_was_written_for_that_pip_or_on_no_known_day_gets_it(tmp_path: Path, day: str | None) -> None:
    assert bases(planned(tmp_path, f"{UPGRADE}\nRUN pip install {GIT}", day)) == ()


def test_nothing_is_bounded_where_the_author_does_not_want_it(tmp_path: Path) -> None:
    config = "format: 3\nkind: python\ndockerfile: Dockerfile\nrepair: false\n"
    plan = planned(tmp_path, f"{UPGRADE}\nRUN pip install {GIT}", **{"roslab.yaml": config})
    assert bases(plan) == ()


def test_the_bound_comes_behind_those_of_an_image_that_ended(tmp_path: Path) -> None:
    steps = f"RUN pip3 install -U pip\nRUN pip3 install {GIT}"
    (base,) = bases(planned(tmp_path, steps, base="nvidia/cuda:11.3.1-devel-ubuntu18.04"))
    assert base.sources
    assert base.installers[-1].startswith("pip<25.3")
    assert [Requirement(line).name for line in base.installers].count("pip") > 1


def test_only_the_image_in_which_it_is_upgraded_is_replaced(tmp_path: Path) -> None:
    steps = f"{UPGRADE}\nRUN pip install {GIT}\nFROM python:3.12\nCOPY --from=0 /opt /opt\nCOPY . /app"
    assert [base.name for base in bases(planned(tmp_path, steps))] == [IMAGE]
