"""The ladder of a proof, for real: how far images get, and what is said of those that are built to fool it."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from lab import doors, registry
from lab.act import run_workflow
from lab.home import CHECKOUT
from lab.laboratory import Laboratory
from roslab.config.model import ProofGoals, ProofLimits
from roslab.plan.ladder import Ladder, Rung
from roslab.plan.proof import Proof
from roslab.plan.record import KEY
from roslab.prove import containers
from roslab.prove.ladder import climb

Roslab = Callable[..., CompletedProcess[str]]
Climb = Callable[..., Ladder]

TALK_1 = """\
#!/usr/bin/env python3
import sys, rospy
from std_msgs.msg import String
rospy.init_node("talker")
silent = rospy.Publisher("/silent", String, queue_size=1)
chatter = None if "silent" in sys.argv else rospy.Publisher("/chatter", String, queue_size=1)
while not rospy.is_shutdown():
    if chatter:
        chatter.publish("hello")
    rospy.sleep(0.1)
"""
TALK_2 = """\
import sys, time, rclpy
from rcl_interfaces.msg import Log
rclpy.init()
node = rclpy.create_node("talker")
silent = node.create_publisher(Log, "/silent", 1)
chatter = None if "silent" in sys.argv else node.create_publisher(Log, "/chatter", 1)
while rclpy.ok():
    rclpy.spin_once(node, timeout_sec=0.1)
    if chatter:
        chatter.publish(Log(msg="hello"))
"""
DIE = "#!/usr/bin/env python3\nimport sys, time\ntime.sleep(1.5)\nsys.exit(3)\n"
LIVE = "#!/usr/bin/env python3\nimport time\ntime.sleep(600)\n"


def launch_1(*nodes: str) -> str:
    lines = "".join(f'<node pkg="fools" type="{node}/>\n' for node in nodes)
    return f"<launch>\n{lines}</launch>\n"


def launch_2(*nodes: str) -> str:
    return (
        "from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n"
        f"def generate_launch_description():\n    return LaunchDescription([{', '.join(nodes)}])\n"
    )


def process(name: str, more: str = "") -> str:
    return f'ExecuteProcess(cmd=["python3", "/fools/{name}.py"], name="{name}"{more})'


MANIFEST = """\
<package format="2"><name>fools</name><version>1.0.0</version><description>x</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license></package>
"""
FOOLS_1 = {
    "Dockerfile": "FROM ros:noetic-ros-base\nCOPY . /opt/ros/noetic/share/fools\n"
    "RUN chmod +x /opt/ros/noetic/share/fools/*.py\n",
    "package.xml": MANIFEST,
    "talk.py": TALK_1,
    "die.py": DIE,
    "live.py": LIVE,
    "good.launch": launch_1('talk.py" name="talker"'),
    "silent.launch": launch_1('talk.py" name="talker" args="silent"'),
    "respawned.launch": launch_1('talk.py" name="talker"', 'die.py" name="dies" respawn="true"'),
    "one_of_three.launch": launch_1('talk.py" name="talker"', 'die.py" name="dies"', 'live.py" name="lives"'),
}
FOOLS_2 = {
    "Dockerfile": "FROM ros:jazzy-ros-base\nCOPY . /fools\n",
    "talk.py": TALK_2,
    "die.py": DIE,
    "live.py": LIVE,
    "good.launch.py": launch_2(process("talk")),
    "silent.launch.py": launch_2('ExecuteProcess(cmd=["python3", "/fools/talk.py", "silent"])'),
    "respawned.launch.py": launch_2(process("talk"), process("die", ", respawn=True")),
    "one_of_three.launch.py": launch_2(process("talk"), process("die"), process("live")),
}
PLAIN = {
    "Dockerfile": "FROM ubuntu:24.04\n"
    "RUN apt-get update && apt-get install -y --no-install-recommends python3-tk && rm -rf /var/lib/apt/lists/*\n"
    "COPY . /fools\n",
    "window.py": "import sys, tkinter\nroot = tkinter.Tk()\nroot.geometry('1920x1080+0+0')\n"
    "canvas = tkinter.Canvas(root, width=1920, height=1080, background='black', highlightthickness=0)\ncanvas.pack()\n"
    "if 'draw' in sys.argv:\n    canvas.create_oval(120, 40, 520, 440, fill='orange')\nroot.mainloop()\n",
    "die.py": DIE,
}


@pytest.fixture(scope="module")
def image(lab: Laboratory, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., str]]:
    """Return a function that builds a folder of files once and returns the image's name."""
    made: dict[str, str] = {}

    def build(name: str, files: dict[str, str]) -> str:
        if name not in made:
            folder = doors.write(tmp_path_factory.mktemp(name), files)
            docker(lab, "build", "--quiet", "--tag", f"repro-lab-{name}", str(folder))
            made[name] = f"repro-lab-{name}"
        return made[name]

    yield build
    for name in made.values():
        docker(lab, "image", "rm", "--force", name)


