"""How long ``roslab plan`` takes and how much memory, beside what an interpreter and a listing alone take.

``python -m benchmarks.plan`` prints a table per question and ends with code 1 where a goal is missed. All commands of a
table run in turns, so that a busy moment of the machine hits each alike; the median counts. Goals and ratios are of the
wall time; where the machine has more to do than cores, which the first line says, of the time on the processor.
"""

from __future__ import annotations

import argparse
import math
import os
import shutil
import statistics
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from benchmarks.trees import grow

ROOT = Path(__file__).resolve().parent.parent
SCRIPTS = ROOT / "scripts"


@dataclass(frozen=True)
class Goal:
    """What a case may take at most: seconds, megabytes at its peak, times what the table's baseline takes."""

    seconds: float = math.inf
    megabytes: float = math.inf
    times: float = math.inf

    def __str__(self) -> str:
        named = ((self.seconds, "{} s"), (self.megabytes, "{} MB"), (self.times, "{} times"))
        return ", ".join(text.format(limit) for limit, text in named if limit < math.inf)


@dataclass(frozen=True)
class Sample:
    """Wall time and time on the processor in seconds, and peak memory in megabytes, of one run."""

    seconds: float
    processor: float
    megabytes: float


CORES = os.cpu_count() or 1
BUSY = os.getloadavg()[0] > CORES
PARTS = ("examples", "large", "growth")
EXAMPLE = Goal(seconds=0.3, times=12)
LARGE = Goal(seconds=1.0, megabytes=150)
REAL = Goal(times=25)


def measure(command: Sequence[str | Path]) -> Sample:
    """Run a command with its output thrown away. Raises ``SystemExit`` where it fails."""
    words = [os.fspath(word) for word in command]
    nothing = os.open(os.devnull, os.O_RDWR)
    started = time.perf_counter()
    streams = [(os.POSIX_SPAWN_DUP2, nothing, stream) for stream in (0, 1)]
    child = os.posix_spawnp(words[0], words, os.environ, file_actions=streams)
    _, status, usage = os.wait4(child, 0)
    seconds = time.perf_counter() - started
    os.close(nothing)
    if status:
        raise SystemExit(f"{' '.join(words)}: exit code {os.waitstatus_to_exitcode(status)}")
    return Sample(seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)


def side_by_side(commands: dict[str, Sequence[str | Path]], rounds: int) -> dict[str, Sample]:
    """Return the medians of ``rounds`` runs of each command, after one run of each that fills the caches."""
    for command in commands.values():
        measure(command)
    samples: dict[str, list[Sample]] = {name: [] for name in commands}
    for _ in range(rounds):
        for name, command in commands.items():
            samples[name].append(measure(command))
    return {
        name: Sample(
            statistics.median(run.seconds for run in runs),
            statistics.median(run.processor for run in runs),
            max(run.megabytes for run in runs),
        )
        for name, runs in samples.items()
    }


def table(title: str, results: dict[str, Sample], baseline: str, goals: dict[str, Goal]) -> bool:
    """Print the results with their ratio to the baseline; return whether every goal was met."""
    print(f"\n{title}\n")
    print(f"| command | seconds | times `{baseline}` | on the processor | peak MB | goal |")
    print("| --- | ---: | ---: | ---: | ---: | --- |")
    met = True
    for name, sample in results.items():
        verdict = ""
        ratio = _taken(sample) / _taken(results[baseline])
        if goal := goals.get(name):
            good = _taken(sample) <= goal.seconds and sample.megabytes <= goal.megabytes and ratio <= goal.times
            verdict = f"{goal}: {'met' if good else 'MISSED'}"
            met &= good
        figures = f"{sample.seconds:.3f} | {ratio:.1f} | {sample.processor:.3f} | {sample.megabytes:.0f}"
        print(f"| {name} | {figures} | {verdict} |")
    return met


def _taken(sample: Sample) -> float:
    return sample.processor if BUSY else sample.seconds


def plan(folder: Path, python: str) -> list[str | Path]:
    """Return the command that the action and a laptop run."""
    return [python, "-I", SCRIPTS, "plan", folder]


