"""Whether a text may hold a command that tells what to install or to run."""

from __future__ import annotations

from roslab.values.pattern import pattern

_TELLING = tuple(
    (word, pattern(telling))
    for word, telling in (
        ("install", r"\binstall\b"),
        ("clone", r"\bclone\b"),
        ("checkout", r"\bcheckout\b"),
        ("switch", r"\bgit\s+switch\s"),
        ("roslaunch", r"\broslaunch\b"),
        ("rosrun", r"\brosrun\b"),
        ("ros2", r"\bros2\s+(?:launch|run)\b"),
        ("catkin", r"\bcatkin(?:_make|\s+build|\s+init)"),
        ("run", r"\b(?:uv|poetry|pipenv|pdm|pixi|rye)\s+run\s"),
        ("pixi", r"\bpixi\s+shell\b"),
        ("torchrun", r"\btorchrun\s"),
        ("accelerate", r"\baccelerate\s+launch\s"),
        (".sh", r"\b(?:ba)?sh\s+\S+\.sh\b"),
        ("colcon", r"\bcolcon\b"),
        ("jupyter", r"\bjupyter[ -](?:notebook|lab)\s"),
        ("cd", r"\b(?:ros)?cd\s"),
        ("conda", r"\bconda\b"),
        ("mamba", r"\b(?:micro)?mamba\b"),
        ("python", r"\bpython[\d.]*\s+\S"),
        ("cmake", r"\bcmake\b"),
        ("/archive/", "/archive/"),
        ("/releases/", r"/releases/download/[^/\s]+/\S+\.zip\b"),
        ("ppa:", r"\bppa:"),
        ("dpkg", r"\bdpkg\s"),
        (".deb", r"\.deb\b"),
        (".t", r"\.t(?:ar|gz)\b"),
        ("wget", r"\bwget\s"),
        ("curl", r"\bcurl\s[^|\n]*?\s?(?:-\w*[oO]|--output|--remote-name)\b"),
        ("unzip", r"\bunzip\s"),
        ("docker", r"\bdocker\s"),
        ("./", r"(?:^|[\s`$])\.{1,2}/\w"),
        ("build/", r"(?:^|[\s`$])build/\w"),
        ("bin/", r"(?:^|[\s`$])bin/\w"),
    )
)
"""Signs of a command, each after a word without which it need not be looked for, which takes much less time."""


def telling(text: str) -> bool:
    """Tell whether a text may hold a command that tells what to install or to run: nothing else is read."""
    for word, sign in _TELLING:  # noqa: SIM110 - of each line of each page: `any` takes longer
        if word in text and sign.search(text):
            return True
    return False
