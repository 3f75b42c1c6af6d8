"""Running an image before it gets a tag."""

from __future__ import annotations

import secrets
import subprocess
import tempfile
import time
from collections.abc import Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path

from roslab.config.model import ProofLimits
from roslab.engine.docker import Say, machine_memory, output, say
from roslab.errors import BuildError
from roslab.knowledge.launches import dead_nodes
from roslab.plan.proof import Proof, describe
from roslab.prove.display import virtual_display
from roslab.prove.screenshot import Camera, Screenshot, file_name
from roslab.prove.verdict import End, verdict

PROOF_SECONDS = 10.0
"""Seconds after which a program that keeps running counts as started."""
PROOF_LIMIT = 1800.0
"""Seconds that a test may take: emulated platforms are slow, but a hung test must not hold the job for hours."""
START_LIMIT = 300.0
"""Seconds that a container may take to start; a large image is unpacked first."""
DRAWING_SECONDS = 40.0
"""Seconds after which a program with a display is no longer watched, if it has drawn nothing yet."""
SETTLING_SECONDS = 3.0
"""Fewest seconds from the first drawing to the picture that is kept."""
LONGEST_PAUSE = 2.0
"""Most seconds between two looks at a screen; fewer for a short program."""
KEPT_OUTPUT = 64 * 1024
"""Bytes that are kept from the end of a proof's output."""
READ_OUTPUT = 64 * 1024 * 1024
"""Bytes of output that are searched for dead nodes of a launch: a program may print without end."""

DOMAINS = range(1, 102)
"""Numbers of ROS 2 domains whose ports no system uses for anything else; 0 is everybody's.
https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Domain-ID.html"""


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


def prove(
    reference: str,
    platform: str,
    proofs: Sequence[Proof],
    *,
    limits: ProofLimits,
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
        outcome = _prove_once(reference, platform, proof, [*fences, *given], screenshots)
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
    words = ["--network", limits.network, "--pids-limit", str(limits.pids)]
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


def _prove_once(reference: str, platform: str, proof: Proof, fences: Sequence[str], screenshots: Path) -> Outcome:
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="roslab-")))
        camera, without = _camera(stack, folder) if proof.display else (None, "")
        picture = screenshots / file_name(platform, proof.name)
        with suppress(OSError):
            picture.unlink()  # from an earlier proof
        words = [*fences, "--platform", platform, *(camera.display.options() if camera else ())]
        # Output that a program buffers would be lost when the proof ends it
        words += ["--env", "PYTHONUNBUFFERED=1"] if proof.may_run_on else []
        start = time.monotonic()
        log = folder / "log"
        code, watched = _run([*words, reference, *proof.command], log, proof, camera)
        seconds = time.monotonic() - start
        with log.open("rb") as stream:
            dead = dead_nodes(_text(stream.read(READ_OUTPUT))) if proof.may_run_on else ()
            stream.seek(max(0, log.stat().st_size - KEPT_OUTPUT))
            kept = _text(stream.read())
        screenshot = camera.keep(picture) if camera else Screenshot(remark=without) if without else None
    end = End(code=code, seconds=seconds if code is not None else watched, dead=dead)
    passed, summary = verdict(proof, end, without=without)
    return Outcome(
        proof=proof,
        platform=platform,
        passed=passed,
        seconds=seconds,
        summary=summary,
        output=kept,
        screenshot=screenshot,
    )


def _camera(stack: ExitStack, folder: Path) -> tuple[Camera | None, str]:
    """Start a display for as long as the stack lasts; return a camera for it, or why there is none."""
    try:
        return Camera(display=stack.enter_context(virtual_display(folder))), ""
    except BuildError as error:
        return None, str(error)


def _text(data: bytes) -> str:
    return data.decode("utf-8", errors="replace")


def _run(arguments: Sequence[str], log: Path, proof: Proof, camera: Camera | None) -> tuple[int | None, float]:
    """Run a container, its output to a file; return what ``_watch`` saw."""
    identity = log.with_name("container")
    command = ["docker", "run", "--rm", "--init", "--cidfile", str(identity), *arguments]
    with (
        log.open("wb") as stream,
        subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT) as process,
    ):
        try:
            _wait_for_start(identity, process)
            return _watch(process, proof, camera)
        finally:
            if process.poll() is None:
                _end(identity, process)


def _watch(process: subprocess.Popen[bytes], proof: Proof, camera: Camera | None) -> tuple[int | None, float]:
    """Wait for the end of a proof, or of its time, and look at its screen meanwhile.

    Returns the exit code, ``None`` if the time ended first, and the seconds that it took.
    """
    start = time.monotonic()
    limit = PROOF_SECONDS if proof.may_run_on else PROOF_LIMIT
    latest = DRAWING_SECONDS if proof.may_run_on else PROOF_LIMIT
    drawn: float | None = None
    while True:
        if camera:
            camera.look()
            if drawn is None and (camera.drawn or camera.blind):
                drawn = time.monotonic() - start
        elapsed = time.monotonic() - start
        # An emulated program or a simulator may need longer for its first window, and a moment to fill it
        end = limit if camera is None else latest if drawn is None else max(limit, drawn + SETTLING_SECONDS)
        if elapsed >= end:
            return None, elapsed
        pause = end - elapsed if camera is None else min(end - elapsed, 0.25 + elapsed / 10, LONGEST_PAUSE)
        with suppress(subprocess.TimeoutExpired):
            return process.wait(pause), time.monotonic() - start


def _wait_for_start(identity: Path, process: subprocess.Popen[bytes]) -> None:
    """Wait until the container exists: unpacking a large image may take longer than a proof's seconds."""
    deadline = time.monotonic() + START_LIMIT
    while not identity.exists() and process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.05)


def _end(identity: Path, process: subprocess.Popen[bytes]) -> None:
    if identity.exists():
        output(["docker", "rm", "--force", identity.read_text(encoding="utf-8").strip()])
    try:
        process.wait(30)
    except subprocess.TimeoutExpired:
        process.kill()
