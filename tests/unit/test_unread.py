"""What of a tree was not read is told wherever its author looks: in inspect, in the plan, in the summary."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from roslab.errors import ConfigurationError, NothingToBuildError
from roslab.pipeline import plan_repository
from roslab.plan.plan import to_json
from roslab.render.outcome import Report
from roslab.render.report import inspection_json, inspection_text
from roslab.render.summary import summary
from roslab.repository import listing
from roslab.repository.checkout import Repository

TOO_MANY = "the tree holds more than 3 files: the rest was not read"


@pytest.fixture(autouse=True)
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a tree of four files be too large: half a million take a minute to make."""
    monkeypatch.setattr(listing, "MAX_FILES", 3)


def tree(root: Path, *, files: int, folder: str = "data") -> Path:
    (root / folder).mkdir(parents=True)
    (root / "main.py").write_text("if __name__ == '__main__':\n    print(1)\n")
    for number in range(files - 1):
        (root / folder / f"{number}.txt").touch()
    return root


@pytest.mark.parametrize("folder", ["data", "a/b"])
def test_a_tree_of_too_many_files(tmp_path: Path, folder: str) -> None:
    found = plan_repository(tree(tmp_path, files=5, folder=folder), folder_name="robot")
    assert len(found.repository.files) == 3
    inspected = json.loads(inspection_json(found.decision, found.plan))
    assert inspected["warnings"] == [{"message": TOO_MANY, "file": None, "line": None}]
    assert TOO_MANY in inspection_text(found.decision, found.plan)
    assert json.loads(to_json(found.plan))["warnings"][0]["message"] == TOO_MANY
    report = Report(plan=found.plan, image="ghcr.io/lab/robot", published=False, reason="")
    assert f"- {TOO_MANY}" in summary(report)


def test_a_tree_of_just_as_many(tmp_path: Path) -> None:
    repository = Repository.open(tree(tmp_path, files=3))
    assert not repository.listing.truncated
    assert repository.problems == ()


