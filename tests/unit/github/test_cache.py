"""A pull request cannot leave a layer for anybody, a release starts from none."""

from __future__ import annotations

import pytest

from roslab.github.cache import layers, mounts, tree
from roslab.github.event import Event, publication
from roslab.github.run import short

IMAGE = "ghcr.io/lab/robot"


def event(**said: object) -> Event:
    usual = {
        "name": "push",
        "repository": "lab/robot",
        "ref": "refs/heads/main",
        "sha": "0" * 40,
        "default_branch": "main",
    }
    return Event(**{**usual, **said})  # type: ignore[arg-type]


def decide(found: Event, wish: str = "auto") -> tuple[tuple[str, ...], tuple[str, ...]]:
    decided = layers(found, publication(found, "auto"), wish, image=IMAGE, part="linux-arm64")  # type: ignore[arg-type]
    assert decided.reason
    return decided.read, decided.write


def reference(branch: str) -> str:
    return f"type=registry,ref={IMAGE}:buildcache-{branch.replace('/', '-')}-{short(branch, '')}-linux-arm64"


def test_a_branch_reads_its_own_and_the_default_branchs_and_writes_its_own() -> None:
    assert decide(event()) == ((reference("main"),), (f"{reference('main')},mode=max,ignore-error=true",))
    read, write = decide(event(ref="refs/heads/feature/x"))
    assert read == (reference("feature/x"), reference("main"))
    assert write == (f"{reference('feature/x')},mode=max,ignore-error=true",)


@pytest.mark.parametrize("head", ["lab/robot", "stranger/robot", None])
def test_a_pull_request_reads_and_never_writes(head: str | None) -> None:
    found = event(name="pull_request", ref="refs/pull/7/merge", proposed=True, head=head, base_branch="next")
    assert decide(found) == ((reference("next"), reference("main")), ())
    assert decide(found, "registry")[1] == ()


def test_a_release_reads_and_writes_nothing() -> None:
    assert decide(event(ref="refs/tags/v1.0.0"), "registry") == ((), ())


def test_a_build_tree_lies_beside_the_layers_and_shares_no_tag_with_them() -> None:
    def kept(found: Event) -> tuple[tuple[str, ...], str]:
        decided = tree(found, publication(found, "auto"), "auto", image=IMAGE, part="linux-arm64")
        return decided.read, decided.write

    main, feature = (f"{reference(branch).partition('ref=')[2]}.tree" for branch in ("main", "feature"))
    assert kept(PUSH) == ((main,), main)
    assert kept(BRANCH) == ((feature, main), feature)
    assert kept(PULL) == kept(FOREIGN) == ((main,), "")
    assert kept(QUEUE)[1] == ""
    assert kept(RELEASE) == ((), "")
    assert kept(event(name="schedule")) == ((), main)


def test_a_scheduled_build_reads_nothing() -> None:
    read, write = decide(event(name="schedule"))
    assert read == ()
    assert write


def test_off() -> None:
    assert decide(event(), "none") == ((), ())
    assert decide(event(act=True)) == ((), ())
    assert decide(event(act=True), "registry")[1]


def test_a_tag_of_the_cache_is_a_valid_tag() -> None:
    read, _ = decide(event(ref="refs/heads/" + "ö/" * 100))
    tag = read[0].rpartition(":")[2]
    assert len(tag) <= 128
    assert tag.isascii()


def test_no_two_branches_or_variants_share_a_cache() -> None:
    def tag(branch: str, variant: str = "") -> str:
        found = event(ref=f"refs/heads/{branch}")
        decided = layers(found, publication(found, "auto"), "auto", image=IMAGE, part="all", variant=variant)
        return decided.read[0]

    long = "x" * 90
    names = ("x/y", "x-y", "x:y", "X-Y", long + "1", long + "2")
    found = [tag(name) for name in names] + [tag("x-y", '{"distro": "humble"}'), tag("x-y", '{"distro": "jazzy"}')]
    assert len(set(found)) == len(found)
    assert all(len(name.rpartition(":")[2]) <= 128 for name in found)


PUSH = event(run="7")
PULL = event(name="pull_request", ref="refs/pull/7/merge", proposed=True, head="lab/robot", base_branch="main")
FOREIGN = event(name="pull_request", ref="refs/pull/7/merge", proposed=True, head="stranger/robot", base_branch="main")
BRANCH = event(ref="refs/heads/feature")
QUEUE = event(ref="refs/heads/gh-readonly-queue/main/pr-7")
RELEASE = event(ref="refs/tags/v1.0.0", run="7")


def test_no_two_lines_of_trust_share_what_a_step_keeps() -> None:
    every = [mounts(found, "auto") for found in (PUSH, PULL, FOREIGN, BRANCH, QUEUE, RELEASE, event(name="schedule"))]
    every += [mounts(event(run="9"), "none"), mounts(PUSH, "auto", variant="humble")]
    assert len(set(every)) == len(every)
    assert mounts(PUSH, "auto") == mounts(event(sha="1" * 40, run="8"), "auto"), "the next push goes on with it"
    assert mounts(RELEASE, "auto") != mounts(event(ref="refs/tags/v1.0.0", run="8"), "auto")
