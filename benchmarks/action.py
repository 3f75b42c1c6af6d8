"""How long the action's own steps take under act, apart from buildx's: `python3 benchmarks/action.py [EXAMPLE]`.

The steps of Docker's actions are listed for comparison; the proof is the image's own time, one
container for each proof and platform. The lab is brought up where it is not.
"""

from __future__ import annotations

import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from lab import doors, laboratory  # noqa: E402
from lab.act import run_workflow  # noqa: E402

LIMIT = 15.0
"""Seconds, on a machine that does nothing else; the exit code is 1 where the second run misses it."""
OWN = (
    "Prepare the program",
    "Plan",
    "Check the engine and the registry",
    "Write the Dockerfile",
    "Put the tags on the proved image",
    "Write the summary",
)
PROOF = "Prove the image on every platform"
DOCKERS = ("Set up the builder", "Log in", "Name the tags", "Build, and push without a tag")


def main(arguments: list[str]) -> int:
    """Print one line a step, twice: the second run finds the builder's cache warm."""
    example = ROOT / "examples" / (arguments[0] if arguments else "ros2_filter")
    files = {str(path.relative_to(example)): path.read_text() for path in example.rglob("*") if path.is_file()}
    with laboratory.laboratory() as lab, tempfile.TemporaryDirectory() as name:
        repository = lab.fresh_repository(f"{doors.OWNER}/{example.name.replace('_', '-')}").partition("/")[2]
        caller = doors.through_action(Path(name), {"registry": lab.registry}, files, base={})
        for attempt in ("first", "second"):
            payload = doors.payload(repository.partition("/")[2])
            ran = run_workflow(
                lab, caller, "push", payload, env=doors.builder(lab), secrets={"GITHUB_TOKEN": lab.password}
            )
            if ran.exit_code:
                print("\n".join(doors.errors(ran)) or re.sub(r"(?s).*(.{2000})$", r"\1", ran.log))
                return 1
            times = {step: doors.seconds(ran, step) for step in (*OWN, PROOF, *DOCKERS)}
            total = sum(times[step] for step in OWN)
            print(f"{attempt} run of {example.name}: {total:.1f} s in the action's own steps")
            late = total > LIMIT
            for step, seconds in times.items():
                whose = "" if step in OWN else " (the image)" if step == PROOF else " (Docker)"
                print(f"  {seconds:6.1f} s  {step}{whose}")
    return int(late)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
