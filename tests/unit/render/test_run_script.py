"""docker_run.sh: what docker is asked for. A recording stand-in takes docker's place; tests/lab runs the real one."""

from __future__ import annotations

import os
import re
import shutil
import socket
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from roslab.config.model import Matlab, Volume
from roslab.errors import ConfigurationError
from roslab.evidence.entry_script import Taken
from roslab.plan.author_dockerfile import AuthorDockerfile
from roslab.plan.plan import Plan
from roslab.plan.run import Given
from roslab.render.run_script import run_script
from roslab.values.dataclass import replace

Plans = Callable[..., Plan]
Call = Callable[..., Any]
pytestmark = pytest.mark.on_disk  # the script gives an image no folder of the system
HOSTILE = ["a; rm -rf ~", "$(touch owned)", "`touch owned`", "a b", "it's", '"', "&& touch owned"]


def volume(host: str, container: str = "/data", options: str = "") -> Volume:
    return Volume(host_path=host, container_path=container, options=options)


# ---- command and image ----


def test_without_arguments_the_image_runs_its_own_command(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(), context="."))
    assert called.arguments == ["run", "--rm", "--init", "--pull", "never", "--hostname", "roslab", "filter"]


def test_arguments_replace_the_command(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(), context="."), "python3", "demo.py", "--noise", "1", "a b", "$(x)")
    assert called.arguments[-7:] == ["filter", "python3", "demo.py", "--noise", "1", "a b", "$(x)"]


@pytest.mark.parametrize(
    ("takes", "arguments", "end"),
    [
        ("nothing", ("python3", "demo.py"), ["--entrypoint", "python3", "filter", "demo.py"]),
        ("nothing", ("--shell",), ["--entrypoint", "bash", "filter"]),
        ("arguments", ("--shell",), ["--entrypoint", "bash", "filter"]),
        ("arguments", ("--", "--noise"), ["filter", "--noise"]),
        ("commands", ("--shell",), ["filter", "bash"]),
        ("nothing", (), ["--hostname", "roslab", "filter"]),
    ],
)
def test_a_command_takes_the_place_of_an_entry_point_that_would_not_start_it(
    plan: Plans, call: Call, takes: Taken, arguments: tuple[str, ...], end: list[str]
) -> None:
    run = replace(plan().run, entrypoint_takes=takes)
    called = call(run_script(replace(plan(), run=run), context="."), *arguments)
    assert called.arguments[-len(end) :] == end


def test_a_command_may_begin_with_a_dash(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(), context="."), "--", "--version")
    assert called.arguments[-2:] == ["filter", "--version"]


def test_an_unknown_option_is_no_command(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(), context="."), "--privileged")
    assert (called.status, called.argv) == (2, None)
    assert "--privileged is no option of this script" in called.err


def test_its_status_is_the_programs(plan: Plans, call: Call) -> None:
    assert call(run_script(plan(), context="."), env={"STAND_IN_STATUS": "7"}).status == 7


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_name_is_one_word(plan: Plans, call: Call, name: str, tmp_path: Path) -> None:
    (tmp_path / "home").mkdir()
    (tmp_path / "home" / "keep").touch()
    called = call(run_script(plan(name=name), context="."))
    assert called.arguments[-1] == name
    assert (tmp_path / "home" / "keep").exists()
    assert not Path("owned").exists()


@pytest.mark.parametrize("command", [*HOSTILE, "EOF\\", "TEXT"])
def test_a_hostile_command_is_only_shown(plan: Plans, call: Call, command: str) -> None:
    called = call(run_script(plan(command=command), context="."), "--help")
    assert called.status == 0
    assert f"\n  {command}\n" in called.out
    assert not Path("owned").exists()


def test_another_reference_is_run(plan: Plans, call: Call) -> None:
    reference = "ghcr.io/org/filter@sha256:" + "a" * 64
    called = call(run_script(plan(), context="."), "ls", env={"ROSLAB_IMAGE": reference, "STAND_IN_NO_IMAGE": "1"})
    assert called.arguments == ["run", "--rm", "--init", "--hostname", "roslab", reference, "ls"]


