"""The examples for real: built by a bare ``docker build``, by ``roslab build``, started, and seen to do their work."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from .laboratory import Laboratory

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "examples"
REAL_BASE_ONLY = {"cuda_saxpy"}
"""It needs what no stand-in has: nvcc. The workflow `live` builds and verifies it on GitHub."""
NEEDS_ROS_2 = {"ros2_talker"}
"""They need rclcpp, which a stand-in has where the lab was given packages of it; `live` has it always."""
NAMES = sorted(path.name for path in EXAMPLES.iterdir() if path.is_dir() and path.name not in REAL_BASE_ONLY)
SNAPSHOT = "failed to prepare extraction snapshot"
"""The engine's unpacking fails so now and then while another image of the same name goes away; again, it works."""


@pytest.fixture
def docker(lab: Laboratory) -> Callable[..., CompletedProcess[str]]:
    """Return a function that runs docker in the lab."""

    def run(*arguments: str, cwd: Path | None = None) -> CompletedProcess[str]:
        for _ in range(2):
            answer = subprocess.run(
                ["docker", *arguments],
                env=dict(lab.environment),
                cwd=cwd,
                capture_output=True,
                text=True,
                errors="replace",
                timeout=1800,
                check=False,
            )
            if SNAPSHOT not in answer.stderr:
                break
        return answer

    return run


@pytest.fixture
def example(request: pytest.FixtureRequest, tmp_path: Path, lab: Laboratory) -> Path:
    """Return a copy of the example that the test is parametrised with; the folder's name is the image's."""
    if request.param in NEEDS_ROS_2 and not lab.ros2:
        pytest.skip(
            "Debian has no rclcpp, and REPRO_LAB_ROS2 named no folder of packages: see `python3 tests/lab --help`"
        )
    copy = tmp_path / str(request.param)
    shutil.copytree(EXAMPLES / str(request.param), copy, ignore=shutil.ignore_patterns("__pycache__"))
    return copy


@pytest.mark.parametrize("example", NAMES, indirect=True)
def test_bare_build(
    docker: Callable[..., CompletedProcess[str]], roslab: Callable[..., CompletedProcess[str]], example: Path
) -> None:
    create = roslab("create", example)
    assert create.returncode == 0, create.stderr
    image = f"repro-lab/{example.name}:bare"
    recipe = ["--file", "docker/Dockerfile"] if example.name == "own_dockerfile" else []
    built = docker("build", "--progress", "plain", "--tag", image, *recipe, ".", cwd=example)
    assert built.returncode == 0, built.stderr[-8000:]
    ran = docker("run", "--rm", "--init", image, "./verify")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    if not recipe:
        user = docker("run", "--rm", image, "bash", "-c", "id -un; id -u; stat -c %U . ; pwd")
        assert user.stdout.split()[:3] == ["jovyan", "1000", "jovyan"]
        assert user.stdout.split()[3].startswith("/home/jovyan/")
    docker("image", "rm", image)


@pytest.mark.parametrize("example", NAMES, indirect=True)
def test_roslab_build(
    docker: Callable[..., CompletedProcess[str]],
    roslab: Callable[..., CompletedProcess[str]],
    lab: Laboratory,
    example: Path,
) -> None:
    """Built, proved, and only then named; nothing else of it stays in the engine."""
    answer = roslab("build", example, "--tag", "repro-lab", env=lab.environment, timeout=1800)
    assert answer.returncode == 0, answer.stderr[-8000:]
    name = f"{example.name}:repro-lab"
    assert answer.stdout == f"{name}\n"
    assert " passed" in answer.stderr
    images = docker("image", "ls", "--format", "{{.Repository}}:{{.Tag}}", example.name).stdout.split()
    assert name in images
    candidates = [(image, found[1]) for image in images if (found := re.search(r"-candidate-(\d+)-", image))]
    assert not [image for image, process in candidates if not Path("/proc", process).exists()]  # others may be building
    docker("image", "rm", name)


