"""What a plan tells holds no login, password or token of its author."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.values.redacted import redacted
from trees import tree_of

TOKEN = "ghp_" + "a1B2" * 9


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("wget https://me:abc@host.test/a.zip is left out", "wget https://***@host.test/a.zip is left out"),
        (f"git+https://{TOKEN}@github.com/lab/a.git", "git+https://***@github.com/lab/a.git"),
        ("ssh://git@host.test/a and git@host.test:a/b", "ssh://git@host.test/a and git@host.test:a/b"),
        ("ssh://git:abc@host.test/a", "ssh://***@host.test/a"),
        ("--index-url=https://me:a@b.test/simple", "--index-url=https://***@b.test/simple"),
        ("https://host.test/a?x=1&access_token=abc&y=2", "https://host.test/a?x=1&access_token=***&y=2"),
        ("https://host.test/a?X-Amz-Signature=abc", "https://host.test/a?X-Amz-Signature=***"),
        ("curl -u me:abc https://host.test/a", "curl -u *** https://host.test/a"),
        ("curl -ume:abc -o x https://host.test/a", "curl -u*** -o x https://host.test/a"),
        ("curl -L --user 'me:my own' x", "curl -L --user *** x"),
        ("curl --header 'PRIVATE-TOKEN: abcd' x", "curl --header 'PRIVATE-TOKEN: ***' x"),
        ("sshpass -p abc ssh a; docker login -u me -p abc", "sshpass -p *** ssh a; docker login -u me -p ***"),
        ("wandb login --relogin 0123456789", "wandb login --relogin ***"),
        ("WANDB_API_KEY=abc HF_TOKEN=short ./run", "WANDB_API_KEY=*** HF_TOKEN=*** ./run"),
        ("HF_TOKEN=$TOKEN HF_TOKEN=<yours> ./run", "HF_TOKEN=$TOKEN HF_TOKEN=<yours> ./run"),
        ("python -u train:main and docker run -u root:root a", "python -u train:main and docker run -u root:root a"),
        ("curl -H 'Authorization: token abcdefgh' x", "curl -H 'Authorization: token ***' x"),
        ("wget --user=me --http-password=abc x", "wget --user=me --http-password=*** x"),
        ("docker run --user 1000:1000 a", "docker run --user 1000:1000 a"),
        ("docker run -u $(id -u):$(id -g) a", "docker run -u $(id -u):$(id -g) a"),
        ("pip install --user git+https://host.test/a", "pip install --user git+https://host.test/a"),
        ("https://host.test/a@v1 and me@host.test", "https://host.test/a@v1 and me@host.test"),
        (f"export TOKEN={TOKEN}", "export TOKEN=***"),
        ("the password of roslab.yaml: see user:group", "the password of roslab.yaml: see user:group"),
    ],
)
def test_a_text_is_shown_without_secrets(text: str, shown: str) -> None:
    assert redacted(text) == shown


def test_a_plan_quotes_none(tmp_path: Path) -> None:
    page = "# Installation\n```\nwget https://me:s3cr3t@host.test/tool.deb\nsudo dpkg -i tool.deb\n```\n"
    files = {"README.md": page, "run.py": "import json\n", "requirements.txt": "numpy\n"}
    tree_of(tmp_path, files)
    planned = plan_repository(tmp_path)
    told = [each.message for each in (*planned.plan.warnings, *planned.decision.warnings)]
    told += [f"{each.answer} {each.reason}" for each in planned.plan.reasons]
    assert any("https://***@host.test/tool.deb" in message for message in told)
    assert not any("s3cr3t" in message for message in told)
