"""The lab's command: python3 tests/lab up | down | status | env | real."""

from __future__ import annotations

import argparse
import sys

from . import laboratory, network, tools
from .command import LabError
from .home import home

TEXT = """\
The laboratory in which this project is tested for real where no image can be pulled: a Docker engine, two registries
on the loopback, a buildkitd, emulation of arm64, stand-in base images under their real names, act and Node.

  up [--all] [--native]   make and start what is missing; what is there stays. --all: also the images that take
                          minutes under emulation; --native: nothing of arm64
  up --base NAME          the stand-in of this image alone, also where it is made only on request (ros:indigo-ros-base,
                          nvidia/cuda:… without its toolkit)
  up --lint               the linters alone; needs no engine
  up --packages           what comes with packages of this machine alone: the engine, the registries, Xvfb
  down                    end what `up` started; what it made stays in the cache
  status                  say what runs
  path                    print the folder of the linters
  env                     print the lines for `eval "$(python3 tests/lab env)"`
  real                    say whether the real docker.io is in reach (then no stand-ins are used)

Everything it keeps is in $REPRO_LAB_HOME, else in repro-action-lab in the user's cache folder.

The actions that ours use have stand-ins in tests/lab/actions. To run the real ones instead, name a folder with a copy
of each in OWNER__NAME, such as docker__build-push-action, with its action.yml and its dist; what is not there keeps its
stand-in, and so does actions/checkout, which under act cannot know which code is under test:

  REPRO_LAB_ACTIONS=FOLDER python3 -m pytest tests/lab/test_action.py tests/lab/test_workflows.py

Debian packages no rclcpp, so the stand-ins for ROS 2 have ament, the message generators and colcon alone. Where
packages ros-jazzy-* for Debian 12 are at hand, ros-jazzy-ros-base among them, name their folder once; they are kept:

  REPRO_LAB_ROS2=FOLDER python3 tests/lab up

No code host is in reach either. Where copies of repositories are at hand (bare, with their work tree, or as links),
put them into a folder as github.com/OWNER/NAME, and name it each time: what a build, or git on this machine, clones
from github.com, gitlab.com, bitbucket.org or codeberg.org, a server on the engine's bridge then answers from there.
The Dockerfile stays as it is; builds without the variable are as before. It is for the engine's own builder:

  export REPRO_LAB_GIT=FOLDER; python3 tests/lab up; eval "$(python3 tests/lab env)"; roslab build REPOSITORY
"""


def main(argv: list[str]) -> int:
    """Run one command; return 0 when done, 1 when a step failed, 2 for wrong arguments."""
    layout = argparse.RawTextHelpFormatter
    parser = argparse.ArgumentParser(prog="python3 tests/lab", description=TEXT, formatter_class=layout)
    commands = parser.add_subparsers(dest="command", required=True, metavar="up|down|status|env|real")
    up = commands.add_parser("up", help="make and start what is missing")
    up.add_argument("--all", action="store_true", help="also the images that take minutes under emulation")
    up.add_argument("--native", action="store_true", help="nothing of arm64")
    up.add_argument("--base", action="append", metavar="NAME", help="the stand-in of this image alone")
    up.add_argument("--lint", action="store_true", help="the linters alone")
    up.add_argument("--packages", action="store_true", help="what comes with packages of this machine alone")
    for name in ("down", "status", "env", "path", "real"):
        commands.add_parser(name)
    options = parser.parse_args(argv)
    try:
        if options.command == "up" and options.lint:
            laboratory.lint()
        elif options.command == "up":
            emulated, made = not options.native, not options.packages
            laboratory.up(emulated=emulated, everything=options.all, bases=options.base, made=made)
        elif options.command == "down":
            laboratory.down()
        elif options.command == "status":
            print(f"home: {home()}")
            print("\n".join(f"{name}: {state}" for name, state in laboratory.status().items()))
        elif options.command == "env":
            print(laboratory.shell_exports())
        elif options.command == "path":
            print(tools.linters())
        else:
            print("real: docker.io is in reach" if network.real_registry() else "stand-ins: docker.io is out of reach")
    except LabError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0
