"""How much each mention of a ROS distribution counts."""

from __future__ import annotations

from typing import ClassVar


class Weight:
    """How much each reason for a distribution counts; what is run counts more than what is only written."""

    BRANCH = 900  # a branch of that name is for that distribution, even if its files still name another
    DOCKERFILE: ClassVar = {
        "project": 700,  # it was built with this code
        "ci": 520,  # the environment in which CI tests the code
        "deploy": 450,  # for one robot or machine
        "documentation": 300,
        "broken": 200,
        "vendored": 50,
    }
    COPIES = 20  # added for a Dockerfile that copies this source
    CI_IMAGE = 520  # of ROS's own; somebody's image for a tool may be older than what CI tests
    TABLE = 480  # a page has a table of its branches: below what CI tests, above what sentences say
    CHANNEL = 510  # of conda's packages of ROS: it is what the author runs
    FAMILY = 440  # one of a family of images, one for each distribution
    PLACE: ClassVar = {
        "ci": 500,  # it is tested there at every push
        "dockerfile": 430,  # a line other than its FROM
        "filename": 420,
        "script": 330,
        "code": 280,  # a path of it: more than an Ubuntu alone, less than any sentence that names a distribution
    }
    RECOMMENDED = 420  # if a page names several
    TELLS_TO_HAVE = 400  # "tested on", "install", "requires"
    SPEAKS_OF_IT = 300
    AGAINST = 180  # subtracted if the sentence is about another time or branch
    ROS2_BRANCH = 410  # development follows rolling: wins over any sentence but a recommendation
    LIST = 390  # a list of repositories for one distribution has what that one lacks; others may need no list
    UBUNTU: ClassVar = {"dockerfile": 260, "ci": 240, "readme": 230}  # an Ubuntu that has only this distribution
    HAS_EVERY_KEY = 100  # nothing names it, but it fits
    TYPESTORE = 120  # the messages that code reads bags with: less than any word of a page, more than a date
    ADDRESS = 110  # only in the address of what a page links to, or code: a word of its own, and an Ubuntu, tell more
    EXAMPLE = 30  # it stands for whatever the reader has; the date of the last commit tells more
    VENDORED = 20  # in a file copied from another project
    DEFAULT = 1
    LACKS_A_KEY = 400  # subtracted if it lacks a declared key: an outdated Dockerfile then counts less than a page
    DEEPER = 5  # subtracted for each folder above the file: deeper files are about a part
    DEEPER_PAGE = 15
    DOCUMENTATION = 60  # subtracted for a page in a documentation folder