def test_an_image_that_was_not_built_is_not_looked_for_on_docker_hub(plan: Plans, call: Call) -> None:
    """Anybody may publish an image of that name there."""
    called = call(run_script(plan(), context="."), env={"STAND_IN_NO_IMAGE": "1"})
    assert (called.status, called.argv) == (5, None)
    assert "run docker_build.sh first" in called.err


def test_input_only_where_something_is_piped_in(plan: Plans, call: Call) -> None:
    assert "--interactive" not in call(run_script(plan(), context=".")).arguments
    read, write = os.pipe()
    os.close(write)
    called = call(run_script(plan(), context="."), "cat", stdin=read)
    os.close(read)
    assert "--interactive" in called.arguments
    assert "--tty" not in called.arguments


def test_a_terminal_where_both_ends_are_one(plan: Plans, call: Call, tmp_path: Path) -> None:
    text = run_script(plan(), context=".")
    call(text)
    record = tmp_path / "record"
    path = f"{tmp_path}/programs:{os.environ['PATH']}"
    command = f"env PATH={path} HOME={tmp_path} STAND_IN_RECORD={record} bash {tmp_path}/docker_run.sh"
    if not shutil.which("script"):
        pytest.skip("script(1) is not installed")
    subprocess.run(["script", "-qec", command, "/dev/null"], capture_output=True, check=True, stdin=subprocess.DEVNULL)
    assert {"--interactive", "--tty"} <= set((record / "argv").read_text().split("\0"))


def test_help_explains_itself(plan: Plans, call: Call) -> None:
    text = run_script(plan(volumes=(volume("~/bags", "/bags", "ro"),), ports=("9090",)), context=".")
    called = call(text, "--help")
    assert (called.status, called.argv) == (0, None)
    for part in (
        "usage: docker_run.sh",
        "python3 demo.py",
        "--notebook",
        "--shell",
        "ROSLAB_IMAGE",
        "~/bags at /bags ro",
        "127.0.0.1:9090:9090",
    ):
        assert part in called.out


def test_a_shell(plan: Plans, call: Call) -> None:
    assert call(run_script(plan(), context="."), "--shell").arguments[-2:] == ["filter", "bash"]


def test_options_for_docker(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(), context="."), "--option", "--memory=1g", "--option=--cpus", "--option", "2", "ls")
    assert called.arguments[-5:] == ["--memory=1g", "--cpus", "2", "filter", "ls"]


# ---- volumes ----


@pytest.mark.parametrize(
    ("options", "names"),
    [
        ([], ["roslab"]),
        (["--option", "--network=none"], ["roslab"]),
        (["--option", "--network=host"], []),
        (["--option", "--network=container:other"], []),
        (["--option", "--uts=host"], []),
        (["--option", "--hostname=robot7"], []),
        (["--option", "--hostname", "--option", "robot7"], ["robot7"]),
    ],
)
def test_a_container_is_named_by_a_word(plan: Plans, call: Call, options: list[str], names: list[str]) -> None:
    assert call(run_script(plan(), context="."), *options).values("--hostname") == names


def test_volumes_of_the_home_and_of_the_repository(plan: Plans, call: Call, tmp_path: Path) -> None:
    for name in ("home/my data", "repo/maps", "repo/out", "scripts"):
        (tmp_path / name).mkdir(parents=True)
    volumes = (
        volume("~/my data", "/a", "ro"),
        volume("$HOME/my data", "/b"),
        volume("${HOME}/my data", "/c", "ro,z"),
        volume("maps", "/d"),
        volume("./maps", "/e"),
        volume("${PWD}/out", "/f"),
        volume(str(tmp_path / "repo"), "/g"),
    )
    called = call(run_script(plan(volumes=volumes), context="../repo"), folder=tmp_path / "scripts")
    home, repo = tmp_path / "home" / "my data", tmp_path / "repo"
    assert called.values("--volume") == [
        f"{home}:/a:ro",
        f"{home}:/b",
        f"{home}:/c:ro,z",
        f"{repo}/maps:/d",
        f"{repo}/maps:/e",
        f"{repo}/out:/f",
        f"{repo}:/g",
    ]
    assert f"the container sees {home} at /a (ro)" in called.err


