"""The table of packages that no distribution released names each once, with needs and distributions that there are."""

from roslab.knowledge.distros import distros
from roslab.knowledge.released import released
from roslab.knowledge.ros_sources import ros_sources
from roslab.knowledge.table import rows


def test_the_table_names_a_package_of_a_ros_version_once() -> None:
    names = [(row["package"], row["ros"]) for row in rows("ros_sources")]
    assert len(names) == len({*names})


def test_what_a_row_needs_has_a_row_for_the_same_distributions() -> None:
    for row in rows("ros_sources"):
        for needed in row["after"].split():
            for distro in row["distros"].split() or [""]:
                assert ros_sources(needed, int(row["ros"]), distro), (row["package"], needed, distro)


def test_the_packages_of_one_repository_are_prepared_alike() -> None:
    found: dict[tuple[str, str], set[tuple[str, str]]] = {}
    for row in rows("ros_sources"):
        found.setdefault((row["repo"], row["ros"]), set()).add((row["ref"], row["prepare"]))
    assert [repo for (repo, ros), ways in found.items() if ros == "2" and len(ways) > 1] == []


def test_the_distributions_of_a_row_are_known_and_lack_the_package() -> None:
    for row in rows("ros_sources"):
        for distro in row["distros"].split():
            assert str(distros()[distro].ros) == row["ros"], row["package"]
        fitting = row["distros"].split() or [each.name for each in distros().values() if str(each.ros) == row["ros"]]
        assert any(row["package"] not in released(distro) for distro in fitting), row["package"]
