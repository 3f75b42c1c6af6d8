"""A credential that a checkout left in the repository, and the Dockerfile whose build does not see it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.github import checkout

HEADER = '[http "https://github.com/"]\n\textraheader = AUTHORIZATION: basic eDp5\n'
ADDRESS = '[remote "origin"]\n\turl = https://user:password@example.org/a/b.git\n'
CLEAN = '[remote "origin"]\n\turl = https://github.com/a/b.git\n[remote "b"]\n\turl = ssh://git@example.org:22/b.git\n'


def repository(root: Path, configuration: str, place: str = ".git/config", **ignores: str) -> tuple[Path, Path]:
    """Write a checkout; return its Dockerfile and an empty folder beside it."""
    files = {"Dockerfile": "FROM ubuntu:24.04\nCOPY . .\n", place: configuration}
    for path, text in {**files, **ignores}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    (root.parent / "dockerfile").mkdir()
    return root / "Dockerfile", root.parent / "dockerfile"


@pytest.mark.parametrize("configuration", [HEADER, ADDRESS, CLEAN + HEADER.replace("extraheader", "extraHeader")])
@pytest.mark.parametrize("place", [".git/config", ".git/modules/lib/config", "sister/.git/config"])
def test_the_build_does_not_see_a_credential(tmp_path: Path, configuration: str, place: str) -> None:
    dockerfile, folder = repository(tmp_path / "r", configuration, place, **{".dockerignore": "data\n!.git\n"})
    copy = checkout.shielded(dockerfile, tmp_path / "r", folder)
    assert copy == folder / "Dockerfile"
    assert copy.read_text() == dockerfile.read_text()
    assert (folder / "Dockerfile.dockerignore").read_text() == "data\n!.git\n**/.git\n"


def test_the_dockerfiles_own_ignore_file_comes_before_the_contexts(tmp_path: Path) -> None:
    ignores = {"Dockerfile.dockerignore": "mine\n", ".dockerignore": ".git\n"}
    dockerfile, folder = repository(tmp_path / "r", HEADER, **ignores)
    assert checkout.shielded(dockerfile, tmp_path / "r", folder)
    assert (folder / "Dockerfile.dockerignore").read_text() == "mine\n**/.git\n"


@pytest.mark.parametrize(("configuration", "ignored"), [(CLEAN, ""), (HEADER, ".git\n"), (ADDRESS, "**/.git\n")])
def test_without_one_the_dockerfile_is_built_where_it_stands(tmp_path: Path, configuration: str, ignored: str) -> None:
    dockerfile, folder = repository(tmp_path / "r", configuration, **{".dockerignore": ignored})
    assert checkout.shielded(dockerfile, tmp_path / "r", folder) is None
    assert not list(folder.iterdir())


def test_a_link_is_not_followed(tmp_path: Path) -> None:
    dockerfile, folder = repository(tmp_path / "r", CLEAN)
    (tmp_path / "outside").write_text(HEADER)
    (tmp_path / "r/.git/config.worktree").symlink_to(tmp_path / "outside")
    assert checkout.shielded(dockerfile, tmp_path / "r", folder) is None


@pytest.mark.parametrize("target", ["../outside", "/proc/1/mem", ".dockerignore"])
def test_an_ignore_file_out_of_the_tree_ignores_nothing(tmp_path: Path, target: str) -> None:
    """docker does not read it either: what it names would be in the build."""
    dockerfile, folder = repository(tmp_path / "r", HEADER)
    (tmp_path / "outside").write_text(".git\n")
    (tmp_path / "r/.dockerignore").symlink_to(target)
    assert checkout.shielded(dockerfile, tmp_path / "r", folder)
    assert (folder / "Dockerfile.dockerignore").read_text() == "**/.git\n"


def test_an_ignore_file_that_is_a_link_within_the_tree_is_read(tmp_path: Path) -> None:
    dockerfile, folder = repository(tmp_path / "r", HEADER, **{"docker/ignored": ".git\n"})
    (tmp_path / "r/.dockerignore").symlink_to("docker/ignored")
    assert checkout.shielded(dockerfile, tmp_path / "r", folder) is None
