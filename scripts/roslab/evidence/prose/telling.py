"""Whether a text may hold a command that tells what to install or to run."""

from __future__ import annotations

import re

from roslab.evidence.lex import lines
from roslab.values.pattern import pattern

Signs = tuple[tuple[str, re.Pattern[str]], ...]
"""Signs of a command, each after a word without which it need not be looked for, which takes much less time."""
SIGNS: Signs = tuple(
    (word, pattern(telling))
    for word, telling in (
        ("install", r"\binstall\b"),
        ("clone", r"\bclone\b"),
        ("checkout", r"\bcheckout\b"),
        ("switch", r"\bgit\s+switch\s"),
        ("reset", r"\bgit\s[^\n]{0,300}\breset\s"),
        ("roslaunch", r"\broslaunch\b"),
        ("rosrun", r"\brosrun\b"),
        ("ros2", r"\bros2\s+(?:launch|run|component\s+standalone)\b"),
        ("gz ", r"\bgz\s+(?:sim|launch)\s"),
        ("ign ", r"\bign\s+(?:gazebo|launch)\s"),
        ("gazebo ", r"\bgazebo\s[^\n]{0,300}\.(?:world|sdf)\b"),
        (".wbt", r"\bwebots\s[^\n]{0,300}\.wbt\b"),
        ("catkin", r"\bcatkin(?:_make|\s+build|\s+init)"),
        ("run", r"\b(?:uv|poetry|pipenv|pdm|pixi|rye)\s+run\s"),
        ("sync", r"\b(?:uv|poetry|pdm)\s+sync\b"),
        ("pixi", r"\bpixi\s+shell\b"),
        ("torchrun", r"\btorchrun\s"),
        ("accelerate", r"\baccelerate\s+launch\s"),
        (".sh", r"\b(?:ba)?sh\s+\S+\.sh\b"),
        (".bash", r"\b(?:ba)?sh\s+\S+\.bash\b"),
        ("streamlit", r"\bstreamlit\s+run\s"),
        ("octave", r"\boctave(?:-cli)?\s[^\n]{0,300}\.m\b"),
        ("colcon", r"\bcolcon\b"),
        ("coinbrew", r"\bcoinbrew\s"),
        ("jupyter", r"\bjupyter[ -](?:notebook|lab)(?:[\s`]|$)"),
        ("cd", r"\b(?:ros)?cd\s"),
        ("conda", r"\bconda\b"),
        ("mamba", r"\b(?:micro)?mamba\b"),
        ("python", r"\bpython[\d.]*\s+\S"),
        ("cmake", r"\bcmake\b"),
        ("make", r"^\s{0,9}(?:[$>]\s{0,9})?make(?:\s+[\w=./-]{1,80}){0,4}\s*$"),
        ("qmake", r"\bqmake(?:-qt\d)?\b"),
        ("/archive/", "/archive/"),
        ("/releases/", r"/releases/download/[^/\s]+/\S+\.zip\b"),
        ("ppa:", r"\bppa:"),
        ("dpkg", r"\bdpkg\s"),
        (".deb", r"\.deb\b"),
        (".patch", r"\b(?:git|patch)\s"),
        (".diff", r"\b(?:git|patch)\s"),
        (".t", r"\.t(?:ar|gz)\b"),
        (" -C ", r"\btar\s[^\n]{0,200}\s-C\s"),
        ("wget", r"\bwget\s"),
        ("gdown", r"\bgdown\s"),
        ("curl", r"\bcurl\s[^|\n]*?\s?(?:-\w*[oO]|--output|--remote-name)\b"),
        ("unzip", r"\bunzip\s"),
        ("docker", r"\bdocker\s"),
        ("mkdir", r"\bmkdir\s"),
        ("tmux", r"\b(?:tmuxp\s+load|tmuxinator\s+(?:start|local))\s"),
        ("_IGNORE", r"\btouch\s"),
        ("sed ", r"\bsed\s+-"),
        ("/include", r"\b(?:mv|cp|install)\s"),
        ("./", r"(?:^|[\s`$])\.{1,2}/\w"),
        ("build/", r"(?:^|[\s`$])build/\w"),
        ("/lib/", r"\b(?:install|devel)/(?:[\w-]+/)?lib/[\w-]+/[\w.]"),
        ("bin/", r"(?:^|[\s`$])bin/\w"),
    )
)


def signs_in(page: str) -> Signs:
    """Return the signs whose word stands in a page: no line of it has another one."""
    return tuple(each for each in SIGNS if each[0] in page)


def lines_with(page: str, signs: Signs) -> frozenset[int]:
    """Return the numbers, from 1, of the lines of a page on which the word of a sign stands."""
    starts = sorted({start for word, _ in signs for start in lines.lines_with(page, word)})
    numbers: list[int] = []
    number, position = 1, 0
    for start in starts:
        number += page.count("\n", position, start)
        position = start
        numbers.append(number)
    return frozenset(numbers)


def telling(text: str, signs: Signs = SIGNS) -> bool:
    """Tell whether a text may hold a command that tells what to install or to run: nothing else is read."""
    for word, sign in signs:  # noqa: SIM110 - of each line of each page: `any` takes longer
        if word in text and sign.search(text):
            return True
    return False
