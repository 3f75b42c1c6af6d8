"""The laboratory itself: what it promises to the other tests, tried for real."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from lab import images, registry
from lab.act import run_workflow
from lab.laboratory import Laboratory

CALLER = """
on: [push, pull_request]
jobs:
  image:
    runs-on: ubuntu-24.04
    outputs:
      digest: ${{ steps.build.outputs.digest }}
    steps:
      - uses: actions/checkout@3d3c42e5aac5ba805825da76410c181273ba90b1
      - uses: docker/setup-buildx-action@37fe631027851001ddb9b187196cc803df7f5f0e
      - uses: docker/login-action@dbcb813823bdd20940b903addbd779551569679f
        if: github.event_name != 'pull_request'
        with: {registry: "${{ env.REGISTRY }}", username: lab, password: "${{ secrets.PASSWORD }}"}
      - id: meta
        uses: docker/metadata-action@dc802804100637a589fabce1cb79ff13a1411302
        with:
          images: ${{ env.IMAGE }}
          tags: |
            type=ref,event=branch
            type=semver,pattern={{major}}.{{minor}}
            type=raw,value=newest,enable={{is_default_branch}}
      - id: build
        if: github.event_name != 'pull_request'
        uses: docker/build-push-action@53b7df96c91f9c12dcc8a07bcb9ccacbed38856a
        with:
          context: .
          platforms: linux/amd64,linux/arm64
          provenance: false
          outputs: type=image,name=${{ env.IMAGE }},push-by-digest=true,name-canonical=true,push=true
      - if: github.event_name != 'pull_request'
        shell: bash
        env: {DIGEST: "${{ steps.build.outputs.digest }}", TAGS: "${{ steps.meta.outputs.tags }}"}
        run: |
          docker run --rm --platform linux/arm64 "$IMAGE@$DIGEST" uname -m
          for tag in $TAGS; do docker buildx imagetools create --tag "$tag" "$IMAGE@$DIGEST"; done
          echo "published as $TAGS" >> "$GITHUB_STEP_SUMMARY"
