"""The transports of images that launch files and parameters name."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.ros import image_transports
from roslab.repository.checkout import Repository


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        ("a.launch.py", "remappings=[('~/image/ffmpeg', '/cam/image_raw/ffmpeg')]\n", ["ffmpeg_image_transport"]),
        ("a.launch.py", "{'cam.image.theora.quality': 3}\n", ["theora_image_transport"]),
        ("a.launch", '<remap from="x" to="/image_raw/compressed"/>\n', ["compressed_image_transport"]),
        ("a.launch.xml", '<remap from="x" to="/image_raw/compressed"/>\n', ["compressed_image_transport"]),
        ("a.launch", '<param name="image_transport" value="theora"/>\n', ["theora_image_transport"]),
        ("a.launch", '<arg name="image_transport" default="raw"/>\n', []),
        ("a.launch", '<!-- <remap to="/image_raw/compressed"/> -->\n', []),
        ("p.yaml", "image_transport: compressedDepth\n", ["compressed_depth_image_transport"]),
        ("p.yaml", "# topic: '/image_raw/compressed'\n", []),
        ("p.yaml", "image: '/data/zstd-1.5/compressed.bin'\n", []),
        ("talk.py", "topic = '/image_raw/compressed'\n", []),  # a node may read the message by itself
        ("test/a.launch", '<remap from="x" to="/image_raw/compressed"/>\n', []),
    ],
)
def test_transports(tmp_path: Path, file: str, text: str, found: list[str]) -> None:
    (tmp_path / file).parent.mkdir(exist_ok=True)
    (tmp_path / file).write_text(text)
    assert [each.name for each in image_transports.read(Repository.open(tmp_path))] == found