@pytest.fixture
def nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let even root have no right to what is closed."""
    monkeypatch.setattr(os, "access", lambda path, _: bool(Path(path).stat().st_mode & 0o400))


@pytest.mark.usefixtures("nobody")
def test_a_file_that_may_not_be_read_is_told(tmp_path: Path) -> None:
    root = tree(tmp_path, files=3)
    (root / "data" / "0.txt").chmod(0)
    (root / "data" / "1.txt").chmod(0o600)
    told = "a file could not be read for want of permission: data/0.txt"
    assert Repository.open(root).problems == ((told, None, None),)
    (root / "main.py").unlink()
    with pytest.raises(NothingToBuildError) as error:
        plan_repository(root)
    assert told in error.value.problems[0].message


@pytest.mark.usefixtures("nobody")
def test_a_configuration_that_may_not_be_read_is_not_empty(tmp_path: Path) -> None:
    root = tree(tmp_path, files=1)
    (root / "roslab.yaml").write_text("format: 3\n")
    (root / "roslab.yaml").chmod(0)
    with pytest.raises(ConfigurationError) as error:
        plan_repository(root)
    assert str(error.value) == (
        "roslab.yaml: it cannot be read for want of permission (`chmod u+r roslab.yaml` gives its owner the right)"
    )


def test_nothing_found_in_what_was_read(tmp_path: Path) -> None:
    """The answer may lie in what nobody read: whoever is told that there is nothing is told that too."""
    (tmp_path / "data").mkdir()
    for number in range(5):
        (tmp_path / "data" / f"{number}.txt").touch()
    with pytest.raises(NothingToBuildError) as error:
        plan_repository(tmp_path)
    assert TOO_MANY in error.value.problems[0].message


def test_a_page_that_has_its_own_repository_cloned_is_nothing_to_build(tmp_path: Path) -> None:
    (tmp_path / "main.m").write_text("plot(1)\n", encoding="utf-8")
    page = "```\ngit clone https://github.com/lab/stereo.git\n```\nSee https://github.com/lab/other.\n"
    (tmp_path / "README.md").write_text(page, encoding="utf-8")
    with pytest.raises(NothingToBuildError, match=r"there is only 1 \.md, 1 \.m"):
        plan_repository(tmp_path, folder_name="stereo")
    assert plan_repository(tmp_path, folder_name="another").decision.kind == "python"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("% Plots.\nplot(1)\n", "MATLAB code: 1 .m file; .*there is only 1 .m"),
        ("#import <Foundation/Foundation.h>\n@implementation A\n@end\n", "no package.xml"),
    ],
)
def test_a_tree_of_matlab_is_refused_by_that_name(tmp_path: Path, text: str, told: str) -> None:
    (tmp_path / "main.m").write_text(text, encoding="utf-8")
    with pytest.raises(NothingToBuildError, match=told) as error:
        plan_repository(tmp_path)
    assert ("host_path" in (error.value.problems[0].hint or "")) == ("MATLAB" in told)


@pytest.mark.parametrize(("beside", "hinted"), [("data.mat", True), ("model.slx", False), ("plant/model.mdl", False)])
def test_octave_is_no_hint_for_models_of_simulink(tmp_path: Path, beside: str, *, hinted: bool) -> None:
    (tmp_path / "main.m").write_text("plot(1)\n", encoding="utf-8")
    (tmp_path / beside).parent.mkdir(exist_ok=True)
    (tmp_path / beside).touch()
    with pytest.raises(NothingToBuildError, match="MATLAB code") as error:
        plan_repository(tmp_path)
    hint = error.value.problems[0].hint or ""
    assert "host_path: /usr/local/MATLAB/R2020b}`" in hint
    assert ("octave" in hint) == hinted


@pytest.mark.parametrize(
    ("files", "hinted"),
    [
        ({"main.m": "camera = webcam(1);\n"}, False),
        ({"main.m": "rosinit;\n"}, False),
        ({"main.m": "% as of webcam(1)\nplot(1)\n"}, True),
        ({"main.m": "camera = webcam(1);\n", "webcam.m": "function c = webcam(n)\nc = n;\n"}, True),
        ({"main.m": "a = imwarp(b, c, OutputView=imref2d([1 2]));\n"}, False),
        ({"main.m": "if f(b, C == 1), A = 2; end % f(x, Name=value)\ng(x, 'Name', 1); D = 3;\n"}, True),
    ],
)
def test_octave_is_no_hint_for_what_only_matlab_runs(tmp_path: Path, files: dict[str, str], *, hinted: bool) -> None:
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(NothingToBuildError, match="MATLAB code") as error:
        plan_repository(tmp_path)
    assert ("octave" in (error.value.problems[0].hint or "")) == hinted


@pytest.mark.parametrize(
    "config", ["matlab: {host_path: /usr/local/MATLAB/R2020b}\n", "apt: [octave]\ncommand: octave\n"]
)
def test_what_the_refusal_of_matlab_names_is_planned(tmp_path: Path, config: str) -> None:
    (tmp_path / "main.m").write_text("plot(1)\n", encoding="utf-8")
    (tmp_path / "roslab.yaml").write_text(config, encoding="utf-8")
    assert plan_repository(tmp_path).plan.run.command


@pytest.mark.parametrize("beside", ["main.m", "notes.md"])
def test_what_is_there_for_packages_of_others_is_named(tmp_path: Path, beside: str) -> None:
    (tmp_path / beside).write_text("% plot(1)\nplot(1)\n", encoding="utf-8")
    (tmp_path / "robot.launch").write_text('<launch><node pkg="amcl" type="amcl" name="a"/></launch>', encoding="utf-8")
    (tmp_path / "robot.rosinstall").write_text("[]\n", encoding="utf-8")
    with pytest.raises(NothingToBuildError, match=r"of ROS \(robot\.launch, robot\.rosinstall\) names packages"):
        plan_repository(tmp_path)
