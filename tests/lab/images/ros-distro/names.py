"""Run inside the build of a ROS stand-in: make the distribution's package names and its rosdep table.

For every ROS package that Debian has under names of its own, an empty package `ros-DISTRO-NAME` that depends on
Debian's goes into a local apt repository; so do the tools' names of the ROS repository (python3-catkin-tools ...).
The rosdep table maps ROS packages to those names and common system keys to Debian's packages; a key that neither has
stays unresolved, as an unknown key does in reality. Usage: names.py DISTRO

Where the distribution's packages are there themselves, `names.py DISTRO INDEX` names the index of their apt source:
nothing of Debian's ROS then gets a name, and the rosdep table maps to those packages alone.
"""

from __future__ import annotations

import gzip
import hashlib
import re
import subprocess
import sys
from pathlib import Path

import yaml

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

HERE = Path(__file__).parent
DEBIAN_TABLE = Path("/usr/share/python3-rosdep2/debian.yaml")
ROSDEP = Path("/etc/ros/rosdep")
REPOSITORY = Path("/opt/lab/apt")
# High, because some of Debian's packages refuse old versions of their Python 2 ancestors.
VERSION = "99-stand-in"


def main(distro: str, index: str = "") -> None:
    data = tomllib.loads((HERE / "names.toml").read_text())
    known = set(_lines("apt-cache", "pkgnames"))
    ros, names = _indexed(distro, Path(index)) if index else _debians(distro, data, known)
    tools = {name: packages for name, packages in data["tools"].items() if name not in known and set(packages) <= known}
    _write_repository({**names, **tools})
    rules = _system_rules(known)
    _write("stand-in.yaml", rules)
    _write("index-v4.yaml", _index(distro, data))
    _write(f"{distro}.yaml", _distribution(ros))
    _install_satisfied(names)
    print(f"{len(names)} names of {distro}, {len(tools)} of tools, {len(rules)} system keys")


def _debians(
    distro: str, data: dict[str, dict[str, list[str]]], known: set[str]
) -> tuple[list[str], dict[str, list[str]]]:
    """Return the ROS packages that Debian has, and their names in this distribution with Debian's packages."""
    ros = {name: packages for name, packages in _ros_packages(data, known).items() if set(packages) <= known}
    return sorted(ros), {f"ros-{distro}-{name.replace('_', '-')}": packages for name, packages in ros.items()}


def _indexed(distro: str, index: Path) -> tuple[list[str], dict[str, list[str]]]:
    """Return the ROS packages of an apt source; they have their names already, so none is to be made."""
    found = re.findall(rf"^Package: ros-{distro}-(\S+)$", index.read_text(), re.MULTILINE)
    return sorted(name.replace("-", "_") for name in found), {}


def _rule(answer: object) -> dict[str, object]:
    """Answer the same for both names of the system: the stand-in is Debian, what it stands in for is Ubuntu."""
    return {"debian": answer, "ubuntu": answer}


def _system_rules(known: set[str]) -> dict[str, object]:
    rules: dict[str, object] = {}
    for line in (HERE / "system_keys.tsv").read_text().splitlines():
        if line.startswith("#"):
            continue
        key, installer, names = line.split("\t")
        packages = names.split()
        if installer == "pip":
            rules[key] = _rule({"pip": {"packages": packages}})
        elif set(packages) <= known:
            rules[key] = _rule(packages)
    return rules


def _index(distro: str, data: dict[str, dict[str, list[str]]]) -> dict[str, object]:
    """Return an index of this distribution alone; `rosdep update` skips one that has ended, as it does in reality."""
    old = distro in data["distros"]["end_of_life"]
    entry = {
        "distribution": [f"{distro}.yaml"],
        "distribution_status": "end-of-life" if old else "active",
        "distribution_type": "ros1" if distro in data["distros"]["ros1"] else "ros2",
        "python_version": 3,
    }
    return {"type": "index", "version": 4, "distributions": {distro: entry}}


def _distribution(packages: list[str]) -> dict[str, object]:
    """Return a distribution file that releases these ROS packages, from which rosdep makes names like ros-noetic-tf."""
    release = {
        "packages": packages,
        "tags": {"release": "release/{package}/{version}"},
        "url": "file:///nowhere.git",
        "version": "0.0.0-0",
    }
    platforms = {"debian": ["bookworm"], "ubuntu": ["xenial", "bionic", "focal", "jammy", "noble", "resolute"]}
    return {
        "type": "distribution",
        "version": 2,
        "release_platforms": platforms,
        "repositories": {"stand-in": {"release": release}},
    }