def test_a_folder_that_is_not_there_is_named(plan: Plans, call: Call) -> None:
    """Docker would make an empty one that belongs to root."""
    called = call(run_script(plan(volumes=(volume("/media/me/EuRoC", "/EuRoC"),)), context="."))
    assert (called.status, called.argv) == (2, None)
    assert "roslab.yaml wants /media/me/EuRoC at /EuRoC" in called.err
    assert "--volume FOLDER:/EuRoC" in called.err


def test_a_folder_that_docker_compose_makes_is_made(plan: Plans, call: Call, tmp_path: Path) -> None:
    made = Volume(host_path="data/kitti", container_path="/data", options="ro", made=True)
    called = call(run_script(plan(volumes=(made,)), context="."))
    there = called.values("--volume")[0].removesuffix(":/data:ro")
    assert there.endswith("data/kitti")
    assert Path(there).is_dir()


def test_a_reader_has_the_data_elsewhere(plan: Plans, call: Call, tmp_path: Path) -> None:
    (tmp_path / "bags").mkdir()
    text = run_script(plan(volumes=(volume("/media/me/EuRoC", "/EuRoC"),)), context=".")
    assert call(text, f"--volume={tmp_path}/bags:/EuRoC:ro").values("--volume") == [f"{tmp_path}/bags:/EuRoC:ro"]
    assert call(text, "--volume", f"{tmp_path}/bags:/EuRoC").values("--volume") == [f"{tmp_path}/bags:/EuRoC"]
    assert "there is no /nowhere" in call(text, "--volume", "/nowhere:/EuRoC").err
    assert "write HOST:CONTAINER" in call(text, "--volume", "/tmp").err
    assert "--volume needs a value" in call(text, "--volume").err


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_volume_is_one_word(plan: Plans, call: Call, tmp_path: Path, name: str) -> None:
    """The original wrote it between double quotes: `--volume="$(touch owned):/data:"`."""
    (tmp_path / name).mkdir()
    called = call(run_script(plan(volumes=(volume(str(tmp_path / name)),)), context="."))
    assert called.values("--volume") == [f"{tmp_path / name}:/data"]
    assert not Path("owned").exists()


@pytest.mark.parametrize(
    "hostile",
    [
        volume("/data", "/x", 'ro" --privileged --volume "/:/host'),
        volume("/data", "/x", "ro --privileged"),
        volume("/data:/etc", "/x"),
        volume("/data", "/x:/y"),
        volume("../../etc", "/x"),
        volume("/data", "relative"),
        volume("", "/x"),
        volume("/da\nta", "/x"),
    ],
)
def test_a_volume_that_docker_reads_otherwise_is_refused(plan: Plans, hostile: Volume) -> None:
    with pytest.raises(ConfigurationError):
        run_script(plan(volumes=(hostile,)), context=".")


@pytest.mark.parametrize("host", ["/", "/etc", "/dev", "/proc", "/usr", "~", "~/.ssh", "link"])
def test_a_repository_gets_no_folder_of_the_system(plan: Plans, call: Call, tmp_path: Path, host: str) -> None:
    (tmp_path / "home" / ".ssh").mkdir(parents=True)
    (tmp_path / "link").symlink_to("/etc")
    text = run_script(plan(volumes=(volume(host),)), context=".")
    called = call(text)
    assert (called.status, called.argv) == (2, None)
    assert "a repository gets no folder of the system" in called.err
    real = str((tmp_path / "home" / host[2:]) if host.startswith("~") else (tmp_path / host)).rstrip("/")
    assert call(text, "--volume", f"{real or '/'}:/data").status == 0, "but its reader may say so"


