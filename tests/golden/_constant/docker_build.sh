
folder="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
script="$(basename -- "${BASH_SOURCE[0]}")"

help() {
  cat <<TEXT
usage: ${script} [OPTION OF docker build ...]

Builds the image ${image} from ${dockerfile}. It takes as long as the installation
of everything the program needs; a second build only repeats what changed.

Every argument is given to \`docker build\` as it is:
  --platform linux/arm64       build for another kind of processor
  --no-cache --pull            build everything anew, on the newest base image
  --progress plain             show the whole output
  --tag NAME                   give the image one more name
  --build-arg NB_UID=\$(id -u)  make you the owner of what the image writes to volumes
                               (images of roslab; the usual user number is 1000)

${secrets[0]+Secrets of roslab.yaml: ${secrets[*]}. netrc is ~/.netrc, or the file that NETRC
names; ssh is your agent; of any other, such as pip_index, the variable PIP_INDEX holds
the value, or PIP_INDEX_FILE names a file with it.

}Start the image with docker_run.sh.
TEXT
}

# fail MESSAGE [ADVICE]
fail() {
  echo "${script}: $1${2:+$'\n'  $2}" >&2
  exit 5
}

case "${1:-}" in
  -h | --help)
    help
    exit 0
    ;;
esac

command -v docker >/dev/null ||
  fail "docker is not installed" "https://docs.docker.com/engine/install/"

if docker --version 2>/dev/null | grep -qi podman; then
  echo "${script}: docker is Podman here: it should work with Podman 5, it is not tested" >&2
elif ! version="$(docker version --format '{{.Server.Version}}' 2>&1)"; then
  fail "docker does not answer: ${version##*$'\n'}" \
    "start it (sudo systemctl start docker), and be in its group (sudo usermod -aG docker \"\$USER\", then log in again)"
elif [[ "${version}" =~ ^([0-9]+)\. ]] && ((BASH_REMATCH[1] < oldest_docker)); then
  fail "docker ${version} is too old, ${oldest_docker} or newer is needed" "https://docs.docker.com/engine/install/"
elif ((oldest_docker > 0)) && ! docker buildx version >/dev/null 2>&1; then
  fail "docker lacks its builder" "install docker-buildx-plugin (from docker.com) or docker-buildx (Debian, Ubuntu)"
fi

# A secret is a file or a variable that docker reads: its value is no word of a command
for name in ${secrets[@]+"${secrets[@]}"}; do
  variable="$(tr '[:lower:]-' '[:upper:]_' <<<"${name}")"
  file_variable="${variable}_FILE"
  file="${!file_variable:-}"
  case "${name}" in
    ssh)
      [[ -n "${SSH_AUTH_SOCK:-}" ]] ||
        fail "the secret ssh is not there" "start an agent and add your key: eval \$(ssh-agent), then ssh-add"
      options+=(--ssh default)
      continue
      ;;
    netrc) file="${NETRC:-${HOME}/.netrc}" ;;
    *)
      if [[ -n "${!variable:-}" ]]; then
        options+=(--secret "id=${name},env=${variable}")
        continue
      fi
      ;;
  esac
  [[ -f "${file}" ]] || fail "the secret ${name} is not there" "see ${script} --help"
  options+=(--secret "id=${name},\"src=${file}\"")
done

given=() # what the images below the Dockerfile's own steps need too
previous=''
for word in "$@"; do
  if [[ "${previous}" == --platform || "${word}" =~ ^--(platform(=.*)?|no-cache|pull)$ ]]; then given+=("${word}"); fi
  previous="${word}"
done
for ((i = 0; i < ${#bases[@]}; i += 2)); do
  echo "${script}: ${bases[i + 1]} is replaced by ${bases[i]} of Dockerfile.bases" >&2
  docker build --file "${folder}/Dockerfile.bases" --target "${bases[i]}" --tag "${image}-${bases[i]}" \
    ${given[@]+"${given[@]}"} "${folder}"
  options+=(--build-context "${bases[i + 1]}=docker-image://${image}-${bases[i]}")
done

exec docker build --file "${folder}/${dockerfile}" --tag "${image}" ${options[@]+"${options[@]}"} "$@" "${folder}/${context}"
