#!/bin/bash
# usage: checkout-commit FOLDER COMMIT
# Checks out the commit of a clone that a repository records. Where no branch of its remote has it any more, the remote is
# asked for it by its name; where it does not give it, the clone stays as it is, and that is said with the commit it is at.
set -euo pipefail

folder="$1" commit="$2"
take() { git -C "${folder}" -c advice.detachedHead=false checkout --quiet "$1" --; }

if take "${commit}" 2>/dev/null; then exit 0; fi
if git -C "${folder}" fetch --quiet origin "${commit}" && take "${commit}"; then exit 0; fi
at="$(git -C "${folder}" rev-parse HEAD)"
took="${at} of $(git -C "${folder}" rev-parse --abbrev-ref HEAD)"
echo "roslab: left out: $(git -C "${folder}" config --get remote.origin.url) has no ${commit} any more: ${took} is taken"