@pytest.mark.parametrize("example", ["own_dockerfile"], indirect=True)
def test_a_test_that_fails_gives_no_name(
    docker: Callable[..., CompletedProcess[str]],
    roslab: Callable[..., CompletedProcess[str]],
    lab: Laboratory,
    example: Path,
) -> None:
    """The image of that name stays the one that passed."""
    name = f"{example.name}:repro-lab-test"
    assert roslab("build", example, "--tag", "repro-lab-test", env=lab.environment, timeout=1800).returncode == 0
    before = docker("image", "inspect", "--format", "{{.Id}}", name).stdout
    (example / "new").touch()
    test = "echo measured 3 wanted 4; exit 7"
    answer = roslab("build", example, "--tag", "repro-lab-test", "--test", test, env=lab.environment, timeout=1800)
    assert answer.returncode == 5
    assert "measured 3 wanted 4" in answer.stderr
    assert f"{name} was not named" in answer.stderr
    assert "failed with exit code 7" in answer.stderr
    assert docker("image", "inspect", "--format", "{{.Id}}", name).stdout == before != ""
    docker("image", "rm", name)


@pytest.mark.parametrize("example", ["no_config"], indirect=True)
def test_a_compiler_error_is_told(roslab: Callable[..., CompletedProcess[str]], lab: Laboratory, example: Path) -> None:
    (example / "src" / "align.cpp").write_text("#include <no_such_header.hpp>\nint main() {}\n")
    words = ("build", example, "--tag", "repro-lab-broken", "--no-repair")
    answer = roslab(*words, env=lab.environment, timeout=1800)
    assert answer.returncode == 5
    assert answer.stdout == ""
    assert "no_such_header.hpp: No such file or directory" in answer.stderr
    assert "roslab: error: The header no_such_header.hpp is missing: " in answer.stderr


@pytest.mark.parametrize("example", ["python_filter"], indirect=True)
def test_an_edit_of_the_source_reuses_what_was_installed(
    docker: Callable[..., CompletedProcess[str]], roslab: Callable[..., CompletedProcess[str]], example: Path
) -> None:
    assert roslab("create", example).returncode == 0
    image = "repro-lab/edited:bare"
    # Steps of its own: where another test builds with --no-cache meanwhile, steps that both have are built anew
    recipe = example / "Dockerfile"
    text = recipe.read_text()
    recipe.write_text(text.replace("#!/bin/bash\n", "#!/bin/bash\n# The test's own\n", 1))
    build = ("build", "--progress", "plain", "--tag", image, ".")
    assert docker(*build, cwd=example).returncode == 0
    program = (example / "demo.py").read_text().replace('print(f"figure:', 'print(f"my figure:')
    (example / "demo.py").write_text(program)
    again = docker(*build, cwd=example)
    assert again.returncode == 0, again.stderr
    steps = again.stderr.split("\n\n")
    install = next(step for step in steps if "pip install" in step and "requirements.txt" in step)
    assert "CACHED" in install, again.stderr
    ran = docker("run", "--rm", image, "python3", "demo.py")
    assert "my figure: track.png" in ran.stdout
    docker("image", "rm", image)


@pytest.mark.parametrize("example", ["python_filter"], indirect=True)
def test_the_scripts_from_another_folder(
    docker: Callable[..., CompletedProcess[str]],
    roslab: Callable[..., CompletedProcess[str]],
    lab: Laboratory,
    example: Path,
    tmp_path: Path,
) -> None:
    """`create --output` elsewhere: docker_build.sh knows where the repository is, docker_run.sh runs what it built."""
    output = tmp_path / "image files"
    assert roslab("create", example, "--output", output).returncode == 0
    for script, printed in (("docker_build.sh", ""), ("docker_run.sh", "filtered: 0.387 m")):
        words = ["bash", str(output / script), *(["python3", "demo.py"] if printed else [])]
        answer = subprocess.run(
            words,
            env=dict(lab.environment),
            cwd=tmp_path,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        assert answer.returncode == 0, answer.stdout + answer.stderr
        assert printed in answer.stdout
    docker("image", "rm", "python_filter:latest")
