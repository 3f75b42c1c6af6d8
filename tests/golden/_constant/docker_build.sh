
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

Start the image with docker_run.sh.
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

exec docker build --file "${folder}/${dockerfile}" --tag "${image}" ${options[@]+"${options[@]}"} "$@" "${folder}/${context}"
