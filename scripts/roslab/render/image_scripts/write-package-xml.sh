#!/bin/bash
# usage: write-package-xml FOLDER
# Writes a package.xml in place of each manifest.xml of rosbuild below the folder, with what that one names: rosdep, given
# a folder, takes keys from package.xml alone, but stops where a manifest.xml beside it names a package that is gone.
set -euo pipefail

while IFS= read -r -d '' manifest; do
  folder="${manifest%/*}"
  {
    echo "<package format=\"2\"><name>$(basename "${folder}")</name><version>0.0.0</version><description>of rosbuild</description>"
    echo '<maintainer email="nobody@example.org">nobody</maintainer><license>unknown</license>'
    sed --quiet --regexp-extended \
      's#.*<(depend +package|rosdep +name)="([A-Za-z0-9_.+-]+)".*#<depend>\2</depend>#p' "${manifest}" | sort --unique
    echo '</package>'
  } >"${folder}/package.xml"
  rm "${manifest}"
done < <(find "$1" -name manifest.xml -print0)
