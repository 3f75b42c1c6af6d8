"""Watching a proof's container until it ends or its time is over: its screen, its processes, its ROS graph."""

from __future__ import annotations

import subprocess
import time
from contextlib import suppress
from pathlib import Path

from roslab.config.model import ProofGoals
from roslab.engine import gpu
from roslab.knowledge.launches import waiting_nodes
from roslab.plan.proof import Proof
from roslab.prove.probe import Probe
from roslab.prove.processes import Census
from roslab.prove.screenshot import Camera
from roslab.values.dataclass import dataclass, field

PROOF_SECONDS = 10.0
"""Seconds after which a program that keeps running counts as started."""
PROOF_LIMIT = 1800.0
"""Seconds that a test may take: emulated platforms are slow, but a hung test must not hold the job for hours."""
DRAWING_SECONDS = 40.0
"""Seconds after which a program with a display is no longer watched, if it has drawn nothing yet."""
SETTLING_SECONDS = 3.0
"""Fewest seconds from the first drawing to the picture that is kept."""
LISTENING_SECONDS = 30.0
"""Seconds after which a graph is no longer listened to, if a topic of it is still silent."""
SLOWEST = 120.0
"""The same where the probe did not listen for ``PROOF_SECONDS`` yet, and where a launch has not tried all of its nodes:
under emulation, and on a busy machine."""
MOST_OUTPUT = 256 * 1024
"""Most bytes of the output that are looked at for nodes: a launch lists them at its beginning."""
LONGEST_PAUSE = 2.0
"""Most seconds between two looks at a screen; fewer for a short program."""
COUNTING_PAUSE = 1.0
"""Seconds between two looks at the processes, each of which costs a call of the engine."""


@dataclass(kw_only=True, slots=True)
class Watch:
    """The watch over one container."""

    process: subprocess.Popen[bytes]
    """The ``docker run`` that holds it."""
    container: str
    proof: Proof
    goals: ProofGoals
    camera: Camera | None
    probe: Probe | None
    log: Path | None = None
    """Where its output is written."""
    gpus: bool = False
    """The container was given the machine's GPUs."""
    census: Census = field(default_factory=Census)
    on_gpu: set[int] = field(default_factory=set, init=False)
    """Processes of this machine that were seen on a GPU."""
    _drawn: float | None = field(default=None, init=False)
    _waited: bool = field(default=False, init=False)
    _tried: float | None = field(default=None, init=False)
    _counted: float = field(default=0.0, init=False)

    def end(self) -> tuple[int | None, float]:
        """Wait for the end; return the exit code, ``None`` if the time ended first, and the seconds that it took."""
        start = time.monotonic()
        while True:
            self._look(start)
            elapsed = time.monotonic() - start
            end = self._limit(elapsed)
            if elapsed >= end:
                return None, elapsed
            pause = end - elapsed
            if self.camera or self._counts:
                pause = min(pause, 0.25 + elapsed / 10, LONGEST_PAUSE if self.camera else COUNTING_PAUSE)
            with suppress(subprocess.TimeoutExpired):
                return self.process.wait(pause), time.monotonic() - start

    def _look(self, start: float) -> None:
        if self.probe:
            self.probe.tend()
        if self.camera:
            self.camera.look()
            if self._drawn is None and (self.camera.drawn or self.camera.blind):
                self._drawn = time.monotonic() - start
        if self._counts and time.monotonic() >= self._counted + COUNTING_PAUSE:
            self.census.look(self.container)
            if self.gpus:
                self.on_gpu |= gpu.users()
            self._counted = time.monotonic()

    @property
    def _counts(self) -> bool:
        """Whether its processes are of interest."""
        return self.proof.may_run_on or self.gpus

    def _limit(self, elapsed: float) -> float:
        """Return the second at which the watch is over, as far as it is known now."""
        if not self.proof.may_run_on:
            return self.proof.limit or PROOF_LIMIT
        limits = [float(self.goals.seconds or PROOF_SECONDS)]
        if self.camera:
            # An emulated program or a simulator may need longer for its first window, and a moment to fill it
            limits.append(DRAWING_SECONDS if self._drawn is None else self._drawn + SETTLING_SECONDS)
        if self.log and not self.goals.seconds and elapsed >= limits[0]:
            limits.append(self._launching(self.log, elapsed))
        if self.probe and not self.goals.seconds and elapsed >= limits[0]:
            limits.append(self._listening(elapsed))
        return max(limits)

    def _launching(self, log: Path, elapsed: float) -> float:
        """Return the second until which a launch is watched that had not tried all of its nodes in time."""
        if self._tried is None:
            with log.open("rb") as stream:
                said = stream.read(MOST_OUTPUT)
            if waiting_nodes(said.decode("utf-8", errors="replace")):
                self._waited = True
                return SLOWEST
            self._tried = elapsed
        return min(self._tried + PROOF_SECONDS, SLOWEST) if self._waited else elapsed

    def _listening(self, elapsed: float) -> float:
        """Return the second until which the graph is listened to."""
        if self.probe is None or self.probe.blind:
            return elapsed
        seen = self.probe.seen()
        if seen.seconds < PROOF_SECONDS:
            return SLOWEST
        return LISTENING_SECONDS if seen.nodes and not seen.settled(self.goals.topics) else elapsed
