"""A probe in the container of a proof: it looks at the ROS graph from where the nodes are, with what the image has.

Nothing is installed for it: its program comes through standard input, and the image's own Python runs it.
"""

from __future__ import annotations

import subprocess
import time
from contextlib import suppress
from importlib import resources
from pathlib import Path

from roslab.prove import graph
from roslab.prove.graph import Graph
from roslab.values.dataclass import dataclass, field

AGAIN = 1.0
"""Seconds after which a probe is started again, for example because the container was not yet running."""
READ = 1 << 20
"""Bytes from the end of what it printed that hold its last line."""
START = """\
program=$(cat)
for python in python3 python2 python; do command -v $python >/dev/null && exec $python -c "$program" "$@"; done
exit 127
"""


@dataclass(kw_only=True, slots=True)
class Probe:
    """One probe, which is started when it is first tended and ends with its container."""

    ros: str
    """``ros1`` or ``ros2``."""
    folder: Path
    """A private folder on this machine, for what it prints."""
    identity: Path
    """The file that holds the container's id."""
    wanted: tuple[str, ...] = ()
    """Topics on which messages must come."""
    play: str = ""
    """Path in the container of a bag to play once there are nodes."""
    _process: subprocess.Popen[bytes] | None = field(default=None, init=False)
    _started: float = field(default=0.0, init=False)

    def tend(self) -> None:
        """Start the probe if it does not run."""
        now = time.monotonic()
        if self._process is None or (self._process.poll() is not None and now > self._started + AGAIN):
            self._started = now
            self._process = self._start()

    def _start(self) -> subprocess.Popen[bytes] | None:
        with suppress(OSError):
            program = self.folder / "probe.py"
            text = resources.files("roslab.prove.probes").joinpath(f"{self.ros}.py").read_bytes()
            program.write_bytes(text)
            words = ["docker", "exec", "--interactive", self.identity.read_text(encoding="utf-8").strip()]
            with program.open("rb") as source, self._printed.open("ab") as out, self._said.open("wb") as said:
                return subprocess.Popen(
                    [*words, "sh", "-c", START, "probe", self.play], stdin=source, stdout=out, stderr=said
                )
        return None

    @property
    def _printed(self) -> Path:
        return self.folder / "probe"

    @property
    def _said(self) -> Path:
        return self.folder / "probe-errors"

    def seen(self) -> Graph:
        """Return what it saw so far."""
        try:
            with self._printed.open("rb") as stream:
                stream.seek(max(0, self._printed.stat().st_size - READ))
                lines = stream.read().splitlines(keepends=True)
        except OSError:
            lines = []
        whole = [line for line in lines if line.endswith(b"\n")]
        if whole:
            return graph.read(whole[-1].decode("utf-8", errors="replace"), self.ros)
        return Graph(problem=self._problem())

    @property
    def blind(self) -> bool:
        """Whether the image has nothing to look at the graph with."""
        return self._process is not None and self._process.poll() in (126, 127)

    def _problem(self) -> str:
        if self.blind:
            return "the image has no Python to look at the graph with"
        return "the container ended before its graph could be looked at"

    def end(self) -> None:
        """Wait for its end: its container has ended."""
        if self._process is None:
            return
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