def docker(lab: Laboratory, *arguments: str, check: bool = True) -> str:
    command = ["docker", *arguments]
    answer = subprocess.run(command, env=dict(lab.environment), capture_output=True, text=True, check=False)
    assert answer.returncode == 0 or not check, answer.stderr
    return answer.stdout


@pytest.fixture
def climbs(lab: Laboratory, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Climb:
    """Return a function that proves an image with one command, and what came of it."""
    for name, value in lab.environment.items():
        monkeypatch.setenv(name, value)

    def run(name: str, *proofs: Proof, goals: ProofGoals | None = None) -> Ladder:
        wanted = goals or ProofGoals()
        limits = ProofLimits()
        outcomes = containers.prove(name, "linux/amd64", proofs, limits=limits, goals=wanted, screenshots=tmp_path)
        return climb(proofs, outcomes, wanted)

    return run


def start(command: str, ros: str = "", *, display: bool = False) -> Proof:
    graph = {"ros1": "ros1", "ros2": "ros2"}.get(ros)
    return Proof(
        name="the default command starts",
        command=("bash", "-c", command),
        required=False,
        may_run_on=True,
        display=display,
        rung=1,
        graph=graph,  # type: ignore[arg-type]
    )


def rung(ladder: Ladder, number: int) -> Rung:
    return next(each for each in ladder.rungs if each.number == number)


PRETENDS = "echo 'SUCCESS: all nodes are running'; sleep 600"


@pytest.mark.parametrize(
    ("command", "reached", "number", "state", "said"),
    [
        ("roslaunch fools good.launch", 2, 2, "held", "1 node (/talker); in"),
        ("roslaunch fools silent.launch", 1, 2, "missed", "/silent [std_msgs/String] 0 messages"),
        ("roslaunch fools good.launch", 2, 2, "held", "/silent [std_msgs/String] 0 messages"),
        ("roslaunch fools respawned.launch", None, 1, "missed", "dies-3 died with exit code 3"),
        ("roslaunch fools one_of_three.launch", None, 1, "missed", "dies-3 died with exit code 3"),
        (PRETENDS, 1, 2, "missed", "no node was in the graph: no ROS master answered"),
    ],
    ids=["good", "silent", "one-silent", "respawned", "one-of-three", "pretends"],
)
def test_ros_1(  # noqa: PLR0917 - a table of cases
    image: Callable[..., str], climbs: Climb, command: str, reached: int | None, number: int, state: str, said: str
) -> None:
    ladder = climbs(image("fools-1", FOOLS_1), start(command, "ros1"))
    assert ladder.reached == reached, ladder
    assert rung(ladder, number).state == state
    assert said in rung(ladder, number).said


@pytest.fixture(scope="module")
def jazzy(lab: Laboratory, image: Callable[..., str]) -> str:
    """Return an image with rclpy; Debian packages none, so the lab has it only where it was given packages of ROS 2."""
    base = "ros:jazzy-ros-base"
    command = ["docker", "run", "--rm", "--pull", "never", base, "python3", "-c", "import rclpy"]
    answer = subprocess.run(command, env=dict(lab.environment), capture_output=True, text=True, check=False)
    if answer.returncode:
        pytest.skip(f"{base} has no rclpy: REPRO_LAB_ROS2=FOLDER python3 tests/lab up")
    return image("fools-2", FOOLS_2)


@pytest.mark.parametrize(
    ("command", "reached", "number", "state", "said"),
    [
        ("ros2 launch /fools/good.launch.py", 2, 2, "held", "/chatter [rcl_interfaces/Log]"),
        ("ros2 launch /fools/silent.launch.py", 1, 2, "missed", "/silent [rcl_interfaces/Log] 0 messages"),
        ("ros2 launch /fools/respawned.launch.py", None, 1, "missed", "die-2 died with exit code 3"),
        ("ros2 launch /fools/one_of_three.launch.py", None, 1, "missed", "die-2 died with exit code 3"),
        (PRETENDS, 1, 2, "missed", "no node was in the graph"),
    ],
    ids=["good", "silent", "respawned", "one-of-three", "pretends"],
)
def test_ros_2(  # noqa: PLR0917 - a table of cases
    jazzy: str, climbs: Climb, command: str, reached: int | None, number: int, state: str, said: str
) -> None:
    ladder = climbs(jazzy, start(command, "ros2"))
    assert ladder.reached == reached, ladder
    assert rung(ladder, number).state == state
    assert said in rung(ladder, number).said


@pytest.mark.usefixtures("x_server")
@pytest.mark.parametrize(
    ("command", "display", "states", "said"),
    [
        (PRETENDS, False, {1: "held"}, "the command still ran after"),
        ("while true; do python3 /fools/die.py; done", False, {1: "held"}, "python3 /fools/die.py was started anew"),
        ("python3 /fools/window.py", True, {1: "held", 3: "missed"}, "the screen had one colour"),
        ("python3 /fools/window.py draw", True, {1: "held", 3: "held"}, "a window showed more than one colour"),
        ("touch ~/map.png; sleep 600", False, {1: "held"}, "the command still ran after"),
        ("echo a,b > ~/table.csv", False, {1: "held", 3: "held"}, "it wrote /root/table.csv"),
    ],
    ids=["pretends", "loop", "one-colour", "window", "empty-file", "file"],
)
def test_a_plain_program(  # noqa: PLR0917 - a table of cases
    image: Callable[..., str], climbs: Climb, command: str, display: bool, states: dict[int, str], said: str
) -> None:
    ladder = climbs(image("plain", PLAIN), start(command, display=display))
    assert {each.number: each.state for each in ladder.rungs} == states
    assert said in ladder.rungs[-1].said


def test_a_test_that_collects_nothing(image: Callable[..., str], climbs: Climb) -> None:
    command = ("bash", "-c", "mkdir /tmp/none && python3 -m unittest discover -s /tmp/none || [ $? = 5 ]")
    ladder = climbs(image("plain", PLAIN), Proof(name="the repository's test", command=command, rung=4))
    assert (rung(ladder, 4).state, ladder.reached) == ("missed", None)
    assert "ran no test" in rung(ladder, 4).said


def test_a_rung_that_is_asked_for(lab: Laboratory, roslab: Roslab, tmp_path: Path) -> None:
    """Below it the image gets no name; the talker without its test reaches rung 2."""
    folder = doors.write(
        tmp_path / "fools",
        {
            **FOOLS_1,
            "Dockerfile": FOOLS_1["Dockerfile"] + 'CMD ["roslaunch", "fools", "silent.launch"]\n',
            "roslab.yaml": "format: 3\nname: asked\nkind: ros1\ndockerfile: Dockerfile\nproof: {rung: 2}\n",
        },
    )
    answer = roslab("build", folder, "--tag", "repro-lab", env=lab.environment, timeout=900)
    assert answer.returncode == 5
    assert "asks for rung 2, talks, and rung 2, talks, does not hold: a message on /silent" in answer.stderr
    assert not docker(lab, "images", "--quiet", "asked:repro-lab")


def test_what_is_published_can_be_verified(lab: Laboratory, roslab: Roslab, tmp_path: Path) -> None:
    """Through the workflow: the summary, the annotation of the index, the same rungs again, and a changed image."""
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    place = "/opt/ros/noetic/share/fools"
    recipe = f"FROM ros:noetic-ros-base\nCOPY package.xml good.launch talk.py {place}/\n"
    recipe += f'RUN chmod +x {place}/talk.py\nCMD ["roslaunch", "fools", "good.launch"]\n'
    config = "format: 3\nkind: ros1\ndockerfile: Dockerfile\nplatforms: [linux/amd64]\n"
    files = {**FOOLS_1, "Dockerfile": recipe, "roslab.yaml": config}
    caller = doors.through_workflow(tmp_path / "caller", {"registry": lab.registry}, files)
    ran = run_workflow(lab, caller, "push", doors.payload(name), env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log
    assert "rung 2, talks" in ran.summary
    assert "/chatter" in ran.summary
    index, _ = registry.manifest(f"{doors.OWNER}/{name}:main")
    record = json.loads(index["annotations"][KEY])
    ((platform, ladder),) = record["platforms"]
    assert platform == "linux/amd64"
    assert [(each["number"], each["state"]) for each in ladder["rungs"]] == [(0, "held"), (1, "held"), (2, "held")]

    published = f"{lab.registry}/{doors.OWNER}/{name}:main"
    same = roslab("verify", published, env=lab.environment, timeout=300)
    assert same.returncode == 0, same.stderr
    assert "the same rungs as were recorded" in same.stdout
    changed = doors.write(tmp_path / "changed", {"talk.py": TALK_1.replace("/chatter", "/rumour")})
    recipe = f"FROM {published}\nCOPY talk.py {place}/\nRUN chmod +x {place}/talk.py\n"
    (changed / "Dockerfile").write_text(recipe)
    other = f"{lab.registry}/{doors.OWNER}/{name}:changed"
    docker(lab, "build", "--quiet", "--tag", other, str(changed))
    docker(lab, "push", "--quiet", other)
    differs = roslab("verify", other, "--like", published, "--format", "json", env=lab.environment, timeout=300)
    assert differs.returncode == 5, differs.stderr
    assert json.loads(differs.stdout)["difference"] == (
        "rung 2, talks: `topic /chatter [std_msgs/String] talks` was recorded, and is not so now; "
        "now there is `topic /rumour [std_msgs/String] talks`"
    )
    docker(lab, "image", "rm", "--force", other, check=False)


@pytest.mark.parametrize("door", ["action", "ros2"])
def test_the_talker_of_ros_2_through_both_doors(lab: Laboratory, roslab: Roslab, tmp_path: Path, door: str) -> None:
    """From its tree alone: its nodes talk before it is published, and where that is verified; a changed one differs."""
    if not lab.ros2:
        pytest.skip("Debian has no rclcpp, and REPRO_LAB_ROS2 named no folder of packages: see tests/lab/README.md")
    example = CHECKOUT / "examples/ros2_talker"
    files = {str(path.relative_to(example)): path.read_text() for path in example.rglob("*") if path.is_file()}
    image = lab.fresh_repository(f"{doors.OWNER}/talker").partition("/")[2]
    inputs = {"registry": lab.registry, "image": image, "platforms": "linux/amd64"}
    if door == "action":
        caller = doors.through_action(tmp_path / "caller", inputs, files, base={})
    else:
        caller = doors.through_workflow(tmp_path / "caller", {**inputs, "distro": "jazzy"}, files, base={}, door=door)
    ran = run_workflow(lab, caller, "push", doors.payload("talker"), env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log
    assert "rung 2, talks" in ran.summary
    index, _ = registry.manifest(f"{image}:main")
    ((_, ladder),) = json.loads(index["annotations"][KEY])["platforms"]
    assert [(each["number"], each["state"]) for each in ladder["rungs"]] == [(0, "held"), (1, "held"), (2, "held")]
    said = ladder["rungs"][2]["said"]
    assert re.search(r"2 nodes \(/listener, /talker\); .*/chatter \[std_msgs/String\] [1-9]\d* messages", said), said
    if door == "action":
        return
    published = f"{lab.registry}/{image}:main"
    same = roslab("verify", published, env=lab.environment, timeout=300)
    assert same.returncode == 0, same.stderr
    assert "the same rungs as were recorded" in same.stdout
    (tmp_path / "Dockerfile").write_text(f"FROM {published}\nRUN find ~/ws/install -name listener -type f -delete\n")
    other = f"{lab.registry}/{image}:changed"
    docker(lab, "build", "--quiet", "--tag", other, str(tmp_path))
    docker(lab, "push", "--quiet", other)
    differs = roslab("verify", other, "--like", published, env=lab.environment, timeout=300)
    assert differs.returncode == 5, differs.stderr
    assert "first difference: rung 1, starts: it held when it was recorded" in differs.stdout
    docker(lab, "image", "rm", "--force", other, published, check=False)


def test_the_talker_through_the_laptop(lab: Laboratory, roslab: Roslab, tmp_path: Path) -> None:
    answer = roslab("build", CHECKOUT / "examples/ros1_talker", "--tag", "repro-lab", env=lab.environment, timeout=900)
    assert answer.returncode == 0, answer.stderr
    assert "rung 2, talks, holds: 2 nodes (/listener, /talker); in" in answer.stderr
    assert "reached: rung 4, agrees" in answer.stderr
    image = "ros1_talker:repro-lab"
    record = json.loads(docker(lab, "image", "inspect", "--format", f'{{{{index .Config.Labels "{KEY}"}}}}', image))
    assert [each["number"] for each in record["platforms"][0][1]["rungs"]] == [0, 1, 2, 4]
    (tmp_path / "Dockerfile").write_text(f"FROM {image}\nRUN rm ../../devel/lib/ros1_talker/talker\n")
    docker(lab, "build", "--quiet", "--tag", "ros1_talker:changed", str(tmp_path))
    changed = roslab("verify", "ros1_talker:changed", env=lab.environment, timeout=300)
    assert changed.returncode == 5, changed.stderr
    assert "first difference: rung 1, starts: it held when it was recorded" in changed.stdout
    docker(lab, "image", "rm", "--force", image, "ros1_talker:changed")