def examples(python: str, rounds: int) -> bool:
    """Measure every example."""
    folders = sorted(path for path in (ROOT / "examples").iterdir() if path.is_dir())
    return beside_an_empty_python("Every example", folders, EXAMPLE, python, rounds)


def beside_an_empty_python(title: str, folders: Sequence[Path], goal: Goal, python: str, rounds: int) -> bool:
    """Measure the plan of each folder, the interpreter's start included."""
    baseline = "python -I -c pass"
    commands: dict[str, Sequence[str | Path]] = {baseline: [python, "-I", "-c", "pass"]}
    commands |= {f"plan {folder.name}": plan(folder, python) for folder in folders}
    goals = {f"plan {folder.name}": goal for folder in folders}
    return table(title, side_by_side(commands, rounds), baseline, goals)


def large(python: str, rounds: int, scratch: Path) -> bool:
    """Measure a tree of 20,000 files with 300 packages."""
    folder = scratch / "large"
    grow(folder, files=20_000, packages=300)
    listing = f"find {folder.name}"
    commands: dict[str, Sequence[str | Path]] = {listing: ["find", folder, "-type", "f", "-printf", "%p %s\\n"]}
    if shutil.which("git"):
        measure(["git", "-C", folder, "init", "--quiet"])
        measure(["git", "-C", folder, "add", "--all"])
        commands["git ls-files large"] = ["git", "-C", folder, "ls-files"]
        commands["git status large"] = ["git", "-C", folder, "status", "--porcelain"]
    commands["plan large"] = plan(folder, python)
    met = table("20,000 files, 300 package.xml", side_by_side(commands, rounds), listing, {"plan large": LARGE})
    shutil.rmtree(folder)
    return met


def growth(python: str, rounds: int, scratch: Path) -> bool:
    """Measure trees of 1,000, 10,000 and 100,000 files: ten times the files may take ten times as long, not more."""
    sizes = (1_000, 10_000, 100_000)
    commands: dict[str, Sequence[str | Path]] = {}
    for size in sizes:
        grow(scratch / str(size), files=size, packages=size * 3 // 200)
        commands[f"find {size:,} files"] = ["find", scratch / str(size), "-type", "f", "-printf", "%p %s\\n"]
        commands[f"plan {size:,} files"] = plan(scratch / str(size), python)
    results = side_by_side(commands, rounds)
    table("Growth", results, f"find {sizes[0]:,} files", {})
    start = measure([python, "-I", "-c", "pass"]).processor
    ratios = []
    for smaller, larger in pairwise(sizes):
        times = [results[f"plan {size:,} files"].processor - start for size in (smaller, larger)]
        ratios.append(times[1] / times[0])
        print(f"\n{smaller:,} -> {larger:,} files: {ratios[-1]:.1f} times as long, the interpreter's start left out")
    return max(ratios) <= 11.0


def main() -> int:
    """Measure, print, and return 1 where a goal is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=7, help="runs of each command (default: 7)")
    parser.add_argument("--python", default=sys.executable, help="an interpreter with roslab's dependencies")
    parser.add_argument("--only", choices=PARTS, action="append", help="a part of it; may be repeated")
    parser.add_argument("--tree", type=Path, action="append", help="a real repository instead; may be repeated")
    options = parser.parse_args()
    parts = () if options.tree else options.only or PARTS
    load = f"a load of {os.getloadavg()[0]:.1f}" + (": goals are held against the processor time" if BUSY else "")
    print(f"Python {sys.version.split()[0]}, {CORES} cores, {load}, median of {options.rounds} runs side by side")
    met = True
    if options.tree:
        met = beside_an_empty_python("Real repositories", options.tree, REAL, options.python, options.rounds)
    with tempfile.TemporaryDirectory(prefix="roslab-benchmark-") as folder:
        if "examples" in parts:
            met &= examples(options.python, options.rounds)
        if "large" in parts:
            met &= large(options.python, options.rounds, Path(folder))
        if "growth" in parts:
            met &= growth(options.python, max(3, options.rounds // 2), Path(folder))
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
