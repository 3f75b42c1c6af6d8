
folder="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
script="$(basename -- "${BASH_SOURCE[0]}")"
repository="${folder}/${context}"
mode=plain
network=bridge
private=''     # a folder that only this user can enter, with the key of the display
own_volumes=() # of the command line: HOST:CONTAINER[:OPTIONS]
options=()     # of the command line, for docker run
arguments=(run --rm --init)

help() {
  cat <<TEXT
usage: ${script} [OPTION ...] [--] [COMMAND [ARGUMENT ...]]

Runs the image ${image}. Without COMMAND it runs what the repository is about:
  ${default_command}

  --notebook       open JupyterLab, on this machine only and behind a token; prints the address
                   (in this image: ${notebook})
  --shell          open a shell in the container
  --volume HOST:CONTAINER[:ro]
                   let the container see a folder of this machine; one that roslab.yaml
                   gives the same CONTAINER is replaced
  --gui, --no-gui  show windows on this screen, or do not (here: ${gui})
  --gpu, --no-gpu  use the NVIDIA graphics card, or do not (here: ${gpu})
  --option WORD    one more word for \`docker run\`: --option --network=host
  --help           this text

Write -- before a COMMAND that begins with a dash. Files written to the container are
gone when it ends, unless they are in a volume.

environment:
  ROSLAB_IMAGE     run another image, for example the published one by its digest:
                   ROSLAB_IMAGE=ghcr.io/OWNER/NAME@sha256:... ./${script}
TEXT
  local i
  if ((${#volumes[@]})); then printf '\nvolumes:\n'; fi
  for ((i = 0; i < ${#volumes[@]}; i += 3)); do
    printf '  %s at %s %s\n' "${volumes[i]}" "${volumes[i + 1]}" "${volumes[i + 2]}"
  done
  if ((${#ports[@]})); then
    printf '\nports:\n'
    printf '  %s\n' "${ports[@]}"
  fi
}

say() {
  printf '%s: %s\n' "${script}" "$1" >&2
}

# fail CODE MESSAGE: 2 for what the caller can write otherwise, 5 for docker
fail() {
  say "$2"
  exit "$1"
}

need_value() {
  if (($2 < 2)); then fail 2 "$1 needs a value; ${script} --help explains it"; fi
}

# ---- volumes ----

# Folders of the system or of the whole home: no repository has to see them. Whoever wants it says so with --volume.
too_much() {
  local top="${1#/}"
  case "/${top%%/*}" in
    / | /bin | /boot | /dev | /etc | /lib | /lib32 | /lib64 | /proc | /sbin | /sys) return 0 ;;
  esac
  case "$1" in
    /home | /root | /run | /run/user* | /usr | /usr/bin* | /usr/lib | /usr/local | /var | /var/lib/docker*) return 0 ;;
    "${HOME}"/.cache* | "${HOME}"/.gazebo* | "${HOME}"/.ros*) return 1 ;; # models and logs, which roslab.yaml may want
    "${HOME}" | "${HOME}"/.*) return 0 ;;
    *) [[ -S "$1" ]] ;; # docker's own socket, an agent's
  esac
}

# A path of roslab.yaml: ~ and $HOME are this user's home, a relative one begins at the repository.
host_path() {
  local path="$1"
  case "${path}" in
    \~ | \~/*) path="${HOME}${path#\~}" ;;
    \$HOME | \$HOME/*) path="${HOME}${path#\$HOME}" ;;
    \$\{HOME\} | \$\{HOME\}/*) path="${HOME}${path#\$\{HOME\}}" ;;
    \$PWD | \$PWD/*) path="${repository}${path#\$PWD}" ;;
    \$\{PWD\} | \$\{PWD\}/*) path="${repository}${path#\$\{PWD\}}" ;;
  esac
  if [[ "${path}" != /* ]]; then path="${repository}/${path}"; fi
  printf '%s' "${path}"
}

# The path without links, so that `data -> /etc` in a repository is seen for what it is
real_path() {
  if [[ -d "$1" ]]; then
    (CDPATH='' cd -P -- "$1" && pwd -P)
  else
    printf '%s/%s' "$(CDPATH='' cd -P -- "$(dirname -- "$1")" && pwd -P)" "$(basename -- "$1")"
  fi
}

replaced() {
  local i rest
  for ((i = 0; i < ${#own_volumes[@]}; i++)); do
    rest="${own_volumes[i]#*:}"
    if [[ "${rest%%:*}" == "$1" ]]; then return 0; fi
  done
  return 1
}

is_made() {
  local each
  for each in ${made[@]+"${made[@]}"}; do
    if [[ "${each}" == "$1" ]]; then return 0; fi
  done
  return 1
}

add_volumes() {
  local i host real target writable=no
  for ((i = 0; i < ${#own_volumes[@]}; i++)); do
    host="${own_volumes[i]%%:*}"
    target="${own_volumes[i]#*:}"
    if [[ "${own_volumes[i]}" != ?*:/* ]]; then fail 2 "--volume ${own_volumes[i]}: write HOST:CONTAINER, where CONTAINER begins with /"; fi
    if [[ ! -e "${host}" ]]; then fail 2 "--volume ${own_volumes[i]}: there is no ${host}"; fi
    arguments+=(--volume "$(real_path "${host}"):${target}")
    if [[ "${target}" != *:*ro* ]]; then writable=yes; fi
  done
  for ((i = 0; i < ${#volumes[@]}; i += 3)); do
    target="${volumes[i + 1]}"
    if replaced "${target}"; then continue; fi
    host="$(host_path "${volumes[i]}")"
    if [[ ! -e "${host}" ]] && is_made "${target}"; then mkdir -p -- "${host}"; fi
    if [[ ! -e "${host}" ]]; then
      fail 2 "roslab.yaml wants ${volumes[i]} at ${target} in the container, and there is no ${host} here: make it, or give another folder with --volume FOLDER:${target}"
    fi
    real="$(real_path "${host}")"
    if too_much "${real}"; then
      fail 2 "roslab.yaml wants ${volumes[i]} in the container, which is ${real}: a repository gets no folder of the system; if you trust it, say --volume ${real}:${target}"
    fi
    say "the container sees ${real} at ${target}${volumes[i + 2]:+ (${volumes[i + 2]})}"
    arguments+=(--volume "${real}:${target}${volumes[i + 2]:+:${volumes[i + 2]}}")
    if [[ ",${volumes[i + 2]}," != *,ro,* ]]; then writable=yes; fi
  done
  case "${writable}-$(uname -s)-$(id -u)" in
    no-* | *-Darwin-* | *-0 | *-"${image_user:-0}") ;;
    *) say "in a volume the container is user ${image_user}, and you are $(id -u): build with docker_build.sh --build-arg NB_UID=$(id -u) where it has to write there" ;;
  esac
}

# ---- screen and graphics card ----

make_private() {
  private="$(mktemp -d "${XDG_RUNTIME_DIR:-${TMPDIR:-/tmp}}/roslab.XXXXXXXX")"
  trap 'rm -rf -- "${private}"' EXIT
}

# The key of the X server, for a program of another host name: the family FFFF of an entry means any host.
add_cookie() {
  local source="${XAUTHORITY:-${HOME}/.Xauthority}"
  make_private
  : >"${private}/Xauthority"
  if command -v xauth >/dev/null; then
    xauth nlist "${DISPLAY}" 2>/dev/null | sed 's/^..../ffff/' | xauth -q -f "${private}/Xauthority" nmerge - 2>/dev/null || true
  elif [[ -r "${source}" ]]; then
    cat -- "${source}" >"${private}/Xauthority" # its entries name this host: so does the container
    if [[ "${network}" != host ]]; then arguments+=(--hostname "$(uname -n)"); fi
  fi
  # The image's user is not always this one and must read it; on this machine the folder lets nobody else in.
  chmod 644 "${private}/Xauthority"
  arguments+=(--volume "${private}/Xauthority:/run/roslab/Xauthority:ro" --env XAUTHORITY=/run/roslab/Xauthority)
}

# Docker would name it by hexadecimal digits: what calls a ROS namespace or a node after its host must begin with a letter.
add_host_name() {
  case " ${arguments[*]} ${options[*]+${options[*]}} " in
    *' --hostname'* | *' -h '* | *' --uts'* | *[=\ ]container:*) return ;;
  esac
  if [[ "${network}" != host ]]; then arguments+=(--hostname roslab); fi
}

add_x11() {
  local number socket
  number="${DISPLAY##*:}"
  number="${number%%.*}"
  case "${DISPLAY}" in
    :* | unix:*)
      socket="/tmp/.X11-unix/X${number}"
      if [[ ! -S "${socket}" ]]; then
        say "DISPLAY is ${DISPLAY}, but nothing listens at ${socket}: no X11 windows"
        return 1
      fi
      arguments+=(--volume "${socket}:${socket}:ro" --env "DISPLAY=:${number}")
      ;;
    *) # over ssh -X the display is a port of this machine
      use_host_network
      arguments+=(--env "DISPLAY=${DISPLAY}")
      ;;
  esac
  arguments+=(--env QT_X11_NO_MITSHM=1) # its shared memory ends at the container's border
  add_cookie
}

add_wayland() {
  local socket="${WAYLAND_DISPLAY}"
  if [[ "${socket}" != /* ]]; then socket="${XDG_RUNTIME_DIR:-/run/user/$(id -u)}/${socket}"; fi
  if [[ ! -S "${socket}" ]]; then
    say "WAYLAND_DISPLAY is ${WAYLAND_DISPLAY}, but nothing listens at ${socket}: no Wayland windows"
    return 1
  fi
  if [[ "$(id -u)" != "${image_user:-$(id -u)}" ]]; then
    say "Wayland's socket is open to user $(id -u) alone, and the image's user is ${image_user}: only X11 windows"
    return 1
  fi
  local user="${image_user:-0}"
  arguments+=(--tmpfs "/run/user/${user}:mode=0700,uid=${user},gid=${user}")
  arguments+=(--volume "${socket}:/run/user/${user}/wayland-0")
  arguments+=(--env "XDG_RUNTIME_DIR=/run/user/${user}" --env WAYLAND_DISPLAY=wayland-0)
}

add_screen() {
  local shown=no device
  if [[ "$(uname -s)" != Linux ]]; then
    say "windows are shown on Linux only: --notebook works everywhere"
    return
  fi
  if [[ -n "${DISPLAY:-}" ]] && add_x11; then shown=yes; fi
  if [[ -n "${WAYLAND_DISPLAY:-}" ]] && add_wayland; then shown=yes; fi
  if [[ "${shown}" == no ]]; then
    say "there is no screen here (neither DISPLAY nor WAYLAND_DISPLAY leads to one): a program that opens a window will fail"
  elif [[ -d /dev/dri ]]; then
    arguments+=(--device /dev/dri)
    for device in /dev/dri/*; do
      if [[ -c "${device}" ]]; then arguments+=(--group-add "$(stat -c %g "${device}")"); fi
    done
  fi
}

add_graphics_card() {
  if [[ "${gpu}" != forced ]] && ! docker info --format '{{json .Runtimes}}{{json .CDISpecDirs}}' 2>/dev/null | grep -q nvidia &&
    ! command -v nvidia-container-cli >/dev/null && ! command -v nvidia-container-runtime-hook >/dev/null; then
    say "the NVIDIA Container Toolkit is not installed, so the container has no NVIDIA card: https://docs.nvidia.com/datacenter/cloud-native/container-toolkit/latest/install-guide.html"
    say "going on without; --no-gpu silences this, --gpu insists"
    return
  fi
  arguments+=(--gpus all --env NVIDIA_VISIBLE_DEVICES=all --env NVIDIA_DRIVER_CAPABILITIES=all)
}

# ---- network ----

use_host_network() {
  if [[ "${network}" != host ]]; then arguments+=(--network host); fi
  network=host
}

add_ports() {
  local i
  if [[ "${network}" == host ]]; then return; fi
  for ((i = 0; i < ${#ports[@]}; i++)); do arguments+=(--publish "${ports[i]}"); done
}

taken() {
  (exec 3<>"/dev/tcp/127.0.0.1/$1") 2>/dev/null
}

# JupyterLab gives a shell to whoever reaches it: it is published on this machine's own address, and asks for a token
# that is made anew each time. The token goes by the environment: the arguments of a program are everybody's to read.
add_notebook() {
  local port=8888 address=0.0.0.0
  while taken "${port}"; do
    port=$((port + 1))
    if ((port > 8987)); then fail 5 "no free port from 8888 to 8987"; fi
  done
  JUPYTER_TOKEN="$(od -An -N24 -tx1 /dev/urandom | tr -d ' \n')"
  export JUPYTER_TOKEN
  arguments+=(--env JUPYTER_TOKEN)
  if [[ "${network}" == host ]]; then
    address=127.0.0.1
  else
    arguments+=(--publish "127.0.0.1:${port}:${port}")
  fi
  if [[ -f "${folder}/README.ipynb" ]]; then
    arguments+=(--volume "${folder}/README.ipynb:/run/roslab/README.ipynb:ro")
  fi
  # The image holds the notebook where it lay in the repository when that was built; else it gets this copy
  # shellcheck disable=SC2016 # the container's shell expands it
  command=(sh -c '[ -e README.ipynb ] || cp /run/roslab/README.ipynb . 2>/dev/null || true; exec "$@"' sh
    jupyter lab "--ip=${address}" "--port=${port}" --no-browser)
  echo "JupyterLab: http://127.0.0.1:${port}/lab/tree/README.ipynb?token=${JUPYTER_TOKEN}"
}

# start_in_place WORD ...: in place of an entry point that would not start it
start_in_place() {
  arguments+=(--entrypoint "$1")
  command=("${@:2}")
}

# ---- the command line ----

while (($#)); do
  case "$1" in
    -h | --help)
      help
      exit 0
      ;;
    --notebook | --shell) mode="${1#--}" ;;
    --gui | --no-gui) if [[ "$1" == --gui ]]; then gui=yes; else gui=no; fi ;;
    --gpu | --no-gpu) if [[ "$1" == --gpu ]]; then gpu=forced; else gpu=no; fi ;;
    --volume | -v)
      need_value "$1" $#
      own_volumes+=("$2")
      shift
      ;;
    --volume=*) own_volumes+=("${1#*=}") ;;
    --option)
      need_value "$1" $#
      options+=("$2")
      shift
      ;;
    --option=*) options+=("${1#*=}") ;;
    --)
      shift
      break
      ;;
    -*) fail 2 "$1 is no option of this script: ${script} --help lists them; write -- before a command that begins with a dash" ;;
    *) break ;;
  esac
  shift
done
command=("$@")

command -v docker >/dev/null || fail 5 "docker is not installed: https://docs.docker.com/engine/install/"
if ! answer="$(docker version --format '{{.Server.Version}}' 2>&1)"; then
  fail 5 "docker does not answer: ${answer##*$'\n'}"
fi
if [[ -n "${ROSLAB_IMAGE:-}" ]]; then
  image="${ROSLAB_IMAGE}"
elif docker image inspect "${image}" >/dev/null 2>&1; then
  arguments+=(--pull never) # never somebody else's image of that name
else
  fail 5 "there is no image ${image} here: run docker_build.sh first, or name a published one in ROSLAB_IMAGE"
fi
case " ${options[*]+${options[*]}} " in
  *' --network=host '* | *' --network host '* | *' --net=host '* | *' --net host '*) network=host ;;
esac

# A terminal where both ends are one; else input only where something was piped in
if [[ -t 0 && -t 1 ]]; then
  arguments+=(--interactive --tty)
elif [[ -p /dev/stdin || -f /dev/stdin ]]; then
  arguments+=(--interactive)
fi
add_volumes
if [[ -n "${matlab}" ]]; then
  if [[ -d "${matlab}" ]]; then
    arguments+=(--volume "${matlab}:${matlab}:ro")
    if [[ -n "${mac_address}" ]]; then arguments+=(--mac-address "${mac_address}"); fi
  else
    say "there is no MATLAB at ${matlab}, and it is never part of an image: going on without"
  fi
fi
if [[ "${gui}" == yes ]]; then add_screen; fi
if [[ "${gpu}" != no ]]; then add_graphics_card; fi
add_ports
add_host_name
case "${mode}" in
  notebook)
    if ((${#command[@]})); then fail 2 "--notebook takes no command"; fi
    if [[ "${notebook}" == no ]]; then fail 2 "the image has no JupyterLab: write \`notebook: true\` in roslab.yaml and build it again"; fi
    add_notebook
    if [[ "${entrypoint_takes}" != commands ]]; then start_in_place "${command[@]}"; fi
    ;;
  shell)
    if ((${#command[@]})); then fail 2 "--shell takes no command"; fi
    command=(bash)
    if [[ "${entrypoint_takes}" != commands ]]; then start_in_place bash; fi
    ;;
  *)
    if ((${#command[@]} == 0 && ${#given[@]})); then
      command=("${given[@]}")
      if [[ "${own_entrypoint}" == no ]]; then start_in_place "${given[@]}"; fi
    elif ((${#command[@]})) && [[ "${entrypoint_takes}" == nothing ]]; then
      start_in_place "${command[@]}"
    fi
    ;;
esac

# Older shells take an empty list for a missing one: hence the form with +
arguments+=(${options[@]+"${options[@]}"} "${image}" ${command[@]+"${command[@]}"})
if [[ -z "${private}" ]]; then exec docker "${arguments[@]}"; fi
status=0
docker "${arguments[@]}" || status=$? # not exec: the key is removed afterwards
exit "${status}"
