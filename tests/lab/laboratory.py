"""The laboratory as tests see it: addresses, programs and the environment for what they start."""

from __future__ import annotations

import io
import json
import os
import secrets
import shutil
import sys
import tempfile
from base64 import b64encode
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from . import (
    buildkit,
    emulation,
    engine,
    facts,
    git_hosts,
    images,
    mounts,
    network,
    packages,
    packages_folder,
    processes,
    registry,
    rootfs,
    tools,
)
from .command import LabError
from .home import folder, home, lock
from .steps import step

ARCHITECTURES = ("amd64", "arm64")


@dataclass(frozen=True, kw_only=True, slots=True)
class Laboratory:
    """What runs, where it answers, and how a test reaches it."""

    docker_host: str
    registry: str
    mirror: str
    username: str
    password: str
    buildkit: str
    act: Path
    node: Path
    docker_config: Path
    standins: bool
    ros2: bool
    """The images of ROS 2 Jazzy have rclcpp: real ones, or stand-ins of packages that the lab was given."""
    environment: Mapping[str, str] = field(repr=False)

    def fresh_repository(self, name: str) -> str:
        """Return a repository name in the protected registry that nobody else uses: HOST:PORT/NAME-DIGITS.

        Runs of tests at the same time share the registry, so a name that is free now may be another's in a moment.
        """
        return f"{self.registry}/{name}-{secrets.token_hex(4)}"

    @contextmanager
    def logged_in(self, username: str, password: str) -> Iterator[dict[str, str]]:
        """Give the environment of a Docker client with another login to the protected registry than the lab's."""
        with tempfile.TemporaryDirectory() as place:
            _log_in(Path(place), username, password)
            yield {**self.environment, "DOCKER_CONFIG": place}


def up(
    *, emulated: bool = True, everything: bool = False, bases: Sequence[str] | None = None, made: bool = True
) -> None:
    """Make and start everything a test may want, one line of progress per step; what is there already stays.

    Without `emulated` the stand-ins are for this machine alone; `everything` adds those that take long under emulation;
    `bases` are the real names of the only ones that are wanted. Programs are compiled beside the making of images;
    without `made` neither is, and there is only what comes with packages.
    Raises LabError when a step fails.
    """
    if os.geteuid() != 0 and engine.host() is None:
        raise LabError("no engine works here and only root can start one: start Docker 23 or newer, or run as root")
    with lock(sys.stderr):
        with step("engine") as told:
            told.note = engine.up()
        with step("room on the disk") as told:
            told.note = engine.make_room()
        for name in (registry.PROTECTED, registry.MIRROR):
            with step(f"{name}") as told:
                told.note = registry.up(name)
        _log_in(Path(_docker_environment()["DOCKER_CONFIG"]), *registry.credentials())
        if emulated:
            with step("emulation of arm64") as told:
                told.note = emulation.up()
        if bases is None and os.geteuid() == 0:
            with step("Xvfb") as told:
                told.note = "installed" if packages.install(facts.texts("screen", "packages")) else "is there"
        with step("is the real docker.io in reach") as told:
            real = network.real_registry()
            _standins_marker().write_text("no" if real else "yes")
            told.note = "yes, no stand-ins are made" if real else "no, stand-ins are made"
        if not made:
            return
        with ThreadPoolExecutor(max_workers=1) as beside:
            programs = beside.submit(_programs)
            if not real:
                _images(emulated=emulated, everything=everything, bases=bases)
            programs.result()
        if bases is None:
            with step("layers that pushes take from the registry") as told:
                told.note = mounts.up(_docker_environment(), _architectures(emulated=emulated))


def _programs() -> None:
    for title, make in (("act", tools.act), ("node", tools.node)):
        with step(title) as told:
            told.note = str(make())
    with step("buildkitd") as told:
        told.note = buildkit.up()


def _images(*, emulated: bool, everything: bool, bases: Sequence[str] | None) -> None:
    env = _docker_environment()
    # Who once asked for everything keeps it; else the next plain `up` would take the slow images away again.
    kept = folder() / "everything"
    everything = everything or kept.exists()
    architectures = _architectures(emulated=emulated)
    for architecture in architectures:
        with step(f"root file system, {architecture}") as told:
            told.note = rootfs.make(architecture).name
    rootfs.machine(folder("rootfs", "machine"))
    wanted = images.wanted(architectures, everything=everything)
    standing = tuple(image for image in wanted if not image.on_request)
    for image in standing if bases is None else images.needed(wanted, bases):
        with step(f"stand-in {image.names[0] if image.names else image.id}") as told:
            told.note = images.make(image, wanted, env)
    if git_hosts.given():
        with step("git server") as told:
            told.note = git_hosts.up(env)
        with step("stand-ins that ask it") as told:
            told.note = git_hosts.make(images.references(wanted), env)
    if everything:
        kept.touch()


def _architectures(*, emulated: bool) -> Sequence[str]:
    """Return those of the images; an engine that was found may lack the store that keeps several platforms."""
    return ARCHITECTURES if emulated and images.several_platforms(_docker_environment()) else ARCHITECTURES[:1]


