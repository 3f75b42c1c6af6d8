"""Lines that send the reader to the top of the repository: ``# Go to the top directory of this repository``.

A page whose blocks each begin there says it in words; the folder that the block before went to is left with it.
"""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

TO_TOP = "cd ~"
"""The command that leaves every folder of a text."""
_PLACE = r"(?:directory|folder|dir)\b"
_OF = (
    r"of[ ](?:the|this|our|your)[ ](?:[\w.-]{1,40}[ ])?"
    r"(?:repo(?:sitory)?|project|package|codebase|source(?:[ ](?:code|tree))?)\b"
)
_BEGINS = r"^[ \t]{0,40}(?:[#>*+-]{1,6}[ \t]+|//[ \t]*|\d{1,2}[.)][ \t]+)?(?:(?:first|then|now|next|finally),?[ ])?"
_GOES = (
    r"(?:(?:go|change|return|navigate|move|switch|cd|come)[ ](?:back[ ])?(?:in)?to|back[ ](?:in[ ]|to[ ])?"
    r"|from|in|inside|at)[ ]"
)
_ENDS = r"[ \t]{0,9}(?:[.,:;!][^`\n]{0,60}|\([^`\n]{0,80}|and\b[^`\n]{0,60})?$"
"""What follows has no command of its own, which would be lost."""
_TOP = pattern(
    rf"{_BEGINS}{_GOES}(?:the[ ])?(?:(?:top|root|main|base)(?:[ -]level)?(?:[ ]{_PLACE})?[ ]{_OF}"
    rf"|repo(?:sitory)?(?:'s)?[ ](?:top|root)(?:[ ]{_PLACE})?"
    rf"|(?:top|root)(?:[ -]level)?[ ]{_PLACE}(?![ ]of)){_ENDS}",
    re.IGNORECASE | re.MULTILINE,
)


def gone_to(text: str) -> str:
    """Return a page with the command that goes to the top in place of such lines; every line keeps its number."""
    return _TOP.sub(TO_TOP, text) if "cd " in text else text