"""


@pytest.fixture
def caller(tmp_path: Path) -> Path:
    workflows = tmp_path / "caller" / ".github" / "workflows"
    workflows.mkdir(parents=True)
    (workflows / "image.yml").write_text(CALLER)
    (tmp_path / "caller" / "Dockerfile").write_text("FROM ubuntu:24.04\nRUN uname -m > /machine\n")
    return tmp_path / "caller"


def build(lab: Laboratory, folder: Path, dockerfile: str, *options: str) -> subprocess.CompletedProcess[str]:
    """Build a Dockerfile of a few lines as an author would, each time anew, and return what was said."""
    command = ["docker", "build", "--no-cache", "--progress", "plain", *options, "-"]
    return subprocess.run(
        command, input=dockerfile, env=dict(lab.environment), cwd=folder, capture_output=True, text=True, check=False
    )


def test_base_images_have_their_real_names_and_a_way_out(lab: Laboratory, tmp_path: Path) -> None:
    packages = "RUN apt-get update && apt-get install -y --no-install-recommends python3-pip\nRUN pip install six\n"
    built = build(lab, tmp_path, f"FROM ubuntu:22.04\n{packages}")
    assert built.returncode == 0, built.stderr
    assert "Successfully installed six" in built.stderr


def test_the_newest_ubuntu_has_its_user_and_refuses_a_bare_pip(lab: Laboratory, tmp_path: Path) -> None:
    if not lab.standins:
        pytest.skip("the real images are used here")
    packages = "RUN id -u ubuntu && apt-get update && apt-get install -y --no-install-recommends python3-pip\n"
    built = build(lab, tmp_path, f"FROM ubuntu:24.04\n{packages}RUN pip install six\n")
    assert built.returncode != 0
    assert "externally-managed-environment" in built.stderr


@pytest.mark.parametrize("distro", ["kinetic", "melodic", "noetic"])
def test_ros_1_builds_and_resolves_without_a_network(lab: Laboratory, tmp_path: Path, distro: str) -> None:
    lines = [
        f"FROM ros:{distro}-ros-base",
        'SHELL ["/bin/bash", "-c"]',
        "RUN source /opt/ros/$ROS_DISTRO/setup.bash && rospack find roscpp && rosversion -d",
        "RUN rosdep update --rosdistro $ROS_DISTRO && rosdep resolve roscpp eigen && ! rosdep resolve no_such_package",
        "RUN dpkg-query --show ros-$ROS_DISTRO-catkin",
        'RUN test -z "$(ls /var/lib/apt/lists)" && apt-get update',
        "RUN apt-get install -y --no-install-recommends ros-$ROS_DISTRO-tf2-ros python3-catkin-tools",
        "RUN catkin --version",
    ]
    built = build(lab, tmp_path, "\n".join(lines) + "\n")
    assert built.returncode == 0, built.stderr
    assert f"ros-{distro}-roscpp" in built.stderr


def test_the_lab_knows_which_stand_in_has_a_real_name(lab: Laboratory) -> None:
    """Packages of ROS 2 that were given are no promise: the names may still be those of the image without them."""
    if not lab.standins:
        pytest.skip("the images are the real ones, not stand-ins")
    environment = dict(lab.environment)
    assert images.stands("base", "debian:12", environment)
    assert not images.stands("jazzy-packages", "debian:12", environment)
    assert images.stands("jazzy-packages", "ros:jazzy-ros-base", environment) is lab.ros2


def test_ros_2_builds_an_ament_package(lab: Laboratory, tmp_path: Path) -> None:
    manifest = (
        '<package format="3"><name>a</name><version>0.1.0</version><description>d</description>'
        '<maintainer email="someone@example.org">s</maintainer><license>MIT</license>'
        "<buildtool_depend>ament_cmake</buildtool_depend>"
        "<export><build_type>ament_cmake</build_type></export></package>"
    )
    recipe = (
        "cmake_minimum_required(VERSION 3.8)\\nproject(a)\\nfind_package(ament_cmake REQUIRED)\\nament_package()\\n"
    )
    build_it = "colcon build && source install/setup.bash && test -d install/a/share/a"
    lines = [
        "FROM ros:humble-ros-base",
        'SHELL ["/bin/bash", "-c"]',
        "WORKDIR /ws/src/a",
        f"RUN printf '%s' '{manifest}' > package.xml && printf '{recipe}' > CMakeLists.txt",
        f"RUN cd /ws && source /opt/ros/$ROS_DISTRO/setup.bash && {build_it}",
    ]
    built = build(lab, tmp_path, "\n".join(lines) + "\n")
    assert built.returncode == 0, built.stderr


def test_the_registry_refuses_a_wrong_password(lab: Laboratory, tmp_path: Path) -> None:
    environment = {**lab.environment, "DOCKER_CONFIG": str(tmp_path)}
    command = ["docker", "login", "--username", lab.username, "--password-stdin", lab.registry]
    refused = subprocess.run(command, input="wrong", env=environment, capture_output=True, text=True, check=False)
    taken = subprocess.run(command, input=lab.password, env=environment, capture_output=True, text=True, check=False)
    assert refused.returncode != 0
    assert "401" in refused.stderr
    assert taken.returncode == 0, taken.stderr


def test_act_builds_proves_and_tags_two_platforms(lab: Laboratory, caller: Path) -> None:
    image = lab.fresh_repository("someone/something")
    settings = {"REGISTRY": lab.registry, "IMAGE": image}
    push = {"ref": "refs/heads/main"}
    ran = run_workflow(lab, caller, "push", push, env=settings, secrets={"PASSWORD": lab.password})
    assert ran.exit_code == 0, ran.log
    assert set(ran.jobs.values()) == {"success"}
    assert "aarch64" in ran.log
    assert "published as" in ran.summary
    repository = image.partition("/")[2]
    assert registry.tags(repository) == ("main", "newest")
    index, digest = registry.manifest(f"{repository}:main")
    assert digest == ran.output("digest")
    assert {entry["platform"]["architecture"] for entry in index["manifests"]} == {"amd64", "arm64"}


def test_act_tells_a_pull_request_and_a_wrong_password_apart(lab: Laboratory, caller: Path) -> None:
    image = lab.fresh_repository("someone/refused")
    settings = {"REGISTRY": lab.registry, "IMAGE": image}
    request = {"number": 7, "head": {"ref": "fix", "sha": "0" * 40}, "base": {"ref": "main"}}
    pull = run_workflow(lab, caller, "pull_request", {"number": 7, "pull_request": request}, env=settings)
    assert pull.exit_code == 0, pull.log
    push = run_workflow(lab, caller, "push", {"ref": "refs/heads/main"}, env=settings, secrets={"PASSWORD": "wrong"})
    assert push.exit_code != 0
    assert "failure" in push.jobs.values()
    assert registry.tags(image.partition("/")[2]) == ()
