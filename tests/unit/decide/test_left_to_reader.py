"""What a page leaves to the reader of the command is told, and a command that cannot start without it comes later."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TWO = "import argparse\np = argparse.ArgumentParser()\np.add_argument('config')\np.add_argument('checkpoint')\n"
MAYBE = "import argparse\np = argparse.ArgumentParser()\np.add_argument('config', nargs='?')\n"
OTHER = "import numpy\nprint(1)\n"
HYDRA = "import hydra\n@hydra.main(config_name='a')\ndef main(config):\n    pass\nmain()\n"


def told(decision: Decision) -> list[str]:
    return [each.message for each in decision.warnings if "default command" in each.message]


@pytest.mark.parametrize(
    ("code", "page", "first", "said"),
    [
        (TWO, "python run.py $config $checkpoint --show\npython other.py", "other.py", ""),
        (TWO, "python run.py $config $checkpoint --show", "run.py", "config, checkpoint"),
        (TWO, "python run.py a.py $checkpoint --show", "run.py", "checkpoint"),
        (TWO, "python run.py a.py b.py", "run.py", ""),
        (MAYBE, "python run.py $config --show", "run.py", ""),
    ],
)
def test_arguments_without_a_dash(tree: Tree, code: str, page: str, first: str, said: str) -> None:
    files = {"run.py": code, "other.py": OTHER, "a.py": "", "b.py": "", "requirements.txt": "numpy\n"}
    found = tree({**files, "README.md": f"# Usage\n```\n{page}\n```\n"})
    assert found.command[1] == first
    assert any(f"stops without {said}, which" in each for each in told(found)) is bool(said)


@pytest.mark.parametrize(
    ("given", "kept"),
    [
        ("--name PRIOR_NAME", True),
        ("--exp_name=EXP_NAME", True),
        ("--run-name RUN_NAME", True),
        ("--experiment EXPERIMENT_NAME", True),
        ("--tag TAG_NAME", True),
        ("--name DATASET_NAME", False),
        ("--robot_name ROBOT_NAME", False),
        ("--exp_name <name>", False),
        ("--exp_name path/to/EXP_NAME", False),
        ("--load_run RUN_NAME", False),
    ],
)
def test_a_name_for_what_the_program_writes_needs_nothing_of_the_reader(tree: Tree, given: str, *, kept: bool) -> None:
    page = f"# Usage\n```\npython run.py --seed 1 {given} --log\n```\n"
    found = tree({"run.py": OTHER, "requirements.txt": "numpy\n", "README.md": page})
    words = given.split() if kept else []
    assert found.command == ("python", "run.py", "--seed", "1", *words, "--log")
    assert (told(found) == []) is kept


def test_arguments_that_a_program_splits_itself(tree: Tree) -> None:
    page = "# Usage\n```\npython run.py mode:live file_path:/path_to_file/a.yaml speed:fast\n```\n"
    found = tree({"run.py": OTHER, "requirements.txt": "numpy\n", "README.md": page})
    assert found.command == ("python", "run.py", "mode:live", "speed:fast")
    assert ["leaves to the reader (file_path)" in each for each in told(found)] == [True]
    found = tree({"README.md": page.replace("file_path:/path_to_file/a.yaml speed:fast", "http://your-host/a")})
    assert told(found) == []


@pytest.mark.parametrize(
    ("given", "kept"),
    [
        ("planning_method hybrid environment_path rooms start_id 0", 6),
        ("environment_path rooms surface_source load_from_data end_id 0", 6),
        ("planning_method hybrid environment_path", 2),  # it has no value
        ("planning_method hybrid environment_path path/to/rooms", 2),
        ("planning_method hybrid environment_path data_path", 2),
        ("environment_path rooms", 0),  # alone it may as well be a blank
        ("model_path out.png", 0),
    ],
)
def test_arguments_that_a_program_takes_by_twos(tree: Tree, given: str, kept: int) -> None:
    page = f"# Usage\n```\npython run.py {given}\n```\n"
    found = tree({"run.py": OTHER, "requirements.txt": "numpy\n", "README.md": page})
    assert found.command == ("python", "run.py", *given.split()[:kept])


@pytest.mark.parametrize(
    ("default", "whole"),
    [("confs/a.conf", False), ("./confs/missing.conf", True), ("missing.yaml", True), ("out/missing.txt", False)],
)
def test_a_default_that_is_no_file_of_the_tree(tree: Tree, default: str, *, whole: bool) -> None:
    code = f"import argparse\np = argparse.ArgumentParser()\np.add_argument('--conf', type=str, default='{default}')\n"
    blank, whole_one = (f"``` python run.py --conf confs/{name}.conf ```\n" for name in ("<name>", "a"))
    page = f"# Usage\n{blank}\nExample:\n{whole_one}"
    files = {"run.py": code, "confs/a.conf": "", "requirements.txt": "numpy\n"}
    given = ("--conf", "confs/a.conf") if whole else ()
    assert tree({**files, "README.md": page}).command == ("python", "run.py", *given)
    page = page.partition("Example")[0]
    assert bool(told(tree({**files, "README.md": page}))) is whole


def test_what_hydra_takes_and_refuses(tree: Tree) -> None:
    page = "# Usage\n```\npython train.py trainer.devices-1 data.root=path/to/data model=small\n```\n"
    found = tree({"train.py": HYDRA, "requirements.txt": "hydra-core\n", "README.md": page})
    assert found.command == ("python", "train.py", "trainer.devices-1", "model=small")
    assert ["refuses the argument trainer.devices-1" in each for each in told(found)] == [False, True]
    assert "leaves to the reader (data.root)" in told(found)[0]


@pytest.mark.parametrize(("code", "said"), [(TWO, "config, checkpoint"), (MAYBE, ""), ("print(1)\n", "")])
def test_arguments_of_a_program_that_no_page_starts(tree: Tree, code: str, said: str) -> None:
    guarded = f"import numpy\n{code}if __name__ == '__main__':\n    print(1)\n"
    found = tree({"tools/show.py": guarded, "requirements.txt": "numpy\n", "README.md": "# A viewer\n"})
    assert found.command[1:] == ("tools/show.py",)
    assert [each.partition("without ")[2].partition(", which")[0] for each in told(found)] == ([said] if said else [])


@pytest.mark.parametrize(
    ("script", "page", "said"),
    [
        ("gpu=$1\nseed=$2\npython main.py --gpu $gpu --seed=$seed\n", "sh ./train.sh  # baseline", "$1 and $2"),
        ("gpu=$1\nseed=$2\npython main.py --gpu $gpu --seed=$seed\n", "sh train.sh 0", "$2"),
        ("python main.py \\\n  --gpu ${1} \\\n", "bash train.sh", "$1"),
        ("python main.py --gpu $1\n", "bash train.sh 0", ""),
        ("gpu=${1:-0}\npython main.py --gpu $gpu\n", "sh train.sh", ""),
        ("gpu=$1\nif [ -z $gpu ]; then gpu=0; fi\npython main.py --gpu $gpu\n", "sh train.sh", ""),
        ("run() { python main.py --gpu $1; }\nrun 0\n", "sh train.sh", ""),
        ("gpu=$1\n# python main.py --gpu $gpu\npython main.py $gpu\n", "sh train.sh", ""),
        ("gpu=0\npython main.py --gpu $gpu\n", "sh train.sh", ""),
    ],
)
def test_parameters_of_a_script_that_options_need(tree: Tree, script: str, page: str, said: str) -> None:
    files = {"train.sh": script, "main.py": "import numpy\n", "requirements.txt": "numpy\n"}
    found = tree({**files, "README.md": f"# Usage\n```\n{page}\n```\n"})
    assert found.command[:2] == ("bash", "train.sh")
    about = [each for each in told(found) if "gives options the values" in each]
    assert [f"values {said}, which" in each for each in about] == [True] * bool(said)


OWN_IMAGE = 'FROM python:3.10\nRUN pip install numpy\nCOPY . /app\nWORKDIR /app\nCMD ["bash"]\n'


@pytest.mark.parametrize(
    ("given", "files", "folder"),
    [
        ("/datasets/a.bag", {}, "/datasets"),
        ("--bag=/datasets/day/a.bag", {}, "/datasets/day"),
        ("--bag /datasets/day/a.bag", {}, "/datasets/day"),
        ("--bag /datasets/day/a.bag", {"Dockerfile": OWN_IMAGE}, ""),
        ("/app/data/a.bag", {"Dockerfile": OWN_IMAGE}, ""),
        ("/run_data/b/a.bag", {}, "/run_data/b"),
        ("/libs/a.bag", {}, "/libs"),
        ("/development/a.bag", {}, "/development"),
        ("/home/me/a.bag", {}, ""),
        ("/lib64/a.bag", {}, ""),
        ("/your_data/a.bag", {}, ""),
        ("/tmp/a.bag", {}, ""),
        ("/a.bag", {}, ""),
        ("/camera/image_raw", {}, ""),
        ("data/a.bag", {}, ""),
        ("--output /datasets/a.bag", {}, ""),
    ],
)
def test_the_folder_of_a_file_that_no_image_has(tree: Tree, given: str, files: dict[str, str], folder: str) -> None:
    page = f"# Usage\n```\npython other.py {given}\n```\n"
    found = tree({"other.py": OTHER, "requirements.txt": "numpy\n", "README.md": page, **files})
    named = [each for each in told(found) if "--volume FOLDER" in each]
    assert [f"--volume FOLDER:{folder}," in each for each in named] == ([True] if folder else [])
