"""An author's Dockerfile that compiles what stops without a GPU: it is not built, and that is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

URL = "https://github.com/fundamentalvision/Deformable-DETR"
FOLDER = "Deformable-DETR-main/models/ops"
STOPPING = """\
import torch
from setuptools import setup
from torch.utils.cpp_extension import CUDAExtension

if torch.cuda.is_available():
    modules = [CUDAExtension("ops", ["ops.cu"])]
else:
    raise NotImplementedError("no CUDA")
setup(name="ops", ext_modules=modules)
"""


def decided(folder: Path, steps: str, config: str = "", setup: str = STOPPING) -> Decision:
    base = "pytorch/pytorch:1.13.1-cuda11.6-cudnn8-devel"
    files = {
        "requirements.txt": "torch==1.13.1\n",
        "main.py": "import torch\n\nprint(torch.ones(1).cuda())\n",
        "Dockerfile": f"FROM {base}\nCOPY . /app\nWORKDIR /app\n{steps}\nCMD python main.py\n",
        "own/ops/setup.py": setup,
        "roslab.yaml": f"format: 3\n{config}",
    }
    for path, text in files.items():
        (folder / path).parent.mkdir(exist_ok=True, parents=True)
        (folder / path).write_text(text, encoding="utf-8")
    return plan_repository(folder).decision


def told(found: Decision) -> list[str]:
    return [each.message for each in found.warnings if "sees no GPU, as in every build" in each.message]


@pytest.mark.parametrize(
    ("steps", "line"),
    [
        (
            f"RUN wget {URL}/archive/main.zip && \\\n unzip main.zip && \\\n cd {FOLDER} && \\\n sh ./make.sh",
            7,
        ),
        (f"RUN git clone {URL}.git\nRUN cd Deformable-DETR/models/ops && pip install .", 5),
        (f"RUN pip install 'git+{URL}.git#subdirectory=models/ops'", 4),
        (f"RUN git clone {URL} && pip install ./Deformable-DETR/models/ops", 4),
    ],
)
def test_what_is_fetched_and_known_to_stop(tmp_path: Path, steps: str, line: int) -> None:
    found = decided(tmp_path, steps)
    assert found.dockerfile is None
    (message,) = told(found)
    assert message.startswith(f"Dockerfile is not built: line {line} compiles models/ops of {URL}")
    assert "#subdirectory=models/ops' in a container with --gpus all".replace("' in", "'` in") in message
    assert "`dockerfile: Dockerfile`" in message


def test_a_project_of_the_tree_that_stops(tmp_path: Path) -> None:
    found = decided(tmp_path, "RUN cd own/ops && pip install .")
    assert found.dockerfile is None
    messages = told(found)
    assert any("line 4 compiles own/ops" in message for message in messages), found.warnings


@pytest.mark.parametrize(
    "steps",
    [
        f"RUN git clone {URL}",
        f"RUN git clone {URL} && cd Deformable-DETR/models/ops && sed -i s/X/True/ setup.py && pip install .",
        "RUN git clone https://github.com/someone/Deformable-DETR && pip install ./Deformable-DETR/models/ops",
        "RUN pip install numpy",
    ],
)
def test_what_does_not_stop_is_built(tmp_path: Path, steps: str) -> None:
    found = decided(tmp_path, steps)
    assert found.dockerfile == "Dockerfile"
    assert told(found) == []


def test_a_setup_that_goes_on_without_a_gpu(tmp_path: Path) -> None:
    found = decided(
        tmp_path, "RUN pip install ./own/ops", setup=STOPPING.replace("raise NotImplementedError(", "print(")
    )
    assert found.dockerfile == "Dockerfile"


def test_the_author_has_it_built_all_the_same(tmp_path: Path) -> None:
    steps = f"RUN pip install 'git+{URL}.git#subdirectory=models/ops'"
    assert decided(tmp_path, steps, "dockerfile: Dockerfile\n").dockerfile == "Dockerfile"
