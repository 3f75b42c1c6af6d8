"""A distribution's own packages in the lab: taken from a folder once, kept, and made an image of the real names."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from . import images, packages_folder
from .command import LabError, run


@pytest.fixture(autouse=True)
def own_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Use a home of the test's own, which was given no packages."""
    if not shutil.which("dpkg-deb"):
        pytest.skip("there is no dpkg-deb, with which packages are read")
    monkeypatch.setenv("REPRO_LAB_HOME", str(tmp_path / "home"))
    monkeypatch.delenv(packages_folder.VARIABLE, raising=False)


def package(folder: Path, name: str, version: str = "1.0") -> None:
    """Write an empty package of Debian's into a folder."""
    place = folder / "unpacked" / name
    (place / "DEBIAN").mkdir(parents=True, exist_ok=True)
    control = f"Package: {name}\nVersion: {version}\nArchitecture: all\nMaintainer: a <a@example.org>\nDescription: d\n"
    (place / "DEBIAN" / "control").write_text(control)
    run(["dpkg-deb", "--root-owner-group", "--build", place, folder / f"{name}.deb"])


def test_without_a_folder_the_images_are_the_usual_ones() -> None:
    assert packages_folder.place("jazzy") is None
    made = {image.id: image for image in images.wanted(("amd64",))}
    assert "ros:jazzy-ros-base" in made["jazzy"].names
    assert "jazzy-packages" not in made


def test_what_a_folder_holds_is_kept_and_replaces_the_usual_image(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("ros-jazzy-ros-base", "ros-jazzy-rclcpp", "ros-humble-rclcpp"):
        package(tmp_path, name)
    monkeypatch.setenv(packages_folder.VARIABLE, str(tmp_path))
    place = packages_folder.place("jazzy")
    assert place is not None
    assert sorted(path.name for path in place.glob("*.deb")) == ["ros-jazzy-rclcpp.deb", "ros-jazzy-ros-base.deb"]
    monkeypatch.delenv(packages_folder.VARIABLE)
    assert packages_folder.place("jazzy") == place
    made = {image.id: image for image in images.wanted(("amd64",))}
    assert "jazzy" not in made
    assert "ros:jazzy-ros-base" in made["jazzy-packages"].names
    assert dict(made["jazzy-packages"].contexts)["packages"] == place


def test_another_package_changes_the_index(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(packages_folder.VARIABLE, str(tmp_path))
    indexes = []
    for version in ("1.0", "1.1"):
        package(tmp_path, "ros-jazzy-ros-base", version)
        place = packages_folder.place("jazzy")
        assert place is not None
        indexes.append((place / packages_folder.INDEX).read_text())
    assert "Version: 1.0" in indexes[0]
    assert "Version: 1.1" in indexes[1]


def test_a_folder_without_the_base_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package(tmp_path, "ros-jazzy-rclcpp")
    monkeypatch.setenv(packages_folder.VARIABLE, str(tmp_path))
    with pytest.raises(LabError, match="has no package ros-jazzy-ros-base"):
        packages_folder.place("jazzy")