def lint() -> None:
    """Make the linters alone; no engine is needed for them."""
    with lock(sys.stderr), step("linters") as told:
        told.note = str(tools.linters())


def down() -> None:
    """End what the lab started, the last first, and take back what it mounted or registered."""
    with lock(sys.stderr):
        for title, end in (
            ("git server", git_hosts.down),
            ("buildkitd", buildkit.down),
            ("mirror", lambda: registry.down(registry.MIRROR)),
            ("registry", lambda: registry.down(registry.PROTECTED)),
            ("engine", engine.down),
            ("emulation of arm64", emulation.down),
        ):
            with step(title) as told:
                told.note = "ended" if end() else "was not the lab's, or not there"


def status() -> dict[str, str]:
    """Return what runs now, in words, without starting anything."""
    host = engine.host()
    return {
        "engine": host or "none",
        **{
            name: registry.address(name) if processes.running(name) and registry.answers(name) else "down"
            for name in (registry.PROTECTED, registry.MIRROR)
        },
        "buildkitd": buildkit.address() if processes.running(buildkit.NAME) and buildkit.answers() else "down",
        "emulation of arm64": "works" if emulation.works() else "none",
        "stand-ins": _standins_marker().read_text() if _standins_marker().exists() else "not decided yet",
    }


def current() -> Laboratory:
    """Return the laboratory as it runs now.

    Raises LabError, saying what is missing, when it is not up; it starts nothing.
    """
    missing = [name for name, state in status().items() if state in {"none", "down", "not decided yet"}]
    if not missing and _packages_without_image():
        missing = ["ros:jazzy-ros-base of the packages that it was given"]
    if not missing and git_hosts.given() and not processes.running(git_hosts.NAME):
        missing = ["the git server of the folder that it was given"]
    if missing:
        raise LabError(f"the lab is not up ({', '.join(missing)}): run `python3 tests/lab up` first")
    username, password = registry.credentials()
    environment = _environment()
    standins = _standins_marker().read_text() == "yes"
    return Laboratory(
        docker_host=environment["DOCKER_HOST"], registry=registry.address(registry.PROTECTED),
        mirror=registry.address(registry.MIRROR), username=username, password=password, buildkit=buildkit.address(),
        act=tools.act(), node=tools.node(), docker_config=Path(environment["DOCKER_CONFIG"]),
        standins=standins, ros2=not standins or packages_folder.place("jazzy") is not None, environment=environment,
    )  # fmt: skip


def _packages_without_image() -> bool:
    """Tell whether the lab has packages of Jazzy, and its image is still the usual one, or another's.

    Without this a test that needs rclcpp would run on an image whose names of ROS 2 packages are Debian's of ROS 1.
    """
    given = _standins_marker().read_text() == "yes" and packages_folder.place("jazzy") is not None
    return given and not images.stands("jazzy-packages", "ros:jazzy-ros-base", _docker_environment())


def wait() -> None:
    """Return when no other command is at work on the lab: what it makes may be what a test needs."""
    if home().is_dir():
        with lock(io.StringIO()):
            pass


@contextmanager
def laboratory() -> Iterator[Laboratory]:
    """Give a test the laboratory, brought up first where it is not; it stays up for the next test."""
    try:
        lab = current()
    except LabError:
        up()
        lab = current()
    yield lab


def shell_exports() -> str:
    """Return the lines that a shell evaluates to reach the lab."""
    names = ("DOCKER_HOST", "DOCKER_CONFIG", "BUILDX_CONFIG", "BUILDKIT_HOST", "PATH")
    environment = _environment()
    wanted = [name for name in names if name in environment] + list(git_hosts.environment())
    return "\n".join(f"export {name}='{environment[name]}'" for name in wanted)


def _environment() -> dict[str, str]:
    lab = {"PATH": tools.path("node", "lint"), "BUILDKIT_HOST": buildkit.address()}
    return {**os.environ, **_docker_environment(), **git_hosts.environment(), **lab}


def _docker_environment() -> dict[str, str]:
    """Return where the engine is, with a Docker client's folder of the lab's own: no login of the user's is touched."""
    settings = folder("docker-config")
    return {"DOCKER_HOST": engine.host() or engine.own_host(), "DOCKER_CONFIG": str(settings)}


def _log_in(settings: Path, username: str, password: str) -> None:
    """Let the client whose folder this is into the protected registry."""
    login = b64encode(f"{username}:{password}".encode()).decode()
    auths = {registry.address(registry.PROTECTED): {"auth": login}}
    (settings / "config.json").write_text(json.dumps({"auths": auths}))


def _standins_marker() -> Path:
    return folder("run") / "standins"


def usable() -> str:
    """Return "" when this machine can have the lab, else the reason in words, for a test's skip."""
    if engine.host() is None and os.geteuid() != 0:
        return "no Docker engine, and only root can start one"
    if engine.host() is None and not shutil.which("apt-get"):
        return "no Docker engine, and the lab installs one on Debian only"
    able = shutil.which("go") or shutil.which("apt-get")
    return "" if able else "no Go, with which the lab compiles act and buildkitd"
