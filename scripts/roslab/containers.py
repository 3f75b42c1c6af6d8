"""Running an image before it gets a tag."""

from __future__ import annotations

import subprocess
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from roslab.engine import Say, last_line, output, say
from roslab.errors import BuildError, Problem
from roslab.proof import Proof, describe

PROOF_SECONDS = 10.0
"""How long a program without an end is watched before it counts as alive."""
PROOF_LIMIT = 1800.0
"""How long a test may take: emulated platforms are slow, but a hung one must not hold the job for hours."""
START_LIMIT = 300.0
"""How long a container may take to start; a large image is unpacked first."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Outcome:
    """What one proof came to."""

    proof: Proof
    platform: str
    passed: bool
    seconds: float
    summary: str
    output: str


def prove(
    reference: str, platform: str, proofs: Sequence[Proof], *, pull: bool = False, tell: Say = say
) -> tuple[Outcome, ...]:
    """Run an image's proofs on one platform, in order, up to the first that fails; never raises for a failed proof.

    ``pull`` fetches the image first: the proof then runs what the registry holds.
    """
    if pull:
        answer = output(["docker", "pull", "--quiet", "--platform", platform, reference], timeout=PROOF_LIMIT)
        if answer.returncode:
            raise BuildError(Problem(message=f"cannot pull {reference} for {platform}: {last_line(answer.stderr)}"))
    outcomes: list[Outcome] = []
    for proof in proofs:
        tell(f"[{platform}] {proof.name}: {describe(proof)}")
        outcome = _prove_once(reference, platform, proof)
        tell("".join(f"    {line}\n" for line in outcome.output.splitlines()[-40:]) + f"[{platform}] {outcome.summary}")
        outcomes.append(outcome)
        if not outcome.passed:
            break
    return tuple(outcomes)


def _prove_once(reference: str, platform: str, proof: Proof) -> Outcome:
    with tempfile.TemporaryDirectory() as folder:
        identity = Path(folder) / "container"
        command = [
            "docker",
            "run",
            "--rm",
            "--init",
            "--cidfile",
            str(identity),
            "--platform",
            platform,
            reference,
            *proof.command,
        ]
        limit = PROOF_SECONDS if proof.may_run_on else PROOF_LIMIT
        start = time.monotonic()
        log = Path(folder) / "log"
        with (
            log.open("wb") as stream,
            subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT) as process,
        ):
            try:
                _wait_for_start(identity, process)
                code: int | None = process.wait(limit)
            except subprocess.TimeoutExpired:
                code = None
            finally:
                if process.poll() is None:
                    _end(identity, process)
        seconds = time.monotonic() - start
        output = log.read_bytes()[-65536:].decode("utf-8", errors="replace")
    alive = code is None and proof.may_run_on
    passed = alive or code == 0
    if alive:
        summary = f"passed: still running after {limit:.0f} s"
    elif code is None:
        summary = f"failed: no end within {limit:.0f} s"
    else:
        summary = f"passed in {seconds:.1f} s" if passed else f"failed with exit code {code} after {seconds:.1f} s"
    if not passed and not proof.required:
        # Only guessed: programs that want data or a robot are no reason to withhold an image that is whole
        summary = f"not proved: the guessed command {summary}; name the right one as `command` in roslab.yaml"
        passed = True
    return Outcome(proof=proof, platform=platform, passed=passed, seconds=seconds, summary=summary, output=output)


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
