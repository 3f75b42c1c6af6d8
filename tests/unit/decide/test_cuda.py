"""CUDA, and the images of plain Python and CUDA repositories."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from roslab.config.model import Base, Config
from roslab.decide.cuda.toolkit import decide_toolkit
from roslab.decide.cuda.version import Cuda
from roslab.decide.cuda.version import decide_cuda as from_pins
from roslab.decide.decision import Choice, Decision
from roslab.decide.python.base import base_for
from roslab.decide.python.packages import Chosen
from roslab.decide.python.pins import pins
from roslab.decide.python.torch_build import torch_build
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence, Mention, RequirementFile
from roslab.knowledge.frameworks import cuda_images, nearest_cuda_image
from roslab.values.conda import conda_package
from roslab.values.dataclass import replace
from roslab.values.requirement_line import stated


def asked(*lines: str) -> RequirementFile:
    requirements = tuple(stated(line, "manifest", "requirements.txt", number) for number, line in enumerate(lines, 1))
    return RequirementFile(
        file="requirements.txt",
        line=1,
        requirements=requirements,
        includes=(),
        constraints=(),
        options=(),
        purpose="run",
    )


def decide_cuda(evidence: Evidence, config: Config) -> Choice[Cuda]:
    return from_pins(evidence, config, pins(evidence))


def said(value: str, text: str = "") -> Mention:
    return Mention(topic="cuda", value=value, source="readme", file="README.md", line=1, text=text)


def python(value: str) -> Mention:
    return replace(said(value), topic="python")


@pytest.mark.parametrize(
    ("evidence", "cuda"),
    [
        (Evidence(requirements=(asked("torch==2.0.1"),)), "11.7"),
        (Evidence(requirements=(asked("torch==1.10.0+cu113"),)), "11.3"),
        (Evidence(requirements=(asked("torch==1.10.0"),)), "11.1"),  # 10.2 is gone, another wheel exists
        (Evidence(requirements=(asked("tensorflow-gpu==2.5.2"),)), "11.2"),
        (Evidence(requirements=(asked("jax[cuda11_pip]==0.4.20"),)), "11.8"),
        (Evidence(requirements=(asked("jax[cuda13]==0.10.0"),)), "13.0"),
        (Evidence(requirements=(asked("torch==2.0.1"),), mentions=(said("11.8"),)), "11.7"),
        (Evidence(requirements=(asked("torch"),), mentions=(said("11.3"),)), "11.3"),
        (Evidence(requirements=(asked("torch"),), mentions=(said("9.0", "CUDA 9.0 or above"),)), "13.0"),
        (
            Evidence(requirements=(asked("torch"),), mentions=(python("3.6"),)),
            "11.3",
        ),  # the newest for GPUs since Ampere
        (Evidence(requirements=(asked("torch<2.1"),), mentions=(python("3.8"),)), "11.7"),
        (Evidence(requirements=(asked("torch"),), mentions=(python("3.8"),)), "12.1"),
        (Evidence(cuda_files=("a.cu",)), "11.8"),
    ],
)
def test_frameworks_decide(evidence: Evidence, cuda: str) -> None:
    assert decide_cuda(evidence, Config()).answer.version == cuda


def test_nothing_asks_for_it() -> None:
    assert decide_cuda(Evidence(), Config()).answer.version is None


def test_conda_toolkit_beats_the_default_wheel() -> None:
    read = map(conda_package, ("pytorch=1.12.1", "cudatoolkit=11.6"))
    packages = tuple(package for package in read if package)
    environment = CondaEnvironment(
        file="environment.yml", line=1, name=None, python="3.9", packages=packages, requirements=(),
    )  # fmt: skip
    choice = decide_cuda(Evidence(conda=(environment,)), Config())
    assert (choice.answer.version, choice.answer.cudnn) == ("11.6", "8")
    assert [reason.answer for reason in choice.reasons] == ["11.6"]  # conda's own torch is no wheel


def test_a_deleted_image_is_replaced_with_a_warning() -> None:
    choice = decide_cuda(Evidence(requirements=(asked("tensorflow-gpu==1.13.1"),)), Config())
    assert choice.answer.version == "11.0"
    assert "CUDA 10.0" in choice.warnings[0].message
    assert choice.warnings[0].file == "requirements.txt"


def test_the_configuration_wins() -> None:
    choice = decide_cuda(Evidence(requirements=(asked("torch==2.0.1"),)), Config(base=Base(cuda="12.1")))
    assert choice.answer.version == "12.1"


@pytest.mark.parametrize(
    ("cuda", "python", "image"),
    [
        ("11.8", "3.10", "nvidia/cuda:11.8.0-cudnn8-devel-ubuntu22.04"),
        ("11.3", "3.8", "nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04"),
        ("11.3", "3.6", "nvidia/cuda:11.3.1-cudnn8-devel-ubuntu18.04"),
        ("12.1", "3.9", "nvidia/cuda:12.1.1-cudnn8-devel-ubuntu20.04"),
        ("12.8", "3.12", "nvidia/cuda:12.8.1-cudnn-devel-ubuntu24.04"),
        ("10.0", "3.6", "nvidia/cuda:11.0.3-cudnn8-devel-ubuntu18.04"),
    ],
)
def test_cuda_images(cuda: str, python: str, image: str) -> None:
    assert base_for("cuda", cuda, None, None, python)[0] == image


@pytest.mark.parametrize(
    ("python", "ubuntu", "image"),
    [
        ("3.8", None, "ubuntu:20.04"),
        ("3.10", None, "ubuntu:22.04"),
        ("3.7", None, "python:3.7-slim-bookworm"),
        ("3.7", "focal", "ubuntu:20.04"),
        ("2.7", None, "ubuntu:18.04"),
        (None, None, "ubuntu:22.04"),
    ],
)
def test_python_images(python: str | None, ubuntu: str | None, image: str) -> None:
    assert base_for("python", None, None, ubuntu, python)[0] == image


def test_every_image_row_can_be_named() -> None:
    for row in cuda_images():
        assert bool(row.tag) == bool(row.ubuntu)
        assert nearest_cuda_image(row.cuda).tag


def toolkit(*lines: str, **changes: Any) -> str:
    chosen = Chosen(guessed=tuple(stated(line) for line in lines))
    return decide_toolkit(Evidence(**changes), chosen)


def test_no_compiler_of_cuda_where_nothing_is_compiled() -> None:
    assert toolkit("torch", "numpy") == "base"  # its wheel brings the libraries
    assert toolkit("tensorflow==2.4", "numpy") == "runtime"
    assert toolkit("torch", "jax[cuda12]") == "runtime"
    assert toolkit("torch", "pytorch3d") == "devel"
    assert toolkit("torch", "a @ git+https://github.com/a/a") == "devel"  # nobody knows what it compiles
    assert toolkit("torch", "git+https://github.com/a/d4rl-1.git") == "base"  # GitHub's name for a fork of a known one
    assert toolkit("torch", "git+https://github.com/a/transformers") == "base"
    assert toolkit("torch", "git+https://github.com/a/pytorch3d-1") == "devel"
    assert toolkit("torch", cuda_files=("src/a.cu",)) == "devel"
    assert toolkit() == "devel"  # a program of its own
    image, _, _ = base_for("cuda", "11.8", None, None, "3.10", toolkit="runtime")
    assert image == "nvidia/cuda:11.8.0-cudnn8-runtime-ubuntu22.04"
    assert base_for("cuda", "11.8", None, None, "3.10", toolkit="base")[0] == "nvidia/cuda:11.8.0-base-ubuntu22.04"


@pytest.mark.parametrize(
    ("line", "cuda", "python", "limits", "options"),
    [
        ("torch", "11.3", "3.8", ["torch==1.12.*"], ["--extra-index-url https://download.pytorch.org/whl/cu113"]),
        ("torch>=1.1", "12.1", "3.8", ["torch==2.4.*"], []),
        ("torch", "11.1", "3.7", ["torch==1.10.*"], ["--find-links https://download.pytorch.org/whl/cu111/torch_stable.html"]),
        ("torch==1.11.0", "11.3", "3.8", [], ["--extra-index-url https://download.pytorch.org/whl/cu113"]),
        ("torch==1.13.1+cu116", "11.6", "3.8", [], []),
        ("numpy", "11.3", "3.8", [], []),
    ],
)  # fmt: skip
def test_torch_fits_the_toolkit_that_compiles_its_extensions(
    line: str, cuda: str, python: str, limits: list[str], options: list[str]
) -> None:
    found = torch_build([stated(line)], cuda, python).answer
    assert ([each.written for each in found[0]], list(found[1])) == (limits, options)


@pytest.mark.parametrize(
    ("line", "limits", "index"),
    [
        ("conda install pytorch torchvision pytorch-cuda=11.6 -c pytorch -c nvidia", {"torch==1.13.*"}, "/cu116"),
        ("conda install pytorch cudatoolkit=11.3 -c pytorch", {"torch==1.12.*"}, "/cu113"),
        ("conda install pytorch -c pytorch", set(), ""),
        ("conda install pytorch==1.13.0 pytorch-cuda=11.6 -c pytorch -c nvidia", {"torch==1.13.0"}, "/cu116"),
    ],
)
def test_the_torch_that_conda_would_take_for_the_cuda_beside_it(
    tree: Callable[[dict[str, str]], Decision], line: str, limits: set[str], index: str
) -> None:
    page = f"```\nconda create -n demo python=3.8\n{line}\npip install -r requirements.txt\n```\n"
    python = tree({"README.md": page, "requirements.txt": "numpy\n", "run.py": "import torch\n"}).python
    assert {each.written for each in python.bounds if each.key == "torch"} == limits
    assert any(each.endswith(index) for each in python.options) == bool(index)


LIBRARY = (
    '[project]\nname = "high-way"\nversion = "1"\ndependencies = [{needs}]\n'
    '[project.optional-dependencies]\nnn = ["jax"]\n'
)


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"pyproject.toml": LIBRARY.format(needs='"numpy"'), "scripts/train.py": "import torch\n"}, "python"),
        ({"pyproject.toml": LIBRARY.format(needs='"numpy"'), "high_way/net.py": "import torch\n"}, "cuda"),
        ({"pyproject.toml": LIBRARY.format(needs=""), "scripts/train.py": "import torch\n"}, "cuda"),
        ({"pyproject.toml": LIBRARY.format(needs='"numpy", "torch"'), "high_way/a.py": ""}, "cuda"),
        ({"requirements.txt": "numpy\n", "requirements-dev.txt": "torch\n", "a.py": "import numpy\n"}, "python"),
        (
            {
                "requirements.txt": "-r a/base.txt\n# -r a/more_requirements.txt\n",
                "a/base.txt": "numpy\n",
                "a/more_requirements.txt": "torch\n",
            },
            "python",
        ),
        ({"requirements.txt": "-r a/more_requirements.txt\n", "a/more_requirements.txt": "torch\n"}, "cuda"),
    ],
)
def test_a_framework_of_examples_and_extras_alone_asks_for_no_cuda(
    tree: Callable[[dict[str, str]], Decision], files: dict[str, str], kind: str
) -> None:
    assert tree(files).kind == kind


def test_what_a_requirement_file_has_in_a_comment_is_not_installed(
    tree: Callable[[dict[str, str]], Decision],
) -> None:
    page = (
        "```\npip install -r requirements.txt\n```\nFor prediction:\n```\npip install -r more_requirements.txt\n```\n"
    )
    own = {"requirements.txt": "-r base_requirements.txt\n# -r more_requirements.txt  # prediction\n"}
    files = {**own, "base_requirements.txt": "numpy\n", "more_requirements.txt": "scipy\n", "README.md": page}
    assert tree(files).python.requirements == ("requirements.txt",)


CUDA_BELOW = {
    "src/CMakeLists.txt": "project(Fusion CUDA)\nadd_executable(Fusion Main.cpp step.cu)\n",
    "src/Main.cpp": "int main() {}\n",
    "src/step.cu": "__global__ void step() {}\n",
}


@pytest.mark.parametrize(
    ("more", "tool"),
    [
        ({}, "cmake"),
        ({"run.py": "if __name__ == '__main__':\n    pass\n"}, "none"),
        ({"src/CMakeLists.txt": "project(Fusion CUDA)\nadd_executable(Fusion elsewhere.cpp)\n"}, "none"),
    ],
)
def test_a_project_below_the_root_is_compiled_where_no_python_is(
    tree: Callable[[dict[str, str]], Decision], more: dict[str, str], tool: str
) -> None:
    decision = tree({**CUDA_BELOW, **more})
    assert (decision.kind, decision.build_tool) == ("cuda", tool)


@pytest.mark.parametrize(
    ("page", "image"),
    [
        ("* Ubuntu 18.04 or 20.04\n", "nvidia/cuda:11.8.0-devel-ubuntu18.04"),
        ("Tested on Ubuntu 20.04.\n", "nvidia/cuda:11.8.0-devel-ubuntu20.04"),
        ("* Ubuntu 14.04\n", "nvidia/cuda:11.8.0-devel-ubuntu22.04"),  # no image of any CUDA
        ("Tested on Ubuntu 16.04.\n", "nvidia/cuda:11.3.1-devel-ubuntu16.04"),
        ("Tested on Ubuntu 14.04 and 16.04.\n", "nvidia/cuda:11.3.1-devel-ubuntu16.04"),
        ("Tested on Ubuntu 24.04.\n", "nvidia/cuda:12.6.3-devel-ubuntu24.04"),
        ("Tested on Ubuntu 16.04 with CUDA 11.8.\n", "nvidia/cuda:11.8.0-devel-ubuntu22.04"),
        ("Compile it.\n", "nvidia/cuda:11.8.0-devel-ubuntu22.04"),
    ],
)
def test_code_for_cuda_is_compiled_on_the_ubuntu_that_the_page_names(
    tree: Callable[[dict[str, str]], Decision], page: str, image: str
) -> None:
    assert tree({**CUDA_BELOW, "README.md": page}).base_image == image


OLD = "void f() { cv::imread(name, CV_LOAD_IMAGE_UNCHANGED); }\n"


@pytest.mark.parametrize(
    ("page", "image"),
    [
        ("Compile it.\n", "nvidia/cuda:11.8.0-devel-ubuntu18.04"),
        ("Tested on Ubuntu 20.04.\n", "nvidia/cuda:11.8.0-devel-ubuntu18.04"),
        ("Tested on CUDA 12.2.\n", "nvidia/cuda:12.2.2-devel-ubuntu22.04"),  # all of its images lack it
    ],
)
def test_no_ubuntu_on_which_the_code_does_not_compile(
    tree: Callable[[dict[str, str]], Decision], page: str, image: str
) -> None:
    assert tree({"demo.cu": OLD, "README.md": page}).base_image == image


@pytest.mark.parametrize(
    ("python", "codename"), [("3.7", "focal"), ("3.9", "focal"), ("3.10", "jammy"), ("3.11", "jammy")]
)
def test_a_python_of_conda_newer_than_an_ubuntu_s_gets_a_newer_ubuntu(python: str, codename: str) -> None:
    assert base_for("cuda", "12.3", None, None, python)[1] == codename


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"requirements.txt": "jax==0.4.20\nflax\noptax\n"}, "python"),
        ({"requirements.txt": "jax[cpu]==0.4.20\n"}, "python"),
        ({"requirements.txt": "jax[cuda12]==0.4.20\n"}, "cuda"),
        ({"requirements.txt": "jax==0.4.30\njax-cuda12-pjrt==0.4.30\njax-cuda12-plugin==0.4.30\n"}, "cuda"),
        ({"requirements.txt": "jax==0.4.30\njax-jumpy==1.0\n"}, "python"),
        (
            {"README.md": '# Install\n```\npip install -U "jax[cuda12_pip]" -f https://example.org/jax.html\n```\n'},
            "cuda",
        ),
        (
            {"requirements.txt": "-f https://example.org/jax-releases/jax_cuda_releases.html\njaxlib==0.3.2\n"},
            "cuda",
        ),
        ({"environment.yml": "dependencies:\n  - python=3.9\n  - jaxlib=0.4.20=cuda112py39\n"}, "cuda"),
        ({"requirements.txt": "jax==0.4.20\ntorch\n"}, "cuda"),
    ],
)
def test_jax_computes_on_the_cpu_unless_its_extra_is_asked_for(
    tree: Callable[[dict[str, str]], Decision], files: dict[str, str], kind: str
) -> None:
    decision = tree({**files, "train.py": "import jax\nimport flax\n"})
    assert decision.kind == kind
    assert ("nvidia/cuda" in decision.base_image) == (kind == "cuda")


@pytest.mark.parametrize(
    ("listed", "toolkit"),
    [
        ("jax-cuda12-plugin==0.4.30\nnvidia-cudnn-cu12==9.5.1.17\n", "-base-"),
        ("jax-cuda12-plugin==0.4.30\n", "-runtime-"),
        ("jax-cuda12-plugin==0.4.30\nnvidia-cudnn-cu12==9.5.1.17\ncupy-cuda12x\n", "-runtime-"),
        ("torch==2.4.0\nnvidia-cudnn-cu12==9.1.0.70\n", "-runtime-"),
    ],
)
def test_jax_takes_the_libraries_of_wheels_that_are_listed(
    tree: Callable[[dict[str, str]], Decision], listed: str, toolkit: str
) -> None:
    decision = tree({"requirements.txt": f"jax==0.4.30\njaxlib==0.4.30\n{listed}", "train.py": "import jax\n"})
    assert toolkit in decision.base_image


@pytest.mark.parametrize(("plugin", "cuda"), [("jax-cuda12-plugin", "12.3"), ("jax-cuda13-plugin", "13.0")])
def test_the_wheel_for_cuda_that_jax_is_frozen_with(
    tree: Callable[[dict[str, str]], Decision], plugin: str, cuda: str
) -> None:
    frozen = f"jax==0.7.2\njaxlib==0.7.2\n{plugin}==0.7.2\n"
    decision = tree({"requirements.txt": frozen, "train.py": "import jax\n"})
    assert decision.cuda == cuda


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"requirements.txt": "numpy\ntensorflow==1.4.0\n"}, "python"),
        ({"requirements.txt": "tensorflow==0.12.0rc1\n"}, "python"),
        ({"README.md": "# Install\n```\npip install tensorflow==2.0.0\n```\n"}, "python"),
        ({"requirements.txt": "tensorflow==1.15.0\n"}, "cuda"),
        ({"requirements.txt": "tensorflow\n"}, "cuda"),
        ({"requirements.txt": "tensorflow-gpu==1.4.0\n"}, "cuda"),
        ({"requirements.txt": "tensorflow==1.4.0\n", "README.md": "# Install\nIt needs CUDA 8.0.\n"}, "python"),
        ({"requirements.txt": "tensorflow-gpu==1.4.0\n", "README.md": "# Install\nIt needs CUDA 8.0.\n"}, "cuda"),
        ({"README.md": "# Requirements\n* CUDA 10.0\n* Tensorflow 1.14.0\n* Keras 2.3.0\n"}, "python"),
        ({"requirements.txt": "tensorflow==1.4.0\n", "eval/requirements.txt": "tensorflow==2.4.0\n"}, "cuda"),
    ],
)
def test_a_release_whose_wheel_computes_on_the_cpu_alone_asks_for_no_cuda(
    tree: Callable[[dict[str, str]], Decision], files: dict[str, str], kind: str
) -> None:
    decision = tree({**files, "train.py": "import tensorflow as tf\nimport keras\n"})
    assert decision.kind == kind
    assert ("nvidia/cuda" in decision.base_image) == (kind == "cuda")
    told = any("computes on the CPU alone" in warning.message for warning in decision.warnings)
    assert told == (kind == "python" and "CUDA" in files.get("README.md", ""))


def test_a_release_that_is_older_than_the_table_is_no_open_one() -> None:
    evidence = Evidence(requirements=(asked("tensorflow-gpu==0.12.0"),))
    assert [each.reason for each in decide_cuda(evidence, Config()).reasons] == []


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"requirements.txt": "torch==1.13.1+cpu\ntorchvision==0.14.1+cpu\n"}, "python"),
        ({"requirements.txt": "torch==1.13.1+cpu\n", "README.md": "# Install\nIt needs CUDA 11.7.\n"}, "cuda"),
        ({"requirements.txt": "torch==1.13.1+cpu\n", "eval/requirements.txt": "torch==1.13.1\n"}, "cuda"),
        ({"requirements.txt": "torch==1.13.1+cu117\n"}, "cuda"),
    ],
)
def test_a_build_of_torch_for_the_cpu_asks_for_no_cuda(
    tree: Callable[[dict[str, str]], Decision], files: dict[str, str], kind: str
) -> None:
    decision = tree({**files, "train.py": "import torch\n"})
    assert decision.kind == kind
    assert ("nvidia/cuda" in decision.base_image) == (kind == "cuda")


@pytest.mark.parametrize(
    ("packages", "more", "kind"),
    [
        (("pytorch=1.9.0=py3.7_cpu_0", "torchvision=0.10.0=py37_cpu"), {}, "python"),
        (("pytorch=1.13.1=cpu_py310hd11e9c7_0",), {}, "python"),
        (("pytorch=1.9.0", "torchvision", "cpuonly=1.0=0"), {}, "python"),
        (("pytorch", "cpuonly"), {}, "python"),
        (("pytorch=2.0", "pytorch-mutex=1.0=cpu"), {}, "python"),
        (("pytorch=2.0", "pytorch-mutex=*=cpu"), {}, "python"),
        (("pytorch=2.0=cpu*",), {}, "python"),
        (("pytorch-cpu=1.13",), {}, "python"),
        (("pytorch=2.0", "pytorch-mutex=1.0=cuda"), {}, "cuda"),
        (("pytorch=1.9.0", "cpuonly", "cudatoolkit=11.1"), {}, "cuda"),
        (("pytorch=1.9.0=py3.7_cuda11.1_cudnn8.0.5_0",), {}, "cuda"),
        (("pytorch=1.9.0", "torchvision=0.10.0=py37_cpu"), {}, "cuda"),
        (("pytorch", "cpuonly"), {"requirements.txt": "torch\n"}, "cuda"),
        (("pytorch", "cpuonly"), {"README.md": "# Install\nIt needs CUDA 11.7.\n"}, "cuda"),
    ],
)
def test_an_environment_whose_torch_is_for_the_cpu_asks_for_no_cuda(
    tree: Callable[[dict[str, str]], Decision], packages: tuple[str, ...], more: dict[str, str], kind: str
) -> None:
    lines = "".join(f"  - {package}\n" for package in ("python=3.8", *packages))
    environment = f"channels: [pytorch, defaults]\ndependencies:\n{lines}"
    decision = tree({"environment.yml": environment, "train.py": "import torch\nimport torchvision\n", **more})
    assert decision.kind == kind
    assert ("nvidia/cuda" in decision.base_image) == (kind == "cuda")


def test_conda_has_torch_for_the_cpu_beside_what_computes_on_cuda(tree: Callable[[dict[str, str]], Decision]) -> None:
    lines = "dependencies:\n  - python=3.8\n  - pytorch=1.9.0=py3.8_cpu_0\n"
    decision = tree({"environment.yml": lines, "a.cu": "__global__ void a() {}\n", "train.py": "import torch\n"})
    assert decision.kind == "cuda"
    assert not [each.reason for each in decision.reasons if each.question == "cuda" and "torch" in each.reason]


def test_a_build_of_torch_for_the_cpu_names_no_cuda() -> None:
    assert decide_cuda(Evidence(requirements=(asked("torch==1.13.1+cpu"),)), Config()).answer.version is None


@pytest.mark.parametrize(
    ("pinned", "cuda"),
    [("torch==2.2.0", "11.8"), ("torch==1.8.0", "11.1"), ("torch", "11.1"), ("torch==2.2.0+cu121", "12.1")],
)
def test_a_build_of_an_older_release_than_the_projects_own_tells_no_cuda(
    tree: Callable[[dict[str, str]], Decision], pinned: str, cuda: str
) -> None:
    page = "# Arm\n\n```\npip install -e . --extra-index-url https://download.pytorch.org/whl/cu118\n```\n"
    older = (
        "FROM ubuntu:20.04\nRUN pip3 install torch==1.8.1+cu111 -f https://download.pytorch.org/whl/torch_stable.html\n"
    )
    files = {"requirements.txt": f"{pinned}\n", "README.md": page, "docker/Dockerfile.sim": older}
    assert tree(files | {"main.py": "import torch\n"}).cuda == cuda


@pytest.mark.parametrize(
    ("line", "cuda"),
    [
        ("$ ml load GCC/12.3.0 TensorFlow/2.15.1-CUDA-12.1.1", "13.0"),
        ("module load PyTorch/2.1.2-foss-2023a-CUDA-12.1.1", "13.0"),
        ("ml load cuda-11.8", "11.8"),
        ("It was run with CUDA 11.8.", "11.8"),
    ],
)
def test_the_cuda_of_a_cluster_s_other_module_is_not_the_code_s(
    tree: Callable[[dict[str, str]], Decision], line: str, cuda: str
) -> None:
    page = f"# Net\n\n## Cluster\n\n```\n{line}\n```\n"
    assert tree({"train.py": "import torch\n", "README.md": page}).cuda == cuda
