"""Sizes of images: the 2024 paper's way, the whole image, the slim one; and what images on one base share.

``python -m benchmarks.size`` builds examples in the lab, which must be up (``python3 tests/lab up``), each the ways
beside each other, a few minutes an example. Sizes are those of the compressed layers, as a registry keeps them. What
was measured is merged into benchmarks/results/size.json. ``--shared 20`` builds as many made-up repositories on one
base.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
from pathlib import Path
from typing import Any

from benchmarks.rebuild.repositories import EXAMPLES, MANIFEST, package

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "benchmarks" / "results" / "size.json"
WAYS = ("paper", "whole", "whole-zstd", "slim", "slim-zstd")

# The order and the options of the Dockerfiles in the article of 2024 (algorithms 1, 4 and 5)
ROS = """\
FROM {base}
RUN mkdir -p /ws/src
COPY . /ws/src/
RUN . /opt/ros/$ROS_DISTRO/setup.sh && apt-get update \\
  && DEBIAN_FRONTEND=noninteractive rosdep install -y --from-paths /ws/src --ignore-src{apt} \\
  && rm -rf /var/lib/apt/lists/*
RUN . /opt/ros/$ROS_DISTRO/setup.sh && cd /ws && {build}
CMD ["bash"]
"""
UBUNTU = """\
FROM ubuntu:22.04
ARG DEBIAN_FRONTEND=noninteractive
RUN apt-get update && apt-get install -y {apt} && rm -rf /var/lib/apt/lists/*
{pip}COPY . /source/
RUN cd /source && {build}
CMD ["bash"]
"""
PIP = "RUN python3 -m pip install --upgrade pip\n"
CPP = "mkdir -p build && cd build && cmake -DCMAKE_BUILD_TYPE=Release .. && make"
PAPER = {
    "ros1_talker": ROS.format(base="ros:noetic-ros-base", apt="", build="catkin_make"),
    "ros2_filter": ROS.format(base="ros:jazzy-ros-base", apt="", build="colcon build"),
    "ros2_talker": ROS.format(base="ros:jazzy-ros-base", apt="", build="colcon build"),
    "monorepo": ROS.format(
        base="ros:noetic-ros-base",
        apt=" && apt-get install -y python3-pip && python3 -m pip install /ws/src/python",
        build="catkin_make",
    ),
    "python_filter": UBUNTU.format(
        apt="python3-pip python3-tk", pip=PIP, build="python3 -m pip install -r requirements.txt"
    ),
    "no_config": UBUNTU.format(apt="build-essential cmake libeigen3-dev", pip="", build=CPP),
}
"""Of the examples that the lab builds; ``own_dockerfile`` is built as its author wrote it, whatever the way."""


def prepared(name: str, folder: Path) -> Path:
    """Copy an example and write both Dockerfiles out of it: ``paper`` and ``Dockerfile``, with the target ``slim``."""
    root = folder / name
    shutil.copytree(EXAMPLES / name, root, ignore=shutil.ignore_patterns("__pycache__"))
    config = root / "roslab.yaml"
    config.write_text((config.read_text() if config.exists() else "format: 3\n") + "slim: true\n")
    create(root, folder / "output")
    (folder / "output" / "paper").write_text(PAPER.get(name, ""))
    return root


def create(root: Path, output: Path) -> None:
    """Write what ``roslab create`` writes to another folder."""
    command = [sys.executable, "-I", str(ROOT / "scripts"), "create", str(root), "--output", str(output), "--force"]
    subprocess.run(command, check=True, capture_output=True)


def built(root: Path, dockerfile: Path, archive: Path, *words: str, compression: str = "gzip") -> list[dict[str, Any]]:
    """Build an image into an OCI archive and return the descriptors of its layers."""
    output = f"type=oci,dest={archive},compression={compression},force-compression=true"
    command = ["docker", "buildx", "build", "--provenance=false", "--file", str(dockerfile), "--output", output]
    done = subprocess.run([*command, *words, str(root)], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(done.stderr[-6000:])
    with tarfile.open(archive) as files:
        found: dict[str, Any] = json.load(files.extractfile("index.json") or sys.stdin)
        while "manifests" in found:
            digest = found["manifests"][0]["digest"].replace(":", "/")
            found = json.load(files.extractfile(f"blobs/{digest}") or sys.stdin)
    layers: list[dict[str, Any]] = found["layers"]
    return layers


def unpacked(archive: Path, layers: list[dict[str, Any]], compression: str) -> float:
    """Return the seconds of processor time that reading the layers of an archive takes their program."""
    before = os.times()
    with tarfile.open(archive) as files:
        for layer in layers:
            blob = files.extractfile(f"blobs/{layer['digest'].replace(':', '/')}")
            with subprocess.Popen([compression, "-dc"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL) as program:
                assert blob
                assert program.stdin
                shutil.copyfileobj(blob, program.stdin)
                program.stdin.close()
    after = os.times()
    return round(after.children_user + after.children_system - before.children_user - before.children_system, 2)


def measure(name: str, ways: tuple[str, ...]) -> dict[str, dict[str, float]]:
    """Build an example the ways and return the bytes of each, and the seconds that its layers take to unpack."""
    found: dict[str, dict[str, float]] = {}
    with tempfile.TemporaryDirectory(prefix="roslab-size-") as place:
        root = prepared(name, Path(place))
        for way in ways:
            kind, _, zstd = way.partition("-")
            if kind == "paper" and name not in PAPER:
                continue
            dockerfile = Path(place, "output", "paper" if kind == "paper" else "Dockerfile")
            archive = Path(place, "image.tar")
            started = time.monotonic()
            compression = zstd or "gzip"
            target = ("--target", "slim") if kind == "slim" else ()
            layers = built(root, dockerfile, archive, *target, compression=compression)
            seconds = unpacked(archive, layers, compression) if shutil.which(compression) else None
            found[way] = {"bytes": sum(layer["size"] for layer in layers)}
            found[way] |= {"unpacking": seconds} if seconds is not None else {}
            print(f"{name} {way}: {found[way]}, {time.monotonic() - started:.0f} s", file=sys.stderr, flush=True)
    return found


def shared(count: int) -> dict[str, Any]:
    """Build made-up repositories on one base and return how much of their images is in all of them.

    The 2019 paper's Table 1 gives, for its nine examples, 3.742 GB of 4.471 to 5.131 GB.
    """
    sizes, common = [], None
    layers: dict[str, int] = {}
    with tempfile.TemporaryDirectory(prefix="roslab-shared-") as place:
        for index in range(count):
            root = Path(place, f"article_{index:02}")
            _article(root, index)
            create(root, Path(place, "output"))
            found = built(root, Path(place, "output", "Dockerfile"), Path(place, "image.tar"))
            layers |= {layer["digest"]: layer["size"] for layer in found}
            digests = {layer["digest"] for layer in found}
            common = digests if common is None else common & digests
            sizes.append(sum(layer["size"] for layer in found))
            print(f"{root.name}: {sizes[-1] / 1e6:.1f} MB", file=sys.stderr, flush=True)
    together = sum(layers[digest] for digest in common or ())
    return {"images": count, "shared": together, "sizes": sizes, "stored": sum(layers.values())}


def _article(root: Path, index: int) -> None:
    """Write a ROS 1 repository of one package, unlike its neighbours in code and in what it needs."""
    name = f"article_{index:02}"
    needs = ("tf2_ros", "sensor_msgs", "nav_msgs", "python3-yaml", "python3-scipy")
    manifest = MANIFEST.replace("</package>", f"  <exec_depend>{needs[index % len(needs)]}</exec_depend>\n</package>")
    package(root, name, index, manifest)


def table(results: dict[str, Any]) -> str:
    """Return the sizes as a table of Markdown, each beside its part of the paper's."""
    lines = [f"| example | {' | '.join(WAYS)} |", f"| --- |{' ---: |' * len(WAYS)}"]
    for name, ways in sorted(results.get("examples", {}).items()):
        paper = ways.get("paper", {}).get("bytes")
        cells = []
        for way in WAYS:
            size = ways.get(way, {}).get("bytes")
            part = f", {size / paper:.2f}" if size and paper and way != "paper" else ""
            cells.append(f"{size / 1e6:.0f} MB{part}" if size else "")
        lines.append(f"| {name} | {' | '.join(cells)} |")
    if found := results.get("shared"):
        low, high = (found["shared"] / found_size for found_size in (max(found["sizes"]), min(found["sizes"])))
        lines.append(
            f"\n{found['images']} images on one base: {found['shared'] / 1e6:.0f} MB of each are in all of them, "
            f"{low:.0%} to {high:.0%}; together they take {found['stored'] / 1e6:.0f} MB."
        )
    return "\n".join(lines) + "\n"


def main() -> int:
    """Measure what was asked for, keep it, print all that is known."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("examples", nargs="*", help="default: all")
    parser.add_argument("--way", choices=WAYS, action="append", help="default: all")
    parser.add_argument("--shared", type=int, metavar="N", help="build N made-up repositories on one base instead")
    parser.add_argument("--show", action="store_true", help="build nothing, print the last figures")
    options = parser.parse_args()
    results: dict[str, Any] = json.loads(RESULTS.read_text()) if RESULTS.exists() else {}
    if options.shared:
        results["shared"] = shared(options.shared)
    for name in () if options.show or options.shared else options.examples or PAPER:
        found = measure(name, tuple(options.way or WAYS))
        results.setdefault("examples", {}).setdefault(name, {}).update(found)
        RESULTS.write_text(json.dumps(results, indent=2) + "\n")
    RESULTS.write_text(json.dumps(results, indent=2) + "\n")
    print(table(results), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
