#!/bin/bash
# usage: eval "$(index-as-of DAY [--or-today])"
# Gives every pip of this step, whatever its version, the index as it was at the end of a day (UTC): a server that lasts as
# long as the step leaves out each file that the index got later. The index must tell when (PEP 700, as PyPI does).
# With --or-today no package is missing for it: where the index does not tell, or has nothing of the day for this Python,
# that is said and newer ones are taken; and a later version can still be had by its exact number. Where pip fails for
# something that can be done about, ask-pip-again calls it again.
# What its authors took back (PEP 592) is shown as the index shows it, unless the day had nothing else of the package.
# Of two packages that are released together (released-together.txt) one later version brings the other of that number.
# Where wheels are preferred, one of plain Python is not taken before the source of a newer version: nothing is compiled.
# Where git-as-of is in the image, what pip clones without naming a commit is of the day too.
set -euo pipefail

# The first may be the system's, without pip, beside another one that has it; pip knows its index where none is set
python=''
for name in python3 python2 python; do
  if "${name}" -c 'import pip' 2>/dev/null; then python="$(command -v "${name}")" && break; fi
done
if [ -z "${python}" ] && [ -n "${PIP_INDEX_URL:-}" ]; then
  python="$(command -v python3 || command -v python2 || command -v python || true)"
fi
if [ -z "${python}" ]; then
  echo "roslab: there is no Python with pip yet to ask the index: pip's packages are those of today" >&2
  exit 0
fi
# Where nothing is configured, pip's own index
usual='
try: from pip._internal.models.index import PyPI
except ImportError: from pip.models.index import PyPI
print(PyPI.simple_url)'
index="${PIP_INDEX_URL:-$("${python}" -m pip config get global.index-url 2>/dev/null || "${python}" -c "${usual}")}"
ready="$(mktemp)"
free="$(mktemp -u /dev/shm/index-as-of.XXXXXX)"
"${python}" - "$1" "${index%/}/" "${ready}" "${2:-}" "${free}" <<'PYTHON' 3>&2 >/dev/null 2>/dev/shm/index-as-of.log &
import json
import os
import re
import sys

try:
    from html import escape
    from http.server import BaseHTTPRequestHandler, HTTPServer
    from socketserver import ThreadingMixIn
    from urllib.error import HTTPError
    from urllib.parse import urljoin
    from urllib.request import Request, urlopen
except ImportError:
    from BaseHTTPServer import BaseHTTPRequestHandler, HTTPServer
    from cgi import escape
    from SocketServer import ThreadingMixIn
    from urllib2 import HTTPError, Request, urlopen
    from urlparse import urljoin

try:
    from pip._vendor.packaging.specifiers import SpecifierSet
    from pip._vendor.packaging.tags import sys_tags

    TAGS = set(map(str, sys_tags()))
except ImportError:
    TAGS = set()

DAY, INDEX, READY = sys.argv[1:4]
OR_TODAY = sys.argv[4:5] == ["--or-today"]
FREE = sys.argv[-1]
TOGETHER = "/usr/local/share/roslab/released-together.txt"
JSON = "application/vnd.pypi.simple.v1+json"
PREFERRED = os.environ.get("PIP_PREFER_BINARY", "0") not in ("", "0", "no", "false")
SAID = set()


def say(text):
    if text not in SAID:
        SAID.add(text)
        os.write(3, ("roslab: " + text + "\n").encode("utf-8"))


def files_of(name):
    address = urljoin(INDEX, name + "/")
    answer = urlopen(Request(address, headers={"Accept": JSON}), timeout=60)
    if JSON not in answer.headers.get("Content-Type", ""):
        raise ValueError("the index does not tell when it got its files")
    files = json.loads(answer.read().decode("utf-8"))["files"]
    if OR_TODAY and files and not any(file.get("upload-time") for file in files):
        raise ValueError("the index does not tell when it got its files")
    return address, files


def installs(file):
    """Tell whether it is a wheel for this Python."""
    if not file["filename"].endswith(".whl"):
        return False
    parts = file["filename"][: -len(".whl")].split("-")[-3:]
    tags = ["-".join((a, b, c)) for a in parts[0].split(".") for b in parts[1].split(".") for c in parts[2].split(".")]
    return bool(TAGS.intersection(tags))


def version(file):
    name = re.sub(r"([.]tar[.]\w+|[.]zip|[.]tgz)$", "", file["filename"])
    return name.split("-")[1] if name.endswith(".whl") else name.split("-")[-1]


def number(file):
    return [int(part) for part in re.findall(r"\d+", version(file))]


def of_day(name, files):
    """Return the files of the day; with --or-today those of the first later version where they would not do.

    They do not where there is none, and where the package is compiled but had no wheel for this Python.
    """
    dated = [file for file in files if file.get("upload-time")]
    then = [file for file in dated if file["upload-time"][:10] <= DAY]
    if not OR_TODAY or any(map(installs, then)):
        return then
    later = [file for file in dated if file["upload-time"][:10] > DAY and not file.get("yanked")]
    later.sort(key=lambda file: file["upload-time"])
    first = next((file for file in later if installs(file)), None)
    if then and (first is None or first["filename"].endswith("-none-any.whl")):
        return then
    first = first or (later[0] if later else None)
    if first is None:
        return then
    say("%s had nothing for this Python on %s: %s is the first" % (name, DAY, first["filename"]))
    return then + [file for file in later if version(file) == version(first)]


