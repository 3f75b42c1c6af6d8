"""Running an image before it gets a tag."""

from __future__ import annotations

import secrets
import subprocess
import tempfile
import time
from collections.abc import Sequence
from contextlib import ExitStack, suppress
from pathlib import Path

from roslab.config.model import ProofGoals, ProofLimits
from roslab.engine.docker import Say, machine_memory, output, say, starts_shell
from roslab.errors import BuildError
from roslab.knowledge.launches import dead_nodes
from roslab.plan.proof import Proof, describe
from roslab.prove.display import virtual_display
from roslab.prove.graph import Graph
from roslab.prove.probe import Probe
from roslab.prove.said import kept
from roslab.prove.screenshot import Camera, Screenshot, file_name
from roslab.prove.verdict import End, judge, verdict
from roslab.prove.watch import Watch
from roslab.prove.written import results
from roslab.values.dataclass import dataclass, replace

START_LIMIT = 300.0
"""Seconds that a container may take to start; a large image is unpacked first."""
KEPT_OUTPUT = 64 * 1024
"""Bytes that are kept from the end of a proof's output."""
KEPT_BEGINNING = 64 * 1024
"""Characters that are kept from its beginning too, where a node of a launch died."""
READ_OUTPUT = 64 * 1024 * 1024
"""Bytes of output that are searched for dead nodes of a launch: a program may print without end."""

HOST_NAME = "roslab"
"""As docker_run.sh names it. Docker would take hexadecimal digits, and ROS refuses a name that begins with one: launch
files call namespaces after their host. https://design.ros2.org/articles/topic_and_service_names.html"""
DOMAINS = range(1, 102)
"""Numbers of ROS 2 domains whose ports no system uses for anything else; 0 is everybody's.
https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Domain-ID.html"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Seen:
    """What was seen of a container from outside while its command ran."""

    code: int | None = 0
    """Exit code, ``None`` if it was still running."""
    graph: Graph | None = None
    """Only for a proof of a ROS program."""
    respawned: tuple[str, ...] = ()
    restarted: tuple[str, ...] = ()
    written: tuple[str, ...] = ()
    """Figures and result files in the container that were not in the image."""
    on_gpu: int | None = None
    """How many of its processes were seen to compute on a GPU, ``None`` if it was given none."""
    bare: bool = False
    """The image's own command is a shell, which ends without a terminal: no program has started."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Outcome:
    """The result of one proof."""

    proof: Proof
    platform: str
    passed: bool
    seconds: float
    summary: str
    output: str
    screenshot: Screenshot | None = None
    """Only for a proof with a display."""
    held: bool = True
    """The command did what it should; a proof that is only told passes without it."""
    drawn: bool = False
    """More than one colour was on the screen."""
    seen: Seen = Seen()


def prove(
    reference: str,
    platform: str,
    proofs: Sequence[Proof],
    *,
    limits: ProofLimits,
    goals: ProofGoals,
    screenshots: Path,
    gpus: bool = False,
    tell: Say = say,
) -> tuple[Outcome, ...]:
    """Run an image's proofs on one platform, in order, up to the first that fails; never raises for a failed proof.

    ``limits`` are the plan's: what runs in the image is the repository's own, and the machine may hold more than it.
    ``screenshots`` is the folder for the pictures of proofs with a display; it is made when there is a picture.
    ``gpus`` gives the container all GPUs of the machine.
    """
    given = ("--gpus", "all") if gpus else ()
    outcomes: list[Outcome] = []
    fences = options(limits)
    for proof in proofs:
        tell(f"[{platform}] {proof.name}: {describe(proof)}")
        outcome = _prove_once(reference, platform, proof, goals, [*fences, *given], screenshots, gpus=gpus)
        tell("".join(f"    {line}\n" for line in outcome.output.splitlines()[-40:]) + f"[{platform}] {outcome.summary}")
        if outcome.screenshot:
            tell(f"[{platform}] {outcome.screenshot}")
        outcomes.append(outcome)
        if not outcome.passed:
            break
    return tuple(outcomes)


def options(limits: ProofLimits) -> tuple[str, ...]:
    """Return the options of ``docker run`` that fence a proof in, also against other proofs on this machine.

    https://docs.docker.com/reference/cli/docker/container/run/
    """
    memory = limits.memory or (f"{total * 9 // 10}" if (total := machine_memory()) else "")
    words = ["--network", limits.network, "--hostname", HOST_NAME, "--pids-limit", str(limits.pids)]
    words += ["--memory", memory] if memory else []
    words += [] if limits.new_privileges else ["--security-opt", "no-new-privileges"]
    return (*words, *_apart())


def _apart() -> tuple[str, ...]:
    """Return the options by which ROS 2 in a container does not hear the nodes of another container.

    Its nodes find each other by multicast, which docker's bridge carries to every container on it: two proofs at the
    same time would take each other's nodes and messages for their own. Distributions before Iron know only the domain.
    https://docs.ros.org/en/jazzy/Tutorials/Advanced/Improved-Dynamic-Discovery.html
    """
    variables = ("ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST", f"ROS_DOMAIN_ID={secrets.choice(DOMAINS)}")
    return tuple(word for variable in variables for word in ("--env", variable))


