"""Folders of the author's machine that files name: links lead to what the tree has, the rest is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>"
)
BEHAVIOR = "config/behavior.xml"


def package(folder: str, name: str = "server") -> dict[str, str]:
    at = f"{folder}/" if folder else ""
    return {
        f"{at}package.xml": MANIFEST.format(name),
        f"{at}CMakeLists.txt": f"project({name})\nfind_package(ament_cmake REQUIRED)\n",
        f"{at}{BEHAVIOR}": "<root/>\n",
    }


def linked(tree: Tree, files: dict[str, str]) -> list[tuple[str, str]]:
    return list(tree({"README.md": "ROS 2 Humble\n", **files}).author_folders)


@pytest.mark.parametrize(
    ("folder", "path", "found"),
    [
        ("server", "/home/user/ros2_ws/src/server/config/behavior.xml", ("/home/user/ros2_ws/src", "source")),
        (
            "server",
            "/home/user/ros2_ws/src/whole/server/config/behavior.xml",
            ("/home/user/ros2_ws/src/whole", "source"),
        ),
        ("src/server", "/home/user/ros2_ws/src/server/config/behavior.xml", ("/home/user/ros2_ws", "source")),
        ("nav/server", "/home/user/ros2_ws/src/server/config/behavior.xml", ("/home/user/ros2_ws/src", "source/nav")),
        ("", "/home/me/ws/src/server/config/behavior.xml", ("/home/me/ws/src/server", "source")),
        ("", "/home/me/ws/src/server/", ("/home/me/ws/src/server", "source")),
        ("server", "/home/me/server/config/behavior.xml", ("/home/me/server", "source/server")),
        ("server", "/ros2_ws/src/server/config/behavior.xml", ("/ros2_ws/src", "source")),
        ("src/server", "/src/server/config/behavior.xml", ("/src", "source/src")),
        ("server", "/home/me/ws/src/server/config/", ("/home/me/ws/src", "source")),
        ("server", "/home/me/ws/src/server/config/written.xml", ("/home/me/ws/src", "source")),
        (
            "server",
            "/home/me/ws/install/server/share/server/config/a.xml",
            ("/home/me/ws/install", "workspace/install"),
        ),
        ("server", "/home/me/ws/install/other/share/other/config/a.xml", None),
        ("server", "/home/me/ws/devel/share/server/config/a.xml", None),
        ("server", "/home/me/config/behavior.xml", None),
        ("server", "/home/me/data/other.xml", None),
        ("server", "/usr/src/server/config/behavior.xml", None),
        ("server", "/opt/ros/server/config/behavior.xml", None),
        ("server", "/root/ws/src/server/config/behavior.xml", None),
        ("server", "/Users/me/ws/src/server/config/behavior.xml", None),
        ("server", "/home/jovyan/ws/src/server/config/behavior.xml", None),
        ("server", "$(find x)/home/me/src/server/config/behavior.xml", None),
    ],
)
def test_a_folder_of_the_author_s_leads_to_what_the_tree_has(
    tree: Tree, folder: str, path: str, found: tuple[str, str] | None
) -> None:
    files = {**package(folder), f"{folder}/include/server/a.hpp".lstrip("/"): "\n"}
    files |= {f"{folder}/config/a.yaml".lstrip("/"): f'bt: 1\nfile: "{path}"\n'}
    assert linked(tree, files) == ([found] if found else [])


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("config/a.yaml", "a: ~/robot_ws/src/server/config/behavior.xml\n", "~/robot_ws/src"),
        ("config/a.yaml", "a: '~/robot_ws/src/whole/server/config/written.csv'\n", "~/robot_ws/src/whole"),
        ("scripts/a.py", 'a = expanduser("~/robot_ws/src/server/config")\n', "~/robot_ws/src"),
        ("scripts/a.py", 'a = os.environ["HOME"] + "/robot_ws/src/server/config/behavior.xml"\n', "~/robot_ws/src"),
        ("scripts/a.py", "a = os.path.join(os.getenv('HOME'), 'robot_ws/src/server/config')\n", "~/robot_ws/src"),
        ("scripts/a.py", 'a = Path.home() / "robot_ws/src/server/config/behavior.xml"\n', "~/robot_ws/src"),
        ("scripts/a.py", '# a = "~/robot_ws/src/server/config/behavior.xml"\n', ""),
        (
            "src/a.cpp",
            'a = std::string(getenv("HOME")) + "/robot_ws/src/server/config/behavior.xml";\n',
            "~/robot_ws/src",
        ),
        ("src/a.cpp", 'a = "$HOME/robot_ws/src/server/config/behavior.xml";\n', "~/robot_ws/src"),
        (
            "launch/a.launch.xml",
            '<launch><arg name="a" default="$(env HOME)/robot_ws/src/server/config/behavior.xml"/></launch>\n',
            "~/robot_ws/src",
        ),
        ("config/a.yaml", "a: ~/robot_ws/install/server/share/server/config/a.yaml\n", "~/robot_ws/install"),
        ("config/a.yaml", "a: ~/robot_ws/src/other/config/map.yaml\n", ""),
        ("config/a.yaml", "a: ~/maps/src/map.yaml\n", ""),
        ("config/a.yaml", "a: ~someone/robot_ws/src/server/config/behavior.xml\n", ""),
        ("scripts/a.py", 'a = get_share() + "~/robot_ws/src/server/config/behavior.xml"\n', "~/robot_ws/src"),
    ],
)
def test_below_the_home_of_whoever_runs_it_the_author_s_workspace_is_linked(
    tree: Tree, name: str, text: str, found: str
) -> None:
    files = {**package("server"), f"server/{name}": text, "README.md": "ROS 2 Humble\n"}
    decision = tree(files)
    assert [folder for folder, _ in decision.author_folders] == ([found] if found else [])
    assert not any("a path of its author's" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("boot.sh", "cd ~/robot_ws/src/server/launch\nros2 launch a.py\n", True),
        ("setup/boot.bash", 'cd "$HOME/robot_ws/src/server/launch" && ros2 launch a.py\n', True),
        ("boot.sh", "# cd ~/robot_ws/src/server/launch\nros2 launch server a.py\n", False),
        ("boot.sh", "cd ~/robot_ws/src/server/launch\n./a.py\n", False),
        ("boot.sh", "cd ~/robot_ws/src/server/maps\nros2 launch server a.py\n", False),
        ("setup.sh", "cd ~/robot_ws/src/server/launch\nsudo apt-get install -y figlet\nros2 launch a.py\n", False),
        ("tests/boot.sh", "cd ~/robot_ws/src/server/launch\nros2 launch a.py\n", False),
    ],
)
def test_a_script_that_starts_programs_finds_the_author_s_workspace(
    tree: Tree, name: str, text: str, *, found: bool
) -> None:
    files = {**package("server"), "server/launch/a.py": "def generate_launch_description():\n    1\n", name: text}
    assert linked(tree, files) == ([("~/robot_ws/src", "source")] if found else [])


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("source ~/robot_ws/install/setup.bash\nros2 launch server a.py\n", "~/robot_ws/install"),
        ("source /home/me/robot_ws/install/local_setup.sh\nros2 run server a\n", "/home/me/robot_ws/install"),
        ("source ~/Desktop/robot/install/setup.bash\nros2 launch server a.py\n", "~/Desktop/robot/install"),
        ("source ~/robot_ws/devel/setup.bash\nros2 launch server a.py\n", ""),
        ("source ~/a_ws/install/setup.bash\nsource ~/b_ws/install/setup.bash\nros2 launch server a.py\n", ""),
        ("source /opt/ros/humble/setup.bash\nros2 launch server a.py\n", ""),
        ("source ~/robot_ws/install/setup.bash\n", ""),
        ("source /etc/robot/install/setup.bash\nros2 launch server a.py\n", ""),
        ("source /usr/lib/install/setup.bash\nros2 launch server a.py\n", ""),
        ("source /home/me/../../etc/robot/install/setup.bash\nros2 launch server a.py\n", ""),
        ("source ~/../../etc/robot/install/setup.bash\nros2 launch server a.py\n", ""),
        ("source /home/me/-robot/install/setup.bash\nros2 launch server a.py\n", ""),
    ],
)
def test_the_one_workspace_that_such_a_script_sources_is_the_image_s(tree: Tree, text: str, found: str) -> None:
    made = [(found, "workspace/install")] if found else []
    assert linked(tree, {**package("server"), "boot.sh": f"set -e\n{text}"}) == made


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("scripts/a.py", 'open("{}")\n', True),
        ("scripts/a.py", '# open("{}")\n', False),
        ("src/a.cpp", 'std::string a = "{}";\n', True),
        ("src/a.cpp", '// std::string a = "{}";\n', False),
        ("launch/a.launch.xml", '<launch><arg name="a" default="{}"/></launch>\n', True),
        ("launch/a.launch.xml", '<launch><!--\n<arg name="a" default="{}"/> --></launch>\n', False),
        ("worlds/a.world", "<uri>file://{}</uri>\n", True),
        ("test/a.py", 'open("{}")\n', False),
    ],
)
def test_what_names_it(tree: Tree, name: str, text: str, *, found: bool) -> None:
    path = "/home/me/ws/src/server/config/behavior.xml"
    files = {**package("server"), f"server/{name}": text.format(path)}
    assert linked(tree, files) == ([("/home/me/ws/src", "source")] if found else [])


def test_of_folders_inside_each_other_one_is_linked_and_a_place_is_told(tree: Tree) -> None:
    paths = ["/home/me/ws/src/server/config/behavior.xml", "/home/me/ws/src/server/config/a.yaml"]
    files = {**package("src/server"), "src/server/config/a.yaml": "".join(f"- {path}\n" for path in paths)}
    files["src/server/config/b.yaml"] = "a: /home/me/ws/install/server/share/server/config/a.yaml\n"
    decision = tree({"README.md": "ROS 2 Humble\n", **files})
    assert decision.author_folders == (("/home/me/ws", "source"),), "which has the folder that the build writes, too"
    reasons = [each for each in decision.reasons if each.answer == "/home/me/ws"]
    assert [(each.file, each.line) for each in reasons] == [("src/server/config/a.yaml", 1)]


def test_what_two_packages_may_mean_is_not_linked(tree: Tree) -> None:
    files = {**package("one/server", "one_server"), **package("two/server", "two_server")}
    files["one/server/config/a.yaml"] = "a: /home/me/ws/src/server/config/behavior.xml\n"
    assert linked(tree, files) == []


LAUNCH = (
    "import os\nfrom launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
    "from ament_index_python.packages import get_package_share_directory\n\n\n"
    "def generate_launch_description():\n"
    "    a = os.path.join(get_package_share_directory('server'), 'config', 'a.yaml')\n"
    "    return LaunchDescription([Node(package='server', executable='serve', parameters=[a])])\n"
)


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("server/config/a.yaml", "a: 1\nb: /home/me/data/map.pcd\n", 2),
        ("server/config/a.yaml", "a: /home/me/ws/src/server/config/behavior.xml\n", None),
        ("server/config/a.yaml", "a: /home/me/ws/src/server/config/gone.xml\n", 1),
        ("server/config/other.yaml", "a: /home/me/data/map.pcd\n", None),
        ("server/launch/demo.launch.py", f"{LAUNCH}A = '/home/me/map.pcd'\n", 10),
        ("server/src/serve.cpp", '\nload("/home/me/map.pcd");\nload("C:\\\\Users\\\\me\\\\a.pcd");\n', 2),
        ("server/src/serve.cpp", '\nsave("/home/me/ws/src/server/config/written.txt");\n', None),
        ("server/src/other.cpp", '\nload("/home/me/map.pcd");\n', None),
    ],
)
def test_what_the_tree_has_not_is_told_of_what_the_command_reaches(
    tree: Tree, name: str, text: str, told: int | None
) -> None:
    files = {**package("server"), "server/launch/demo.launch.py": LAUNCH, name: text}
    files["README.md"] = "ROS 2 Humble\n```\nros2 launch server demo.launch.py\n```\n"
    decision = tree(files)
    assert decision.command == ("ros2", "launch", "server", "demo.launch.py")
    warnings = [(w.file, w.line) for w in decision.warnings if "a path of its author's computer" in w.message]
    assert warnings == ([(name, told)] if told else [])


def test_a_parameter_file_of_the_launch_file_s_own_package_is_meant(tree: Tree) -> None:
    files = {**package("server"), **package("client", "client"), "server/launch/demo.launch.py": LAUNCH}
    files |= {"server/config/a.yaml": "a: /home/me/a.pcd\n", "client/config/a.yaml": "a: /home/me/b.pcd\n"}
    files["README.md"] = "ROS 2 Humble\n```\nros2 launch server demo.launch.py\n```\n"
    warnings = [w.file for w in tree(files).warnings if "a path of its author's computer" in w.message]
    assert warnings == ["server/config/a.yaml"]


def test_the_node_that_the_command_names_is_read_too(tree: Tree) -> None:
    files = {**package("server"), "server/src/serve.cpp": 'int main() { load("/home/me/map.pcd"); }\n'}
    files["server/CMakeLists.txt"] += (
        "add_executable(serve src/serve.cpp)\ninstall(TARGETS serve DESTINATION lib/server)\n"
    )
    files["README.md"] = "ROS 2 Humble\n```\nros2 run server serve\n```\n"
    decision = tree(files)
    assert decision.command == ("ros2", "run", "server", "serve")
    warnings = [(w.file, w.line) for w in decision.warnings if "a path of its author's computer" in w.message]
    assert warnings == [("server/src/serve.cpp", 1)]


@pytest.mark.parametrize(
    ("path", "found"),
    [("/home/me/ws/src/server/config", True), ("/home/me/ws/src/server/gone/a", False), ("/home/me/opencv", False)],
)
def test_what_cmake_takes_from_there_is_linked_or_told(tree: Tree, path: str, *, found: bool) -> None:
    files = package("server")
    files["server/CMakeLists.txt"] += f"include_directories({path})\n"
    decision = tree({"README.md": "ROS 2 Humble\n", **files})
    assert decision.author_folders == ((("/home/me/ws/src", "source"),) if found else ())
    told = [(w.file, w.line) for w in decision.warnings if "is a folder of its author's computer" in w.message]
    assert told == ([] if found else [("server/CMakeLists.txt", 3)])


PROGRAM = "import numpy\nimport argparse\nCFG = {path!r}\nif __name__ == '__main__':\n    print(open(CFG).read())\n"


@pytest.mark.parametrize(
    ("path", "found"),
    [
        ("/home/bob/phd/thesis/cfg/a.yaml", [("/home/bob/phd/thesis", "source")]),
        ("/home/bob/phd/thesis/data/a.yaml", []),
        ("/home/bob/phd/thesis/a.yaml", []),
        ("/home/jovyan/thesis/cfg/a.yaml", []),
        ("/scratch/bob/thesis/cfg/a.yaml", [("/scratch/bob/thesis", "source")]),
        ("/thesis/cfg/a.yaml", []),
        ("/data/cfg/a.yaml", []),
        ("/datasets/bob/cfg/a.yaml", []),
        ("/workspace/cfg/a.yaml", []),
        ("/content/drive/cfg/a.yaml", []),
    ],
)
def test_a_program_of_no_package_finds_the_tree_where_its_author_had_it(
    tree: Tree, path: str, found: list[tuple[str, str]]
) -> None:
    given = tree({"run.py": f"{PROGRAM.format(path=path)}# /src/\n", "cfg/a.yaml": "a: 1\n"})
    assert list(given.author_folders) == found


def test_what_a_program_of_no_package_lacks_is_told(tree: Tree) -> None:
    given = tree({"run.py": PROGRAM.format(path="/home/bob/sets/kitti/00.bin")})
    assert any("/home/bob/sets/kitti/00.bin, a path of its author's computer" in w.message for w in given.warnings)


@pytest.mark.parametrize(
    ("asks", "told"),
    [
        ("if os.path.exists(there):", False),
        ("if os.path.isdir('/data'):\n    pass\nelif path.isdir( there ):", False),
        ("if there.is_file():", False),
        ("if not os.path.exists(there):", True),
        ("if os.path.exists(elsewhere):", True),
        ("with open(there):", True),
    ],
)
def test_a_program_that_asks_for_a_path_before_it_reads_it_does_not_stop(tree: Tree, asks: str, *, told: bool) -> None:
    code = (
        f"import os\nfrom pathlib import Path\nthere = Path('/home/bob/sets/kitti/00.bin')\n{asks}\n    print(there)\n"
    )
    given = tree({"run.py": f"{code}if __name__ == '__main__':\n    print()\n"})
    assert any("/home/bob/sets/kitti/00.bin, a path of its author's" in w.message for w in given.warnings) is told


ABOVE = "os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))"


@pytest.mark.parametrize(
    ("above", "name", "found"),
    [
        (ABOVE, "Thesis.planner.run", True),
        ("str(Path(__file__).resolve().parents[2])", "Thesis.planner.run", True),
        ("Path(__file__).parent.parent.parent", "Thesis.planner.run", True),
        ("os.path.join(os.path.dirname(__file__), '../..')", "Thesis.planner.run", True),
        ("os.path.dirname(__file__) + '/../..'", "Thesis.planner.run", True),
        ("os.path.dirname(os.path.dirname(__file__))", "Thesis.planner.run", False),
        ("os.path.join(os.path.dirname(__file__), '../../lib')", "Thesis.planner.run", False),
        (ABOVE, "Thesis.gone.run", False),
        (ABOVE, "planner.run", False),
        (ABOVE, "tools.planner.run", False),
    ],
)
def test_code_that_imports_the_checkout_by_its_folder_s_name_has_a_link_of_that_name(
    tree: Tree, above: str, name: str, *, found: bool
) -> None:
    code = f"import os, sys\nfrom pathlib import Path\n\nmine = {above}\nsys.path.append(mine)\nfrom {name} import go\n"
    files = {
        "planner/start.py": f"{code}if __name__ == '__main__':\n    go()\n",
        "planner/run.py": "def go():\n    1\n",
    }
    decision = tree({**files, "tools/planner/run.py": "def go():\n    1\n"})
    assert decision.author_folders == ((("~/Thesis", "source"),) if found else ())
    reasons = [(each.file, each.line) for each in decision.reasons if each.question == "workspace"]
    assert (("planner/start.py", 6) in reasons) is found
    tried = [each.name for each in decision.python.pip_guessed]
    assert ("Thesis" in tried) is (name.startswith("Thesis") and not found)
