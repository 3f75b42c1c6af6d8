"""A lock at the root says which release is meant of what the manifests leave free."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = """[project]
name = "demo"
version = "1"
requires-python = ">=3.10,<3.11"
dependencies = ["trimesh", "viser>=1", "scipy==1.10.0", "plan @ git+https://example.org/lab/plan"]
[build-system]
requires = ["hatchling"]
build-backend = "hatchling.build"
"""


def uv(
    name: str, version: str, *, wheel: str = "py3-none-any", more: str = "", index: str = "https://index.example"
) -> str:
    file = f"{index}/{name}-{version}-{wheel}.whl"
    return (
        f'[[package]]\nname = "{name}"\nversion = "{version}"\nsource = {{ registry = "{index}" }}\n'
        f'{more}wheels = [\n    {{ url = "{file}", hash = "sha256:00" }},\n]\n\n'
    )


def poetry(name: str, version: str, wheel: str) -> str:
    return (
        f'[[package]]\nname = "{name}"\nversion = "{version}"\npython-versions = ">=3.8"\n'
        f'files = [\n    {{file = "{name}-{version}-{wheel}.whl", hash = "sha256:00"}},\n]\n\n'
    )


def limits(decision: Decision) -> set[str]:
    return {each.written for each in decision.python.bounds}


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        ("uv.lock", uv("trimesh", "4.1.0") + uv("viser", "1.2.0"), {"trimesh==4.1.0", "viser==1.2.0"}),
        ("uv.lock", uv("viser", "0.9.0"), set()),
        ("uv.lock", uv("scipy", "1.11.0") + uv("plan", "1.0") + uv("absent", "2.0"), set()),
        ("uv.lock", uv("trimesh", "4.1.0", wheel="cp312-cp312-manylinux2014_x86_64"), set()),
        ("uv.lock", uv("trimesh", "4.1.0", wheel="cp310-cp310-manylinux2014_x86_64"), {"trimesh==4.1.0"}),
        ("uv.lock", uv("trimesh", "4.1.0", wheel="cp39-abi3-manylinux2014_x86_64"), {"trimesh==4.1.0"}),
        (
            "uv.lock",
            uv("trimesh", "4.1.0", more="resolution-markers = [\"python_full_version < '3.11'\"]\n")
            + uv("trimesh", "4.5.0", more="resolution-markers = [\"python_full_version >= '3.11'\"]\n"),
            {"trimesh==4.1.0"},
        ),
        ("uv.lock", uv("trimesh", "4.1.0") + uv("trimesh", "4.5.0"), set()),
        (
            "uv.lock",
            '[[package]]\nname = "trimesh"\nversion = "4"\nsource = { git = "https://example.org/t" }\n',
            set(),
        ),
        ("uv.lock", "[[package]\n", set()),
        ("poetry.lock", poetry("trimesh", "4.1.0", "py3-none-any"), {"trimesh==4.1.0"}),
        ("pdm.lock", poetry("viser", "1.2.0", "cp310-cp310-manylinux2014_x86_64"), {"viser==1.2.0"}),
    ],
)
def test_what_a_manifest_leaves_free(tree: Tree, file: str, text: str, found: set[str]) -> None:
    assert limits(tree({"pyproject.toml": PROJECT, "demo.py": "import trimesh\n", file: text})) == found


def test_what_needs_a_release_that_the_image_cannot_have_is_left_free_too(tree: Tree) -> None:
    lock = uv("scipy", "1.9.0") + uv("viser", "1.2.0") + uv("mesh", "1.0", more='dependencies = [{ name = "scipy" }]\n')
    lock += uv("trimesh", "4.1.0", more='dependencies = [{ name = "mesh" }]\n')
    assert limits(tree({"pyproject.toml": PROJECT, "demo.py": "import trimesh\n", "uv.lock": lock})) == {"viser==1.2.0"}


def test_a_lock_of_what_is_not_installed_tells_nothing(tree: Tree) -> None:
    files = {"requirements.txt": "trimesh\n", "demo.py": "import trimesh\n", "uv.lock": uv("trimesh", "4.1.0")}
    assert limits(tree(files)) == set()


def test_a_torch_that_is_locked_has_its_own_cuda(tree: Tree) -> None:
    free = PROJECT.replace('"trimesh"', '"torch", "torchvision"')
    lock = uv("torch", "2.5.1+cu124", wheel="cp310-cp310-linux_x86_64") + uv("torchvision", "0.20.1+cu124")
    found = tree({"pyproject.toml": free, "demo.py": "import torch\n", "uv.lock": lock})
    assert found.cuda == "12.4"
    assert limits(found) == {"torch==2.5.1+cu124", "torchvision==0.20.1+cu124"}
    assert "--extra-index-url https://download.pytorch.org/whl/cu124" in found.python.options


def test_what_is_built_for_a_locked_torch_is_the_locks_too(tree: Tree) -> None:
    on_torch = 'dependencies = [{ name = "torch" }]\n'
    lock = uv("torch", "2.5.1", wheel="cp310-cp310-manylinux1_x86_64")
    lock += uv("tensordict", "0.6.2", more=on_torch) + uv("torchrl", "0.6.0", more=on_torch)
    files = {"demo.py": "import torch\nimport torchrl\n", "uv.lock": lock}
    project = PROJECT.replace(
        '"trimesh", "viser>=1", "scipy==1.10.0", "plan @ git+https://example.org/lab/plan"', "FREE"
    )
    found = limits(tree(files | {"pyproject.toml": project.replace("FREE", '"torch", "tensordict>=0.6"')}))
    assert {"torch==2.5.1", "tensordict==0.6.2", "torchrl==0.6.0"} <= found
    older = limits(tree(files | {"pyproject.toml": project.replace("FREE", '"torch<2.5", "tensordict>=0.6"')}))
    assert not {"tensordict==0.6.2", "torchrl==0.6.0"} & older


def test_what_another_index_has_is_left_free(tree: Tree) -> None:
    lock = uv("trimesh", "4.1.0.dev3", index="https://nightly.example") + uv("viser", "1.2.0") + uv("mesh", "1.0")
    assert limits(tree({"pyproject.toml": PROJECT, "demo.py": "import trimesh\n", "uv.lock": lock})) == {"viser==1.2.0"}


def test_no_build_is_given_the_setuptools_of_a_lock(tree: Tree) -> None:
    free = PROJECT.replace('"trimesh"', '"setuptools"')
    lock = uv("setuptools", "80.1.0") + uv("viser", "1.2.0")
    assert limits(tree({"pyproject.toml": free, "demo.py": "import viser\n", "uv.lock": lock})) == {"viser==1.2.0"}


def test_what_a_list_takes_from_an_address_has_no_release_of_the_lock(tree: Tree) -> None:
    lock = uv("trimesh", "4.1.0", more='dependencies = [{ name = "shapely" }]\n') + uv("viser", "1.2.0")
    project = PROJECT.replace('"trimesh"', '"trimesh", "shapely"')
    files = {"pyproject.toml": project, "uv.lock": lock + uv("shapely", "2.0.6")}
    assert limits(tree(files)) == {"trimesh==4.1.0", "viser==1.2.0", "shapely==2.0.6"}
    files["requirements.txt"] = "git+https://example.org/mikedh/trimesh.git@refs/pull/4/head\n"
    assert limits(tree(files)) == {"viser==1.2.0"}


def test_what_the_declared_packages_need_and_what_is_imported_alone_have_the_releases_of_the_lock(tree: Tree) -> None:
    project = PROJECT.replace(
        '["trimesh", "viser>=1", "scipy==1.10.0", "plan @ git+https://example.org/lab/plan"]', "FREE"
    )
    typer = 'dependencies = [\n    { name = "click" },\n    { name = "rich", marker = "extra == \'all\'" },\n]\n'
    lock = uv("typer", "0.15.2", more=typer) + uv("click", "8.1.8") + uv("rich", "14.0.0") + uv("lonely", "1.0.0")
    lock += uv("pyyaml", "6.0.1")
    files = {"demo.py": "import click\nimport yaml\n", "uv.lock": lock}
    found = tree(files | {"pyproject.toml": project.replace("FREE", '["typer"]')})
    assert limits(found) == {"typer==0.15.2", "click==8.1.8", "rich==14.0.0", "pyyaml==6.0.1"}
    older = tree(files | {"pyproject.toml": project.replace("FREE", '["typer>=0.16"]')})
    assert limits(older) == {"pyyaml==6.0.1"}
    another = tree(files | {"pyproject.toml": project.replace("FREE", '["typer", "newcomer"]')})
    assert limits(another) == {"typer==0.15.2"}


def test_what_a_package_in_another_release_needs_is_left_free(tree: Tree) -> None:
    both = 'dependencies = [\n    { name = "click" },\n]\n'
    lock = uv("trimesh", "4.1.0", more=both) + uv("viser", "0.9.0", more=both) + uv("click", "8.1.8")
    project = PROJECT.replace(', "scipy==1.10.0", "plan @ git+https://example.org/lab/plan"', "")
    found = tree({"pyproject.toml": project, "demo.py": "import trimesh\n", "uv.lock": lock})
    assert limits(found) == {"trimesh==4.1.0"}


def test_no_page_puts_a_locked_torch_on_a_cuda_that_needs_a_newer_driver(tree: Tree) -> None:
    lock = uv("torch", "2.9.1", wheel="cp310-cp310-manylinux1_x86_64")
    project = PROJECT.replace(
        '"trimesh", "viser>=1", "scipy==1.10.0", "plan @ git+https://example.org/lab/plan"', "FREE"
    )
    project = project.replace("FREE", '"torch"')
    page = "```bash\n# nightly (CUDA 13.0 example)\npip install --pre torch --index-url URL/whl/nightly/cu130\n```\n"
    page = page.replace("URL", "https://download.pytorch.org")
    files = {"pyproject.toml": project, "demo.py": "import torch\n", "uv.lock": lock, "README.md": page}
    assert tree(files).cuda == "12.8"
    files["README.md"] = page.replace("--pre ", "").replace("nightly/", "")
    assert tree(files).cuda == "13.0"


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({}, {"trimesh==4.1.0"}),
        ({"tool/setup.py": "from setuptools import setup\nsetup(name='tool')\n"}, set()),  # another project
        ({"other/uv.lock": uv("trimesh", "3.0.0")}, set()),
        ({"uv.lock": uv("trimesh", "3.0.0")}, set()),  # of the root, where nothing is
    ],
)
def test_the_lock_of_the_one_project_of_a_tree(tree: Tree, files: dict[str, str], found: set[str]) -> None:
    page = "```\ncd code\npip install -e .\npython -m demo\n```\n"
    own = {"code/pyproject.toml": PROJECT, "code/uv.lock": uv("trimesh", "4.1.0"), "code/demo/__init__.py": ""}
    own |= {"code/demo/__main__.py": "import trimesh\n", "README.md": page}
    decision = tree(own | files)
    assert "code" in decision.python.projects
    assert limits(decision) == found


@pytest.mark.parametrize(
    ("listed", "found"),
    [
        ("trimesh<4", {"viser==1.2.0"}),
        ("trimesh==3.9.0", {"viser==1.2.0"}),
        ("trimesh>=3", {"trimesh==4.1.0", "viser==1.2.0"}),
        ("trimesh<4; python_version < '3.8'", {"trimesh==4.1.0", "viser==1.2.0"}),
    ],
)
@pytest.mark.parametrize("folder", ["", "code/"])
def test_a_list_beside_the_project_limits_what_the_lock_has(
    tree: Tree, folder: str, listed: str, found: set[str]
) -> None:
    page = f"```\npip install -r requirements.txt\npip install -e ./{folder}\npython main.py\n```\n"
    files = {"README.md": page, "requirements.txt": f"{listed}\n", "main.py": "import demo\n"}
    files |= {f"{folder}pyproject.toml": PROJECT, f"{folder}demo/__init__.py": "import trimesh\n"}
    files[f"{folder}uv.lock"] = uv("trimesh", "4.1.0") + uv("viser", "1.2.0")
    assert {each for each in limits(tree(files)) if each.startswith(("trimesh", "viser"))} == found


@pytest.mark.parametrize(("locked", "found"), [("2.1.0", {"pandas==2.1.0"}), ("1.5.0", set())])
def test_what_an_extra_limits_to_what_the_lock_has(tree: Tree, locked: str, found: set[str]) -> None:
    own = PROJECT.replace("[build-system]", "[project.optional-dependencies]\nplay = ['pandas>=2,<3']\n[build-system]")
    own = own.replace('"trimesh", ', "").replace(', "plan @ git+https://example.org/lab/plan"', "")
    files = {"pyproject.toml": own, "uv.lock": uv("viser", "1.2.0") + uv("scipy", "1.10.0") + uv("pandas", locked)}
    decision = tree(files | {"demo/__init__.py": "import pandas\n", "README.md": "```\npip install -e .\n```\n"})
    assert "pandas>=2,<3" in {each.written for each in decision.python.pip_guessed}
    assert {each for each in limits(decision) if each.startswith("pandas")} == found