def test_a_repository_gets_no_socket(plan: Plans, call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Docker's own socket is root on this machine."""
    with socket.socket(socket.AF_UNIX) as listener:
        monkeypatch.chdir(tmp_path)  # the path of a socket must be short
        listener.bind("docker.sock")
        called = call(run_script(plan(volumes=(volume("docker.sock"),)), context="."))
    assert (called.status, called.argv) == (2, None)


def test_matlab_stays_on_the_host(plan: Plans, call: Call, tmp_path: Path) -> None:
    (tmp_path / "MATLAB R1").mkdir()
    matlab = Matlab(host_path=str(tmp_path / "MATLAB R1"), mac_address="2c:60:0c:d6:50:36")
    called = call(run_script(plan(matlab=matlab), context="."))
    assert called.values("--volume") == [f"{tmp_path}/MATLAB R1:{tmp_path}/MATLAB R1:ro"]
    assert called.values("--mac-address") == ["2c:60:0c:d6:50:36"]
    called = call(run_script(plan(matlab=Matlab(host_path="/nowhere")), context="."))
    assert called.values("--volume") == []
    assert "there is no MATLAB at /nowhere" in called.err
    with pytest.raises(ConfigurationError):
        run_script(plan(matlab=Matlab(host_path="/x", mac_address="2c; rm -rf ~")), context=".")


# ---- ports and notebook ----


@pytest.mark.parametrize(
    ("port", "published"),
    [
        ("9090", "127.0.0.1:9090:9090"),
        ("8080:80", "127.0.0.1:8080:80"),
        ("0.0.0.0:8080:80", "0.0.0.0:8080:80"),
        ("5005:5005/udp", "127.0.0.1:5005:5005/udp"),
        ("[::1]:8080:80", "[::1]:8080:80"),
    ],
)
def test_a_port_is_opened_on_this_machine_only_unless_said(plan: Plans, call: Call, port: str, published: str) -> None:
    assert call(run_script(plan(ports=(port,)), context=".")).values("--publish") == [published]


@pytest.mark.parametrize("port", ["x", "80 --privileged", "$(x):80", "1:2:3:4", ""])
def test_no_port(plan: Plans, port: str) -> None:
    with pytest.raises(ConfigurationError, match="as a port"):
        run_script(plan(ports=(port,)), context=".")


def test_jupyterlab_is_on_this_machine_only_and_asks_for_a_token(plan: Plans, call: Call) -> None:
    """The original published 8888 on every address, with an empty token: a shell for whoever reached it."""
    text = run_script(plan(notebook=True), context=".")
    called = call(text, "--notebook")
    (published,) = called.values("--publish")
    address, host, container = published.split(":")
    assert (address, host) == ("127.0.0.1", container)
    token = (called.record / "token").read_text()
    assert re.fullmatch(r"[0-9a-f]{48}", token)
    assert token not in " ".join(called.arguments), "arguments are everybody's to read"
    assert called.values("--env") == ["JUPYTER_TOKEN"]
    assert f"http://127.0.0.1:{host}/lab/tree/README.ipynb?token={token}" in called.out
    assert f"--port={container}" in called.arguments
    assert not [word for word in called.arguments if "token=" in word.lower()]
    assert (call(text, "--notebook").record / "token").read_text() != token, "a new one each time"


def test_old_formats_publish_8888_for_the_notebook_alone(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(notebook=True, generation="later"), context="."))
    assert "--publish" not in called.arguments


def test_a_port_in_use_is_left_alone(plan: Plans, call: Call) -> None:
    with socket.socket() as listener:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listener.bind(("127.0.0.1", 8888))
        except OSError:
            pass  # somebody else's: just as good
        else:
            listener.listen()
        called = call(run_script(plan(notebook=True), context="."), "--notebook")
    assert called.values("--publish") != ["127.0.0.1:8888:8888"]


def test_on_the_hosts_network_jupyterlab_listens_on_this_machine_only(plan: Plans, call: Call) -> None:
    text = run_script(plan(notebook=True, ports=("9090",)), context=".")
    for options in (["--option=--network=host"], ["--option", "--net", "--option", "host"]):
        called = call(text, "--notebook", *options)
        assert "--ip=127.0.0.1" in called.arguments
        assert "--publish" not in called.arguments


