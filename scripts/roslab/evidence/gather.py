"""Calling every reader: a repository's evidence."""

from __future__ import annotations

import posixpath

from roslab.evidence import git_folder, links, of_x86, places, pointers, submodules
from roslab.evidence.facts import Evidence
from roslab.evidence.mentioned import BESIDE_PROSE, MENTIONED, OF_DOCKERFILES, of_ros
from roslab.evidence.native import (
    argument_counts,
    asked_variables,
    authors_folders,
    beside_builds,
    by_variables,
    cmake,
    compared,
    configured,
    cpp,
    cpu,
    extension_code,
    fetching,
    gpu_code,
    gpus,
    latest_releases,
    lost_headers,
    made_elsewhere,
    makefiles,
    misnamed,
    opens_above,
    other_builders,
    ros_paths,
    shared_objects,
    stops_without,
    strict,
    x86,
)
from roslab.evidence.native import clones as native_clones
from roslab.evidence.native.asked_modules import of_modules
from roslab.evidence.native.limits import Signs
from roslab.evidence.native.nowhere import Nowhere
from roslab.evidence.prose import (
    apt_lists,
    apt_sources,
    author_dockerfile,
    called_in_scripts,
    ci,
    containers,
    copies,
    fetched_here,
    gazebo,
    guides,
    home_archives,
    included,
    install_scripts,
    large_files,
    launchers,
    linked,
    listed_releases,
    named_weights,
    notebook_installs,
    own_packages,
    page_lists,
    patches,
    pointed,
    readme,
    ros_links,
    script_parameters,
    session_scripts,
    sessions,
    shown_folders,
    tried,
    worked_on,
)
from roslab.evidence.prose.merged import merge
from roslab.evidence.prose.named_notebooks import with_notebooks
from roslab.evidence.python import (
    at_top,
    called,
    clones,
    commented,
    conda,
    imports,
    limits,
    linked_files,
    listens,
    locks,
    loggers,
    notebooks,
    omitted_packages,
    on_gpu,
    options,
    pixi,
    plot_backends,
    programs,
    project,
    reached,
    removed,
    requirements,
    siblings,
    start_imports,
    stopped_setup,
    tests,
    usetex,
)
from roslab.evidence.python.opened_notebooks import used_in_notebooks
from roslab.evidence.ros import (
    author_folders,
    beside_python,
    commit_date,
    distro_names,
    launch,
    loaded,
    lost_folders,
    malformed,
    marked,
    named_in_code,
    nested,
    only_in_manifest,
    package_xml,
    plugins,
    rosbuild,
    rosdep_lists,
    vcs,
)
from roslab.repository.checkout import Repository

PROSE = (
    author_dockerfile.prose,  # the author's own image: the most reliable
    containers.read,  # what the author's containers run
    ci.read,  # another machine on which the build works
    readme.read,  # what people are told, perhaps years ago
    install_scripts.read,  # install scripts, called by any of the three
    notebook_installs.read,  # what their cells install
    apt_lists.read,  # names without a command
    ros_links.read,
    guides.read,
    home_archives.read,
    large_files.read,
)