def beside(name, files):
    """Return the first files that go with a later version of what is released together with them."""
    if not OR_TODAY or not os.path.exists(TOGETHER):
        return []
    with open(TOGETHER) as table:
        others = [line.split()[1] for line in table if line.split()[:1] == [name]]
    found = []
    for other in others:
        dated = of_day(other, files_of(other)[1])
        later = [file for file in dated if file["upload-time"][:10] > DAY]
        if not later:
            continue
        least = min(map(number, later))
        fit = [file for file in files if number(file) >= least and not file.get("yanked")]
        found += [file for file in fit if number(file) == min(map(number, fit))]
        if fit:
            say("%s is taken in the version that goes with it: %s" % (name, version(found[-1])))
    return found


def free(name):
    """Tell whether pip found no version of the day for what was asked of a package."""
    if not OR_TODAY or not os.path.exists(FREE):
        return False
    with open(FREE) as names:
        return name in [re.sub("[-_.]+", "-", line.strip()).lower() for line in names]


def outdated(files):
    """Return the wheels of plain Python whose versions are older than one that has its source alone.

    Their versions have sources too. There is none where a version was ever compiled, or the newest is for other Pythons.
    """
    here = "%d.%d.%d" % sys.version_info[:3]
    wheels = [file for file in files if file["filename"].endswith(".whl")]
    sources = [file for file in files if file not in wheels and re.match(r"[0-9.]+([.]post[0-9]+)?$", version(file))]
    if not TAGS or not PREFERRED or not sources or not all(file["filename"].endswith("-none-any.whl") for file in wheels):
        return []
    newest = max(sources, key=number)
    if newest.get("yanked") or not SpecifierSet(newest.get("requires-python") or "").contains(here, True):
        return []
    if any(number(file) >= number(newest) for file in wheels):
        return []
    return [file for file in wheels if version(file) in set(map(version, sources))]


def page(name, knows_yanked):
    address, files = files_of(name)
    kept = files if free(name) else of_day(name, files) + beside(name, files)
    old = outdated(kept)
    kept = [file for file in kept if file not in old]
    names = set(file["filename"] for file in kept)
    # Where all that the day had was taken back since, the newest of it is what the code was written for
    taken_back = OR_TODAY and all(file.get("yanked") for file in kept)
    lines = []
    for file in files if OR_TODAY and knows_yanked else kept:
        link = urljoin(address, file["url"])
        if file.get("hashes", {}).get("sha256"):
            link += "#sha256=" + file["hashes"]["sha256"]
        more = ""
        if file.get("requires-python"):
            more += ' data-requires-python="%s"' % escape(file["requires-python"], True)
        if file["filename"] not in names:  # pip takes it where its exact version is asked for, and nowhere else (PEP 592)
            more += ' data-yanked="%s"' % ("an older version" if file in old else "uploaded after " + DAY)
        elif file.get("yanked") and not taken_back:
            more += ' data-yanked=""'
        lines.append('<a href="%s"%s>%s</a><br>' % (escape(link, True), more, escape(file["filename"])))
    return "<!DOCTYPE html><html><body>%s</body></html>" % "\n".join(lines)


class Handler(BaseHTTPRequestHandler):
    def do_GET(self):
        try:
            pip = re.match(r"pip/(\d+)\.(\d+)", self.headers.get("User-Agent") or "")
            knows_yanked = bool(pip) and (int(pip.group(1)), int(pip.group(2))) >= (19, 2)
            status, text = 200, page(self.path.strip("/").split("/")[-1], knows_yanked)
        except HTTPError as error:
            status, text = error.code, str(error)
        except Exception as error:
            status, text = 502, "%s: %s" % (INDEX, error)
        self.send_response(status, text.split("\n")[0][:200] if status != 200 else "OK")
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(text.encode("utf-8"))


class Server(ThreadingMixIn, HTTPServer):
    daemon_threads = True


answer = "no"
try:
    if OR_TODAY:
        files_of("pip")
    server = Server(("127.0.0.1", 0), Handler)
    answer = str(server.server_address[1])
except Exception as error:
    if not OR_TODAY:
        raise
    say("pip's packages are those of today and not of %s: %s" % (DAY, error))
with open(READY + ".new", "w") as told:
    told.write(answer)
os.rename(READY + ".new", READY)
if answer != "no":
    server.serve_forever()
PYTHON
for _ in $(seq 700); do
  if [ -s "${ready}" ]; then break; fi
  sleep 0.1
done
if [ ! -s "${ready}" ]; then
  cat /dev/shm/index-as-of.log >&2
  echo "echo 'roslab: the index of $1 cannot be served' && false"
  exit 0
fi
if command -v git-as-of >/dev/null; then git-as-of "$1"; fi
if [ "$(cat "${ready}")" = no ]; then
  rm -f "${ready}"
  exit 0
fi
echo "export PIP_INDEX_URL=http://127.0.0.1:$(cat "${ready}")/simple/ PIP_TRUSTED_HOST=127.0.0.1"
# Older Pythons know no compiled modules without the times of their sources; of pip's option, a "no" is the yes
"${python}" -c 'import sys; sys.exit(sys.version_info < (3, 7))' || echo 'export PIP_NO_COMPILE=no PYTHONDONTWRITEBYTECODE=1'
# shellcheck disable=SC2016 # for the shell that evaluates it
echo 'export no_proxy="127.0.0.1${no_proxy:+,${no_proxy}}"'
rm -f "${ready}"
if [ "${2:-}" = --or-today ]; then
  echo "INDEX_AS_OF=${free}"
  echo "source '$(command -v ask-pip-again)'"
fi