def test_the_notebook_beside_the_script_is_brought_along(plan: Plans, call: Call, tmp_path: Path) -> None:
    (tmp_path / "README.ipynb").write_text("{}")
    called = call(run_script(plan(notebook=True), context="."), "--notebook")
    assert called.values("--volume") == [f"{tmp_path}/README.ipynb:/run/roslab/README.ipynb:ro"]


def test_an_image_without_jupyterlab_says_so(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(), context="."), "--notebook")
    assert (called.status, called.argv) == (2, None)
    assert "`notebook: true`" in called.err
    authored = AuthorDockerfile(dockerfile="Dockerfile", context=".")
    assert call(run_script(plan(author_dockerfile=authored), context="."), "--notebook").status == 0, (
        "of the author's nothing is known"
    )


def test_a_container_that_starts_a_shell_is_given_the_command(plan: Plans, call: Call) -> None:
    authored = AuthorDockerfile(dockerfile="Dockerfile", context=".")
    words = ("bash", "-c", 'exec "$@"', "start", "roslaunch", "demo", "demo.launch")
    given = plan(author_dockerfile=authored, given=Given(command=words, entrypoint=True))
    called = call(run_script(given, context="."))
    assert called.arguments[-8:] == ["filter", *words]
    assert "--entrypoint" not in called.arguments
    assert call(run_script(given, context="."), "ls", "-l").arguments[-3:] == ["filter", "ls", "-l"]
    assert call(run_script(given, context="."), "--shell").arguments[-2:] == ["filter", "bash"]
    instead = plan(author_dockerfile=authored, given=Given(command=words, entrypoint=False))
    called = call(run_script(instead, context="."))
    assert called.values("--entrypoint") == ["bash"]
    assert called.arguments[-7:] == ["filter", *words[1:]]


# ---- screen and graphics card ----


@pytest.fixture
def display() -> Iterator[str]:
    """Return the name of a display at which something listens."""
    folder = Path("/tmp/.X11-unix")
    folder.mkdir(exist_ok=True, mode=0o1777)
    number = 20000 + os.getpid()
    path = folder / f"X{number}"
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(path))
        yield f":{number}"
    path.unlink()


def test_x11(plan: Plans, call: Call, display: str, tmp_path: Path) -> None:
    """The original made a key at a fixed name in /tmp that everybody could read."""
    runtime = tmp_path / "runtime"
    runtime.mkdir()
    home = tmp_path / "home"
    home.mkdir()
    if shutil.which("xauth"):
        key = "0123456789abcdef0123456789abcdef"
        subprocess.run(["xauth", "-q", "-f", str(home / ".Xauthority"), "add", display, ".", key], check=True)
    env = {"DISPLAY": display, "XDG_RUNTIME_DIR": str(runtime), "XAUTHORITY": str(home / ".Xauthority")}
    called = call(run_script(plan(gui=True), context="."), env=env)
    socket_volume, key_volume = called.values("--volume")
    path = f"/tmp/.X11-unix/X{display[1:]}"
    assert socket_volume == f"{path}:{path}:ro"
    assert key_volume.startswith(f"{runtime}/roslab.")
    assert (called.record / "key-folder").read_text().split() == ["700", str(os.getuid())]
    assert f"DISPLAY={display}" in called.values("--env")
    assert list(runtime.iterdir()) == [], "it is removed afterwards"
    if shutil.which("xauth"):
        content = (called.record / "key").read_bytes()
        assert content.startswith(b"\xff\xff"), "valid for any host name"
        assert bytes.fromhex(key) in content


def test_the_key_goes_when_the_program_fails(plan: Plans, call: Call, display: str, tmp_path: Path) -> None:
    runtime = tmp_path / "runtime"
    runtime.mkdir()
    env = {"DISPLAY": display, "XDG_RUNTIME_DIR": str(runtime), "STAND_IN_STATUS": "3"}
    assert call(run_script(plan(gui=True), context="."), env=env).status == 3
    assert list(runtime.iterdir()) == []


