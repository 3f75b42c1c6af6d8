"""``date``: two days give two plans and two images with the packages of those days, and one day the same image."""

from __future__ import annotations

import csv
import ensurepip
import hashlib
import io
import json
import shutil
import subprocess
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from lab import buildkit, caller, doors
from lab.act import Result, run_workflow
from lab.home import CHECKOUT
from lab.laboratory import Laboratory
from lab.old_world import Signer, deb, release, serving

FIRST, SECOND = "2023-05-10", "2024-05-10"
INDEX = "http://index.example.org/simple"
VERSIONS = {"1.1": FIRST, "2.0": SECOND, "3.0": "2025-05-10"}
"""Of the packages of apt and pip, and the day on which each came."""
STAND_INS = ("build-essential",)
"""Packages that every image of Python has and nothing here needs."""
CONFIG = """\
format: 3
name: NAME
kind: python
base: {image: BASE, ubuntu: jammy}
apt: [robot-extra]
pip: [lab-part]
platforms: [linux/amd64]
test: cat /usr/share/robot-tool /usr/share/robot-extra && python3 -c 'import lab_part; print(lab_part.version)'
"""


def wheel(name: str, version: str) -> bytes:
    """Return a wheel with one module, whose ``version`` tells it."""
    module = name.replace("-", "_")
    folder = f"{module}-{version}.dist-info"
    files = {
        f"{module}.py": f"version = 'lab-part {version}'\n",
        f"{folder}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n",
        f"{folder}/WHEEL": "Wheel-Version: 1.0\nGenerator: lab\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    lines = "".join(f"{path},,\n" for path in (*files, f"{folder}/RECORD"))
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for path, text in {**files, f"{folder}/RECORD": lines}.items():
            archive.writestr(zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0)), text)
    return stream.getvalue()


def listed(name: str, wheels: dict[str, tuple[bytes, str]]) -> dict[str, bytes]:
    """Return the page of a package on the index, and its files; wheels are files and their days by name."""
    entries = [
        {
            "filename": file,
            "url": f"{INDEX}/files/{file}",
            "hashes": {"sha256": hashlib.sha256(data).hexdigest()},
            "upload-time": f"{day}T12:00:00.000000Z",
        }
        for file, (data, day) in wheels.items()
    ]
    page = {"meta": {"api-version": "1.1"}, "name": name, "files": entries, "versions": []}
    files = {f"{INDEX}/files/{file}": data for file, (data, _) in wheels.items()}
    return {f"{INDEX}/{name}/": json.dumps(page).encode(), **files}


@pytest.fixture(scope="module")
def ubuntu(tmp_path_factory: pytest.TempPathFactory) -> Signer:
    """Return the key of the archive."""
    return Signer.make(tmp_path_factory.mktemp("key") / "ubuntu")