def _prove_once(  # noqa: PLR0917 - what one proof is made of
    reference: str,
    platform: str,
    proof: Proof,
    goals: ProofGoals,
    fences: Sequence[str],
    screenshots: Path,
    *,
    gpus: bool,
) -> Outcome:
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="roslab-")))
        camera, without = _camera(stack, folder) if proof.display else (None, "")
        picture = screenshots / file_name(platform, proof.name)
        with suppress(OSError):
            picture.unlink()  # from an earlier proof
        words = [*fences, "--platform", platform, *(camera.display.options() if camera else ())]
        # What a program buffers would be lost when the proof ends it; one that clears the screen asks which it is
        words += ["--env", "PYTHONUNBUFFERED=1", "--env", "TERM=xterm"] if proof.may_run_on else []
        start = time.monotonic()
        log = folder / "log"
        command: Sequence[str] = proof.command
        if not proof.entrypoint:
            words += ["--entrypoint", proof.command[0]]
            command = proof.command[1:]
        seen, watched = _run([*words, reference, *command], log, proof, goals, camera, gpus=gpus)
        seen = replace(seen, bare=proof.rung == 1 and not proof.command and starts_shell(reference))
        seconds = time.monotonic() - start
        with log.open("rb") as stream:
            said = _text(stream.read(READ_OUTPUT)) if proof.may_run_on else ""
            dead = dead_nodes(said)
            stream.seek(max(0, log.stat().st_size - KEPT_OUTPUT))
            last = _text(stream.read())
        if dead and len(said) <= KEPT_BEGINNING + KEPT_OUTPUT:
            last = said
        elif dead:  # those that live may have said much since one died
            last = f"{said[:KEPT_BEGINNING].rpartition(chr(10))[0]}\n…\n{last.partition(chr(10))[2]}"
        screenshot = camera.keep(picture) if camera else Screenshot(remark=without) if without else None
    end = End(code=seen.code, seconds=seconds if seen.code is not None else watched, dead=dead)
    passed, summary = verdict(proof, end, without=without)
    return Outcome(
        proof=proof,
        platform=platform,
        passed=passed,
        seconds=seconds,
        summary=summary,
        output=last,
        screenshot=screenshot,
        held=judge(proof, end)[0],
        drawn=bool(camera and camera.drawn),
        seen=seen,
    )


def _camera(stack: ExitStack, folder: Path) -> tuple[Camera | None, str]:
    """Start a display for as long as the stack lasts; return a camera for it, or why there is none."""
    try:
        return Camera(display=stack.enter_context(virtual_display(folder))), ""
    except BuildError as error:
        return None, str(error)


def _text(data: bytes) -> str:
    return data.decode("utf-8", errors="replace")


def _run(
    arguments: Sequence[str], log: Path, proof: Proof, goals: ProofGoals, camera: Camera | None, *, gpus: bool
) -> tuple[Seen, float]:
    """Run a container, its output to a file; return what was seen and the seconds that it was watched."""
    identity = log.with_name("container")
    # A program that waits for a key waits, as it does for a person; a shell would wait too, so it is told the end
    asked = proof.may_run_on and proof.rung == 1 and bool(proof.command)
    words, given = (("--interactive",), subprocess.PIPE) if asked else ((), subprocess.DEVNULL)
    command = ["docker", "run", "--init", "--log-driver", "none", "--cidfile", str(identity), *words, *arguments]
    with (
        subprocess.Popen(command, stdin=given, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process,
        kept(process, log, head=READ_OUTPUT, tail=KEPT_OUTPUT),
    ):
        try:
            container = _wait_for_start(identity, process)
            probe = _probe(proof, goals, identity) if container else None
            watch = Watch(
                process=process,
                container=container,
                proof=proof,
                goals=goals,
                camera=camera,
                probe=probe,
                log=log,
                gpus=gpus,
            )
            code, seconds = watch.end()
            written = results(container) if container and proof.may_run_on else ()
        finally:
            _end(identity, process)
    if probe:
        probe.end()
    seen = Seen(
        code=code,
        graph=probe.seen() if probe else None,
        respawned=watch.census.respawned,
        restarted=watch.census.restarted,
        written=written,
        on_gpu=len(watch.on_gpu & watch.census.numbers) if gpus else None,
    )
    return seen, seconds


def _probe(proof: Proof, goals: ProofGoals, identity: Path) -> Probe | None:
    if proof.graph is None:
        return None
    return Probe(ros=proof.graph, folder=identity.parent, identity=identity, play=goals.play or "")


def _wait_for_start(identity: Path, process: subprocess.Popen[bytes]) -> str:
    """Return the container's id as soon as it exists: unpacking a large image may take longer than a proof's seconds.

    It is ``""`` if there will be none.
    """
    deadline = time.monotonic() + START_LIMIT
    while process.poll() is None and time.monotonic() < deadline and not _container(identity):
        time.sleep(0.05)
    return _container(identity)


def _container(identity: Path) -> str:
    return identity.read_text(encoding="utf-8").strip() if identity.exists() else ""


def _end(identity: Path, process: subprocess.Popen[bytes]) -> None:
    """End and remove a container with what it wrote; it is no error if there is none."""
    if container := _container(identity):
        output(["docker", "rm", "--force", "--volumes", container])
    try:
        process.wait(30)
    except subprocess.TimeoutExpired:
        process.kill()