def test_x11_without_xauth(plan: Plans, call: Call, display: str, tmp_path: Path) -> None:
    programs = tmp_path / "few"
    programs.mkdir()
    for name in ("bash", "dirname", "basename", "uname", "id", "mktemp", "chmod", "cat", "rm", "cp", "stat", "grep"):
        (programs / name).symlink_to(str(shutil.which(name)))
    (programs / "docker").symlink_to(tmp_path / "programs" / "docker")
    (tmp_path / "home").mkdir()
    (tmp_path / "home" / ".Xauthority").write_bytes(b"key")
    env = {"DISPLAY": display, "PATH": str(programs), "TMPDIR": str(tmp_path)}
    called = call(run_script(plan(gui=True), context="."), env=env)
    assert (called.record / "key").read_bytes() == b"key"
    assert called.values("--hostname") == [os.uname().nodename], "the key is for this host's name"


def test_x11_over_ssh(plan: Plans, call: Call, tmp_path: Path) -> None:
    called = call(run_script(plan(gui=True), context="."), env={"DISPLAY": "localhost:10.0", "TMPDIR": str(tmp_path)})
    assert called.values("--network") == ["host"]
    assert "DISPLAY=localhost:10.0" in called.values("--env")


def test_wayland(plan: Plans, call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with socket.socket(socket.AF_UNIX) as listener:
        monkeypatch.chdir(tmp_path)  # the path of a socket must be short
        listener.bind("wayland-7")
        env = {"WAYLAND_DISPLAY": "wayland-7", "XDG_RUNTIME_DIR": str(tmp_path)}
        text = run_script(plan(gui=True), context=".").replace("image_user=1000", f"image_user={os.getuid()}")
        called = call(text, env=env)
        assert called.values("--volume") == [f"{tmp_path}/wayland-7:/run/user/{os.getuid()}/wayland-0"]
        assert "WAYLAND_DISPLAY=wayland-0" in called.values("--env")
        other = call(text.replace(f"image_user={os.getuid()}", "image_user=54321"), env=env)
    assert other.values("--volume") == []
    assert "Wayland's socket is open to user" in other.err


@pytest.mark.parametrize("env", [{}, {"DISPLAY": ":9999999"}, {"WAYLAND_DISPLAY": "/nowhere"}])
def test_no_screen_is_told_and_no_obstacle(plan: Plans, call: Call, env: dict[str, str]) -> None:
    called = call(run_script(plan(gui=True), context="."), env=env)
    assert called.status == 0
    assert called.arguments[-1] == "filter"
    assert "there is no screen here" in called.err
    assert "there is no screen here" not in call(run_script(plan(gui=True), context="."), "--no-gui", env=env).err


def test_the_graphics_card(plan: Plans, call: Call) -> None:
    text = run_script(plan(gpu=True), context=".")
    called = call(text, env={"STAND_IN_RUNTIMES": '{"nvidia":{},"runc":{}}'})
    assert called.values("--gpus") == ["all"]
    assert call(text, "--no-gpu", env={"STAND_IN_RUNTIMES": '{"nvidia":{}}'}).values("--gpus") == []


def test_without_nvidias_toolkit_it_says_what_to_install_and_goes_on(plan: Plans, call: Call) -> None:
    text = run_script(plan(gpu=True), context=".")
    called = call(text)
    assert called.values("--gpus") == []
    assert "the NVIDIA Container Toolkit is not installed" in called.err
    assert call(text, "--gpu").values("--gpus") == ["all"]
    assert "NVIDIA" not in call(text, "--no-gpu").err


def test_docker_down(plan: Plans, call: Call) -> None:
    called = call(run_script(plan(), context="."), env={"STAND_IN_DOWN": "1"})
    assert (called.status, called.argv) == (5, None)
    assert "docker does not answer: Cannot connect" in called.err