@pytest.fixture(scope="module")
def proxy(ubuntu: Signer, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Serve the archive of today, its snapshots of two days, and the index: yields the address before all of it."""
    folder = tmp_path_factory.mktemp("debs")
    files: dict[str, bytes] = {}
    places = ["http://archive.ubuntu.com/ubuntu"]
    places += [f"http://snapshot.ubuntu.com/ubuntu/{day.replace('-', '')}T235959Z" for day in (FIRST, SECOND)]
    for url, version in zip(places, ("3.0", "1.1", "2.0"), strict=True):
        names = ("robot-tool", "robot-extra", *STAND_INS)
        debs = {name: deb(name, folder / version, version=version) for name in names}
        suite = release(ubuntu, "jammy", debs, version=version)
        files.update({f"{url}/{path}": data for path, data in suite.items()})
    parts = {
        f"lab_part-{version}-py3-none-any.whl": (wheel("lab-part", version), day) for version, day in VERSIONS.items()
    }
    files |= listed("lab-part", parts)
    for bundled in (Path(ensurepip.__file__).parent / "_bundled").glob("*.whl"):
        files |= listed(bundled.name.partition("-")[0], {bundled.name: (bundled.read_bytes(), "2023-01-01")})
    files |= listed("wheel", {"wheel-1.0-py3-none-any.whl": (wheel("wheel", "1.0"), "2023-01-01")})
    with serving(files) as address:
        yield address


@pytest.fixture
def base(lab: Laboratory, tmp_path: Path, ubuntu: Signer, proxy: str) -> str:
    """Push a base of today: its own packages are newer than both days."""
    files = {
        "apt/sources.list": "deb http://archive.ubuntu.com/ubuntu/ jammy main\n",
        "apt/apt.conf.d/zz-lab": f'Acquire::http::Proxy "{proxy}";\nAcquire::Retries "0";\n',
        "Dockerfile": "FROM python:3.12-slim\n"
        "RUN rm -rf /etc/apt/sources.list /etc/apt/sources.list.d /var/lib/apt/lists/*\n"
        f"COPY apt/ /etc/apt/\nCOPY ubuntu.gpg /etc/apt/trusted.gpg.d/\nENV http_proxy={proxy} PIP_INDEX_URL={INDEX}\n"
        "RUN apt-get update && apt-get install robot-tool && grep 3.0 /usr/share/robot-tool\n",
    }
    place = doors.write(tmp_path / "base", files)
    (place / "ubuntu.gpg").write_bytes(ubuntu.public(armour=False))
    name = f"repro-lab/dated:{tmp_path.name.replace('_', '-').lower()}"
    pushed = f"{lab.mirror}/{name}"
    environment = dict(lab.environment)
    command = ["docker", "build", "--network", "host", "--tag", pushed, str(place)]
    built = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stderr[-4000:]
    subprocess.run(["docker", "push", pushed], env=environment, check=True, capture_output=True)
    subprocess.run(["docker", "image", "rm", pushed], env=environment, check=True, capture_output=True)
    return name


@pytest.fixture
def action(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Have act take a copy of the project that asks for snapshots by http: nobody here can serve Ubuntu's https."""
    place = tmp_path / "checkout"
    shutil.copytree(caller.program(CHECKOUT), place)
    table = place / "scripts/roslab/knowledge/snapshots.csv"
    text = table.read_text()
    assert [row["address"] for row in csv.DictReader(io.StringIO(text)) if row["address"].startswith("https:")]
    table.write_text(text.replace(",https://snapshot.ubuntu.com", ",http://snapshot.ubuntu.com"))
    monkeypatch.setattr(caller, "CHECKOUT", place)
    return place


def built(lab: Laboratory, folder: Path, base: str, day: str, repository: str) -> Result:
    """Build the image of a day on a runner that has nothing yet, and push it."""
    config = CONFIG.replace("BASE", f"docker.io/{base}").replace("NAME", "lab-dated") + f"date: {day}\n"
    files = {"roslab.yaml": config, "main.py": "import lab_part\n\nprint(lab_part.version)\n"}
    through = doors.through_action(folder / "caller", {"registry": lab.registry, "cache": "none"}, files, base={})
    with buildkit.fresh(folder / "runner") as address:
        builder = {"ROSLAB_BUILDX_DRIVER": "remote", "ROSLAB_BUILDX_ENDPOINT": address}
        ran = run_workflow(lab, through, "push", doors.payload(repository), env=builder)
    assert ran.exit_code == 0, ran.log[-8000:]
    return ran


@pytest.mark.usefixtures("action")
def test_two_days_give_two_images_and_one_day_the_same_one(lab: Laboratory, base: str, tmp_path: Path) -> None:
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    first = built(lab, tmp_path / "first", base, FIRST, repository)
    second = built(lab, tmp_path / "second", base, SECOND, repository)
    again = built(lab, tmp_path / "again", base, FIRST, repository)
    for ran, version in ((first, "1.1"), (second, "2.0"), (again, "1.1")):
        for name in ("robot-tool", "robot-extra", "lab-part"):
            assert f"{name} {version}" in ran.summary
    assert first.output("digests") != second.output("digests")
    assert first.output("digests") == again.output("digests")