def _write(name: str, content: object) -> None:
    ROSDEP.mkdir(parents=True, exist_ok=True)
    (ROSDEP / name).write_text("%YAML 1.1\n---\n" + yaml.safe_dump(content, sort_keys=True))


def _ros_packages(data: dict[str, dict[str, list[str]]], known: set[str]) -> dict[str, list[str]]:
    """Return ROS package name -> Debian packages: Debian's own rosdep table, then what its ros-* sources suggest."""
    found: dict[str, list[str]] = dict(data["ros"])
    for name, rule in yaml.safe_load(DEBIAN_TABLE.read_text()).items():
        packages = rule.get("debian") if isinstance(rule, dict) else None
        if re.fullmatch(r"[a-z][a-z0-9_]*", name) and isinstance(packages, list) and set(packages) <= known:
            found.setdefault(name, packages)
    suggested: dict[str, list[str]] = {}
    for package in _of_ros_sources():
        for before, after in (("lib", "-dev"), ("python3-", ""), ("ros-", "")):
            if package.startswith(before) and package.endswith(after):
                name = package[len(before) : len(package) - len(after) or None].replace("-", "_")
                suggested.setdefault(name, []).append(package)
    for name, packages in suggested.items():
        found.setdefault(name, sorted(packages))
    return found


def _of_ros_sources() -> list[str]:
    packages = []
    dumped = subprocess.run(["apt-cache", "dumpavail"], capture_output=True, text=True, check=True).stdout
    for stanza in dumped.split("\n\n"):
        fields = dict(line.split(": ", 1) for line in stanza.splitlines() if ": " in line and not line.startswith(" "))
        if fields.get("Source", "").startswith("ros-"):
            packages.append(fields["Package"])
    return packages


def _write_repository(names: dict[str, list[str]]) -> None:
    REPOSITORY.mkdir(parents=True)
    stanzas = []
    for name, depends in sorted(names.items()):
        place = Path("/tmp/lab/deb") / name
        (place / "DEBIAN").mkdir(parents=True)
        control = (
            f"Package: {name}\nVersion: {VERSION}\nArchitecture: all\nMaintainer: the lab <lab@localhost>\n"
            f"Depends: {', '.join(depends)}\nDescription: stand-in that depends on Debian's package of the same thing\n"
        )
        (place / "DEBIAN" / "control").write_text(control)
        file = REPOSITORY / f"{name}.deb"
        command = ["dpkg-deb", "-Znone", "--root-owner-group", "--build", str(place), str(file)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        content = file.read_bytes()
        found = f"Size: {len(content)}\nSHA256: {hashlib.sha256(content).hexdigest()}\n"
        stanzas.append(f"{control}Filename: ./{file.name}\n{found}")
    index = "\n".join(stanzas).encode()
    files = {"Packages": index, "Packages.gz": gzip.compress(index, mtime=0)}
    # Without a Release file apt tries every compression it knows and complains of each.
    release = "Suite: stand-in\nDate: Thu, 01 Jan 2026 00:00:00 UTC\nSHA256:\n"
    for name, content in files.items():
        (REPOSITORY / name).write_bytes(content)
        release += f" {hashlib.sha256(content).hexdigest()} {len(content)} {name}\n"
    (REPOSITORY / "Release").write_text(release)
    Path("/etc/apt/sources.list.d/stand-in.list").write_text(f"deb [trusted=yes] file:{REPOSITORY} ./\n")


def _install_satisfied(names: dict[str, list[str]]) -> None:
    """Install the names whose Debian packages this image holds already: the real image has them installed."""
    have = set(_lines("dpkg-query", "-W", "-f", "${Package}\n"))
    satisfied = [str(REPOSITORY / f"{name}.deb") for name, packages in names.items() if set(packages) <= have]
    if satisfied:
        subprocess.run(["dpkg", "-i", *sorted(satisfied)], check=True, stdout=subprocess.DEVNULL)


def _lines(*command: str) -> list[str]:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()


if __name__ == "__main__":
    main(*sys.argv[1:])
