#!/bin/bash
# usage: eval "$(index-as-of DAY)"
# Gives every pip of this step, whatever its version, the index as it was at the end of a day (UTC): a server that lasts as
# long as the step leaves out each file that the index got later. The index must tell when (PEP 700, as PyPI does).
set -euo pipefail

python="$(command -v python3 || command -v python2 || command -v python || true)"
if [ -z "${python}" ]; then
  echo "roslab: there is no Python yet to ask the index: pip's packages are those of today" >&2
  exit 0
fi
# Where nothing is configured, pip's own index
usual='
try: from pip._internal.models.index import PyPI
except ImportError: from pip.models.index import PyPI
print(PyPI.simple_url)'
index="${PIP_INDEX_URL:-$("${python}" -m pip config get global.index-url 2>/dev/null || "${python}" -c "${usual}")}"
ready="$(mktemp)"
"${python}" - "$1" "${index%/}/" "${ready}" <<'PYTHON' >/dev/null 2>/dev/shm/index-as-of.log &
import json
import os
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

DAY, INDEX, READY = sys.argv[1:]
JSON = "application/vnd.pypi.simple.v1+json"


def page(name):
    address = urljoin(INDEX, name + "/")
    answer = urlopen(Request(address, headers={"Accept": JSON}), timeout=60)
    if JSON not in answer.headers.get("Content-Type", ""):
        raise ValueError("the index does not tell when it got its files")
    lines = []
    for file in json.loads(answer.read().decode("utf-8"))["files"]:
        if not file.get("upload-time") or file["upload-time"][:10] > DAY:
            continue
        link = urljoin(address, file["url"])
        if file.get("hashes", {}).get("sha256"):
            link += "#sha256=" + file["hashes"]["sha256"]
        more = ""
        if file.get("requires-python"):
            more += ' data-requires-python="%s"' % escape(file["requires-python"], True)
        if file.get("yanked"):
            more += ' data-yanked=""'
        lines.append('<a href="%s"%s>%s</a><br>' % (escape(link, True), more, escape(file["filename"])))
    return "<!DOCTYPE html><html><body>%s</body></html>" % "\n".join(lines)


class Handler(BaseHTTPRequestHandler):
    def do_GET(self):
        try:
            status, text = 200, page(self.path.strip("/").split("/")[-1])
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


server = Server(("127.0.0.1", 0), Handler)
with open(READY + ".new", "w") as told:
    told.write(str(server.server_address[1]))
os.rename(READY + ".new", READY)
server.serve_forever()
PYTHON
for _ in $(seq 100); do
  if [ -s "${ready}" ]; then break; fi
  sleep 0.1
done
if [ ! -s "${ready}" ]; then
  cat /dev/shm/index-as-of.log >&2
  echo "echo 'roslab: the index of $1 cannot be served' && false"
  exit 0
fi
echo "export PIP_INDEX_URL=http://127.0.0.1:$(cat "${ready}")/simple/ PIP_TRUSTED_HOST=127.0.0.1"
# Older Pythons know no compiled modules without the times of their sources; of pip's option, a "no" is the yes
"${python}" -c 'import sys; sys.exit(sys.version_info < (3, 7))' || echo 'export PIP_NO_COMPILE=no PYTHONDONTWRITEBYTECODE=1'
# shellcheck disable=SC2016 # for the shell that evaluates it
echo 'export no_proxy="127.0.0.1${no_proxy:+,${no_proxy}}"'
rm -f "${ready}"
