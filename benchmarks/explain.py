"""How many real failing logs ``roslab explain`` explains rightly, and what the largest takes.

``python -m benchmarks.explain FOLDER`` scores the logs of a folder with a ``truth.tsv`` beside them: its columns
``file``, ``class``, ``certain``, ``cause_regex`` and ``fix_regex`` say for each log what a right cause and a right fix
match. Without a folder, only time and memory are measured. Ends with code 1 where a goal is missed.
"""

from __future__ import annotations

import argparse
import csv
import random
import re
import resource
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from io import BytesIO
from pathlib import Path

from roslab.explain.answer import Answer, explain
from roslab.repair import dockerfile

RIGHT, WRONG = 0.90, 0.03
"""Share of the logs that must be explained rightly, and that may be explained wrongly."""
LARGE, SECONDS, MEGABYTES = 100_000_000, 5.0, 200
MUTANTS, EACH = 2000, 10.0
FLAGS = re.IGNORECASE | re.DOTALL


def verdict(answer: Answer, row: dict[str, str]) -> str:
    """Return ``right``, ``cause only``, ``wrong`` or ``unknown``."""
    causes = " ".join(found.cause for found in answer.explanations)
    fixes = " ".join(found.fix for found in answer.explanations)
    if not causes:
        return "unknown"
    if not re.search(row["cause_regex"], causes, FLAGS):
        return "wrong"
    return "right" if re.search(row["fix_regex"], fixes, FLAGS) else "cause only"


def has_lines(answer: Answer) -> bool:
    """Return whether an answer holds lines to paste, into roslab.yaml or an author's own Dockerfile."""
    return bool(dockerfile.suggested(answer)) or any(found.repair for found in answer.explanations)


def score(folder: Path) -> bool:
    """Print what became of each log that was not explained rightly, and the counts; tell whether the goals are met."""
    with (folder / "truth.tsv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream, delimiter="\t", quoting=csv.QUOTE_NONE))
    counts: Counter[str] = Counter()
    slowest = 0.0
    for row in rows:
        begun = time.process_time()
        with (folder / row["file"]).open("rb") as log:
            answer = explain(log)
        slowest = max(slowest, time.process_time() - begun)
        found = verdict(answer, row)
        counts[found] += 1
        counts["lines"] += found == "right" and has_lines(answer)
        if found != "right":
            known = ", ".join(each.id or "no known cause" for each in answer.explanations)
            uncertain = ", its log does not settle it" if row.get("certain") == "no" else ""
            print(f"{row['file']}: {found} ({known}); {row['class']}{uncertain}")
    told = ", ".join(f"{counts[name]} {name}" for name in ("right", "cause only", "wrong", "unknown"))
    print(f"{len(rows)} logs: {told}; slowest {slowest:.2f} s on the processor")
    print(f"{counts['lines']} of the right ones with lines to paste, made from the log alone")
    return counts["right"] >= RIGHT * len(rows) and counts["wrong"] <= WRONG * len(rows)


def large() -> bool:
    """Explain a log of 100 MB whose first error is a third into it."""
    line = b"#6 7.1 [ 12%] Building CXX object src/CMakeFiles/robot.dir/planner.cpp.o\n"
    error = b"#6 9.2 src/a.cpp:3:10: fatal error: glog/logging.h: No such file or directory\n"
    end = b'#6 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2\n'
    with tempfile.TemporaryFile() as log:
        third = line * (LARGE // len(line) // 3)
        log.write(b"#6 [3/4] RUN make\n" + third + error)
        log.write(third)
        log.write(third + end)
        del third
        log.seek(0)
        begun = time.process_time()
        lines = sum(1 for _ in log)
        alone = time.process_time() - begun
        log.seek(0)
        begun = time.process_time()
        answer = explain(log)
        seconds = time.process_time() - begun
    megabytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    known = [found.id for found in answer.explanations]
    times = f"{seconds / alone:.1f} times what a loop over its {lines} lines takes"
    print(f"100 MB: {known}, {seconds:.2f} s on the processor, {times}; peak of this program {megabytes:.0f} MB")
    return known == ["header-missing"] and seconds <= SECONDS and megabytes <= MEGABYTES


def mutants(seeds: Sequence[bytes]) -> bool:
    """Explain changed logs: none may end in an exception or take longer than ten seconds."""
    source, slowest = random.Random(20261121), 0.0
    for data in _changed(source, seeds):
        begun = time.process_time()
        explain(BytesIO(data))
        slowest = max(slowest, time.process_time() - begun)
    print(f"{MUTANTS} changed logs: slowest {slowest:.2f} s on the processor")
    return slowest <= EACH


def _changed(source: random.Random, seeds: Sequence[bytes]) -> Iterator[bytes]:
    for _ in range(MUTANTS):
        data = bytearray(source.choice(seeds))
        for _ in range(source.randrange(1, 30)):
            at = source.randrange(len(data) + 1)
            kind = source.randrange(4)
            if kind == 0:
                data[at : at + 1] = bytes([source.randrange(256)])
            elif kind == 1:
                del data[at : at + source.randrange(4000)]
            elif kind == 2:
                data[at:at] = data[: source.randrange(4000)]
            else:
                data[at:at] = bytes([source.randrange(256)]) * source.randrange(20_000)
        yield bytes(data)


def main() -> int:
    """Run what the arguments ask for."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("folder", nargs="?", type=Path, help="a folder of logs with their truth.tsv")
    options.add_argument("--mutants", action="store_true", help=f"explain {MUTANTS} changed logs too: minutes")
    chosen = options.parse_args()
    met = large()
    seeds = [b"#6 [3/4] RUN make\n#6 9.2 a.cpp:3:10: fatal error: a.h: No such file or directory\n"]
    if chosen.folder is not None:
        met = score(chosen.folder) and met
        seeds = [file.read_bytes() for file in sorted(chosen.folder.glob("*.log"))]
    if chosen.mutants:
        met = mutants(seeds) and met
    print("goals met" if met else "a goal was missed")
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
