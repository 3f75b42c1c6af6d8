"""roslab.yaml's schema names the distributions of the table. ``REPRO_REFRESH=1 pytest tests/golden`` writes them."""

from __future__ import annotations

import json
import os
import re
import textwrap
from pathlib import Path

from roslab.config.vocabulary import SCHEMA
from roslab.knowledge.distros import releases_of


def test_the_schema_names_the_distributions_of_the_table() -> None:
    names = list(releases_of())
    if os.environ.get("REPRO_REFRESH") == "1":
        listed = textwrap.fill(json.dumps(names)[1:-1], 118, initial_indent=" " * 8, subsequent_indent=" " * 8)
        text = Path(SCHEMA).read_text(encoding="utf-8")
        text = re.sub(r'("ros_distro": \{[^}]*?"enum": \[\n)[^]]*(\n      \])', rf"\g<1>{listed}\g<2>", text)
        text = re.sub(r'("pattern": "\^\(\?:)indigo[a-z|]*', rf"\g<1>{'|'.join(names)}", text)
        Path(SCHEMA).write_text(text, encoding="utf-8")
    definitions = json.loads(Path(SCHEMA).read_text(encoding="utf-8"))["$defs"]
    assert definitions["ros_distro"]["enum"] == names
    assert definitions["ros"]["pattern"].startswith(f"^(?:{'|'.join(names)})(?:-")
