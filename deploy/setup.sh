#!/usr/bin/env bash
# Installs the Debian 12 packages that Skein needs, and nothing if they are there already (then it needs no network).
#
# usage: deploy/setup.sh [build|check|container|figures]
#   what to set up for: to build and run (default), to run the tests too, to run those in containers as well, or to draw
#   the figures of docs/figures. With SKEIN_ENGINE=docker, containers need no engine of Debian's.
set -euo pipefail

build_packages=(
  g++ cmake ninja-build pkg-config
  libfastrtps-dev libfastcdr-dev fastddsgen default-jre-headless # DDS; the generator of wire structs runs on Java
  libeigen3-dev libsleef-dev librandom123-dev libfcl-dev libassimp-dev zlib1g-dev libzstd-dev libyaml-cpp-dev
  libspdlog-dev libfmt-dev libcli11-dev nlohmann-json3-dev libncurses-dev
)
check_packages=(libgtest-dev libgmock-dev libbenchmark-dev clang-format-14 binutils python3 tmux nodejs npm ccache gnuplot-nox
  clang-14 clang-tidy-14 libclang-rt-14-dev # sanitizers and libFuzzer
  cyclonedds-dev cyclonedds-tools) # a second vendor attaches
container_packages=(python3 iptables iproute2 util-linux libfaketime) # faults are injected from outside
if [[ ${SKEIN_ENGINE:-podman} == podman ]]; then
  container_packages+=(podman runc containernetworking-plugins golang-github-containernetworking-plugin-dnsname
    podman-compose mmdebstrap)
fi
figures_packages=(gnuplot-nox)

purpose=${1:-build}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
log=$root/build/setup.log

say() { printf 'setup: %s\n' "$*"; }
fail() {
  printf 'setup: %s\n' "$*" >&2
  exit 1
}

is_installed() { [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }

# Any Java will do for the generator, and any node and npm to read recordings with.
is_there() {
  is_installed "$1" && return
  case $1 in
    default-jre-headless) java -version ;;
    nodejs) node --version ;;
    npm) npm --version ;;
    *) false ;;
  esac >/dev/null 2>&1
}

list_missing() {
  missing=()
  local package
  for package in "${packages[@]}"; do
    is_there "$package" || missing+=("$package")
  done
}

# apt-cache takes an unknown name for a pattern, so the answer must begin with the name itself.
has_candidate() { [[ $(LC_ALL=C apt-cache policy "$1" 2>/dev/null) == "$1:"*'Candidate: '[0-9]* ]]; }

# Prints those of the missing packages that the lists do not offer.
list_unknown() {
  local package
  for package in "${missing[@]}"; do
    has_candidate "$package" || printf '%s ' "$package"
  done
}

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -y -q -o DPkg::Lock::Timeout=120 \
    -o Acquire::Retries=2 -o Acquire::http::Timeout=30 "$@" >>"$log" 2>&1 </dev/null
}

install_missing() { apt install --no-install-recommends --no-remove "${missing[@]}"; }

case $purpose in
  build) packages=("${build_packages[@]}") ;;
  check) packages=("${build_packages[@]}" "${check_packages[@]}") ;;
  container) packages=("${build_packages[@]}" "${check_packages[@]}" "${container_packages[@]}") ;;
  figures) packages=("${build_packages[@]}" "${figures_packages[@]}") ;;
  *) fail "unknown purpose '$purpose'; allowed: build, check, container, figures" ;;
esac

system=$(. /etc/os-release 2>/dev/null && printf '%s %s' "${ID:-unknown}" "${VERSION_ID:-}") || system=unknown
[[ $system == 'debian 12' ]] || fail "this system is '$system'; Skein is set up on Debian 12 only"

list_missing
if ((${#missing[@]} == 0)); then
  say "all ${#packages[@]} packages are there"
  exit 0
fi

if ((EUID == 0)); then
  as_root=()
elif command -v sudo >/dev/null; then
  as_root=(sudo)
else
  fail "root or sudo is needed to install: ${missing[*]}"
fi

mkdir -p "$root/build"
: >"$log"
say "installing ${#missing[@]} of ${#packages[@]} packages (log: $log): ${missing[*]}"
if [[ -n $(list_unknown) ]] || ! install_missing; then
  say "reading the package lists again"
  apt update || true # a broken list of a third party need not matter; what cannot be had is found below
  unknown=$(list_unknown)
  [[ -z $unknown ]] || fail "no source offers: ${unknown% }; check the network and /etc/apt/sources.list (log: $log)"
  install_missing || fail "could not install: ${missing[*]}; apt's reason is in $log"
fi
list_missing
((${#missing[@]} == 0)) || fail "still missing after the installation: ${missing[*]}; see $log"
say "done"
