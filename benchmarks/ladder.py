"""What the ladder costs on the ROS 1 example, above the proof as it was before there was one.

``python -m benchmarks.ladder`` builds the example's image and proves it both ways in turns, in the lab or with any
other engine; it ends with code 1 where the median of the seconds above is more than the goal.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from roslab.config.model import ProofGoals, ProofLimits
from roslab.engine import docker as engine
from roslab.pipeline import plan_repository
from roslab.plan.proof import Proof
from roslab.prove import containers
from roslab.prove.ladder import climb

ROOT = Path(__file__).resolve().parent.parent
EXAMPLE = ROOT / "examples" / "ros1_talker"
IMAGE = "ros1_talker:benchmark-ladder"
GOAL = 30.0
"""Most seconds that the ladder may take above."""


def ways() -> dict[str, tuple[tuple[Proof, ...], tuple[Proof, ...]]]:
    """Return the proofs before and with the ladder: of the example as it is, and without its own test.

    Before, a test decided alone; without one, the packages were asked for and the command was watched for 10 seconds.
    """
    written = (EXAMPLE / "roslab.yaml").read_text(encoding="utf-8")
    now = plan_repository(EXAMPLE).plan.proofs
    default = plan_repository(EXAMPLE, config_text=written.partition("# One message")[0]).plan.proofs
    before = tuple(replace(proof, graph=None) for proof in default if "libraries" not in proof.name)
    return {
        "with its test": (tuple(proof for proof in now if proof.rung == 4), now),
        "without a test": (before, default),
    }


def seconds(proofs: Sequence[Proof], platform: str) -> tuple[float, str]:
    """Return how long some proofs took, and how far they got. Raises ``SystemExit`` where one fails."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        outcomes = containers.prove(
            IMAGE,
            platform,
            proofs,
            limits=ProofLimits(),
            goals=ProofGoals(),
            screenshots=Path(folder),
            tell=lambda _: None,
        )
        took = time.monotonic() - start
    if failed := [outcome for outcome in outcomes if not outcome.passed]:
        sys.exit(f"{failed[0].proof.name}: {failed[0].summary}")
    return took, str(climb(proofs, outcomes, ProofGoals()))


def main() -> int:
    """Measure and print."""
    asked = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    asked.add_argument("--times", type=int, default=3, help="runs of each way, in turns (3)")
    options = asked.parse_args()
    command = [sys.executable, "-m", "roslab", "build", str(EXAMPLE), "--tag", IMAGE.partition(":")[2], "--no-proof"]
    subprocess.run(command, check=True, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT / "scripts")})
    platform, over = engine.native_platform(), False
    print(f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores, {platform}, median of {options.times}\n")
    print("| ros1_talker | before | with the ladder | above | reached |\n| --- | ---: | ---: | ---: | --- |")
    for name, both in ways().items():
        runs = [[seconds(proofs, platform) for proofs in both] for _ in range(options.times)]
        before, now = (statistics.median(run[way][0] for run in runs) for way in (0, 1))
        above = statistics.median(run[1][0] - run[0][0] for run in runs)
        over |= above > GOAL
        print(f"| {name} | {before:.1f} s | {now:.1f} s | {above:.1f} s | {runs[0][1][1]} |", flush=True)
    print(f"\nGoal: at most {GOAL:.0f} s above: {'missed' if over else 'met'}.")
    engine.remove_image(IMAGE)
    return int(over)


if __name__ == "__main__":
    sys.exit(main())