def gather(repository: Repository) -> Evidence:
    """Read everything that a repository says about itself; nothing of it is executed."""
    whole, repository = repository, made_elsewhere.without(repository)
    found = package_xml.read(repository) or rosbuild.read(repository)
    repository, manifests = nested.without(other_builders.without(marked.without(repository, found)), found)
    fetched = fetching.read(repository)
    signs, intrinsics = Signs(), x86.Intrinsics()
    nowhere = Nowhere(repository, manifests, vcs.submodules(repository))
    cmake_projects = beside_python.without(cmake.read(repository), manifests)
    own = submodules.without(repository)
    if any(own.has(manifest.file) for manifest in manifests) or any("/" not in p.file for p in cmake_projects):
        own = repository  # of what is compiled, the submodules are a part
    prose = submodules.with_launches(own_packages.found(merge(reader(own) for reader in PROSE), own), repository)
    said, shown = pointed.read(own), shown_folders.read(own)
    python_projects = project.read(repository)
    stopped = stopped_setup.chosen(python_projects, prose.requirements)
    by_pip = [each for each in python_projects if not places.vendored(each.file)]
    made = makefiles.read(own, prose.mentions)
    names = {name for each in by_pip for name, _ in each.scripts} | {name for each in made for name in each.installs}
    names |= {name for each in cmake_projects if not manifests for name, _ in each.executables}
    files = {posixpath.basename(file): file for each in by_pip for file in each.script_files}
    started = programs.read(repository)
    imported = imports.read(repository)
    below = {name: each.folder for each in by_pip for name, _ in each.scripts}
    by_name = readme.named(own, dict.fromkeys(names, "") | files, below)
    sources = (
        *(source for manifest in manifests if not manifest.ignored for source in manifest.sources),
        *vcs.read(repository),
        *prose.sources,
        *clones.read(own, prose.sources),
    )
    sources = (*sources, *links.read(repository, sources))
    lost = links.lost(repository, sources)
    sources = (*sources, *(by_name_alone := links.listed(lost) if manifests else ()))
    sources = (*sources, *native_clones.read(repository, sources, cmake_projects))
    lists = submodules.named(requirements.read(repository, prose.requirements), own, prose.requirements)
    by_file = linked_files.read(own)
    listed = any(source.kind == "vcs" for source in sources)  # a repository may hold no more than the list of others
    otherwise = tuple(other_builders.read(repository))
    folders = tuple((each.name, posixpath.dirname(each.file)) for each in manifests if each.name)
    paths = author_folders.read(repository, folders)
    there = {(path.file, path.line) for path in paths if path.there and not path.made}
    dates = manifests or cmake_projects or made or listed or by_file or otherwise
    return Evidence(
        manifests=manifests,
        cmake=cmake_projects,
        makefiles=made,
        python=python_projects,
        requirements=lists,
        conda=(*conda.read(own, prose.requirements), *pixi.read(own)),
        locked=locks.read(own),
        unsafe_hosts=fetched.hosts,
        dockerfiles=(dockerfiles := author_dockerfile.read(own)),
        launch=(launched := launch.read(repository)),
        programs=started,
        notebooks=notebooks.alone(own),
        tests=tests.read(repository),
        code=(
            *cpp.read(repository, signs, intrinsics, nowhere),
            *nowhere.all(signs),
            *(imported if manifests else used_in_notebooks(own, imported, (*prose.mentions, *said))),
            *called.read(own),
            *loggers.read(own),
            *plot_backends.read(own),
            *usetex.packages(own),
            *plugins.read(repository),
            *(links.packages(lost) if manifests else ()),
            *(loaded.read(repository) if manifests else ()),
            *fetched.programs,
            *configured.read(own),
            *shared_objects.read(own),
            *called_in_scripts.read(own, prose.mentions),
            *session_scripts.read(own),
            *by_file,
            *git_folder.needed(own),
        ),
        prose=prose.dependencies,
        prose_pip=(*prose.requirements, *project.not_by_pip(python_projects)),
        listed=page_lists.read(own),
        sources=sources,
        patches=patches.read(own, prose.mentions, dockerfiles),
        origin=repository.origin or "",
        own_keys=rosdep_lists.read(repository) if manifests else (),
        commented=named_in_code.read(repository) if manifests else (),
        apt_sources=apt_sources.read(own),
        mentions=(
            *distro_names.read(repository, ci.of_others(repository)),
            *with_notebooks(fetched_here.without(prose.mentions, own), said),
            *linked.read(own, prose.mentions, ros=bool(manifests)),
            *by_name,
            *said,
            *shown,
            *(mention for reader in OF_DOCKERFILES for mention in reader(own, dockerfiles)),
            *sessions.read(own),
            *((*included.read(own), *gazebo.read(own), *compared.read(own), *ros_paths.read(own)) if manifests else ()),
            *(of_ros(own, whole) if manifests else ()),
            *(mention for reader in (only_in_manifest, lost_folders) for mention in reader.read(own, manifests)),
            *(mention for reader in BESIDE_PROSE for mention in reader(own, (*prose.mentions, *shown))),
            *at_top.read(own, prose.mentions, launched, python_projects),
            *(() if manifests else reached.read(own, imported, started, prose.mentions)),
            *(() if manifests else start_imports.read(own, imported, started, prose.mentions)),
            *on_gpu.read(own, launched),
            *listens.read(own, prose.mentions, started),
            *siblings.read(own, python_projects),
            *lost_headers.read(own, python_projects),
            *stopped_setup.folders(stopped),
            *(() if manifests else (*opens_above.read(own, cmake_projects), *other_builders.of_windows(own))),
            *argument_counts.read(own, cmake_projects),
            *options.read(own, (*prose.mentions, *by_name)),
            *options.of_programs(own, started, (*prose.mentions, *by_name)),
            *(mention for reader in (script_parameters, launchers) for mention in reader.read(own, prose.mentions)),
            *tried.read(own, (*prose.mentions, *by_name)),
            *named_weights.read(own, (*prose.mentions, *by_name)),
            *(mention for reader in MENTIONED for mention in reader(own)),
            *otherwise,
            *stops_without.read(own, cmake_projects),
            *(asked_variables.read(own, cmake_projects) if manifests or cmake_projects else ()),
            *commented.read(own, lists),
            *called_in_scripts.unpackaged(own, prose.mentions),
            *(commit_date.read(repository) if dates else ()),
            *strict.read(repository),
            *omitted_packages.read(repository),
        ),
        worked_on=worked_on.read(repository),
        old_code=extension_code.read(own, python_projects),
        bounds=removed.read(own),
        limits=(
            *signs.all(repository),
            *of_modules(cmake_projects, made),
            *limits.read(repository),
            *gpus.read(repository),
        ),
        listed_releases=listed_releases.read(own),
        cmake_modules=cmake.modules(repository),
        by_variables=by_variables.read(repository),
        misnamed=misnamed.read(repository),
        author_paths=paths,
        copies=copies.read(repository, manifests),
        repositories=copies.repositories(repository, manifests),
        cuda_files=cpp.cuda_files(repository),
        compiled_files=len(repository.suffixed(*cpp.COMPILED)),
        beside=beside_builds.read(whole),
        x86_only=tuple(of_x86.read(repository, intrinsics, signs.included)),
        problems=(
            *repository.problems,
            *malformed.problems(manifests),
            *nested.problems(found, manifests),
            *vcs.absent(repository),
            *links.problems(lost, by_name_alone),
            *cpu.read(repository),
            *gpu_code.read(repository),
            *latest_releases.read(repository),
            *authors_folders.read(repository, there),
            *made_elsewhere.read(whole),
            *pointers.read(repository),
            *stopped_setup.problems(stopped),
        ),
    )
