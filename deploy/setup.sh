# shellcheck shell=bash
# Functions of deploy/demo and deploy/test: install what is missing, build quietly. To be sourced.

set -o pipefail
scarab_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
setup_log=$scarab_root/build/setup.log
build_log=$scarab_root/build/build.log

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# packages_of GROUP...: the packages of these sections of packages.txt, but for those whose command is there.
packages_of() {
  local package program
  awk -v wanted=" $* " '
    /^[ \t]*(#|$)/ { next }
    /^\[/ { section = substr($1, 2, length($1) - 2); next }
    index(wanted, " " section " ") { print $1, $2 }' "$scarab_root/deploy/packages.txt" |
    while read -r package program; do
      [ -n "$program" ] && command -v "$program" >/dev/null || echo "$package"
    done
}

# missing_packages GROUP...: those that are not installed.
missing_packages() {
  local package
  for package in $(packages_of "$@"); do
    case $(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null) in
      ?i*) ;;
      *) echo "$package" ;;
    esac
  done
}

# install_packages GROUP...: installs what is missing; as root, or with sudo.
install_packages() {
  local -a missing as_root
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" -eq 0 ] && return
  local by_hand="as root: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  command -v apt-get >/dev/null || fail "needs packages of Debian 12, and there is no apt-get here. Missing: ${missing[*]}"
  if [ "$(id -u)" -eq 0 ]; then
    as_root=(env)
  elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    as_root=(sudo env)
  else
    fail "packages are missing and can be installed neither as root nor with sudo. Please run $by_hand"
  fi
  echo "installing ${#missing[@]} packages: ${missing[*]}"
  mkdir -p "$scarab_root/build"
  run_apt "${missing[@]}" 2>&1 | tee "$setup_log" | show_progress || {
    tail -n 20 "$setup_log" >&2
    fail "apt-get failed; the whole log is $setup_log. Please run $by_hand"
  }
}

# run_apt PACKAGE...: the package lists are fetched only where they are not enough.
run_apt() {
  local -a apt=("${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -y -q
                -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
  local -a install=("${apt[@]}" install --no-install-recommends "$@")
  if "${apt[@]}" -s install --no-install-recommends "$@" >/dev/null && "${install[@]}"; then
    return
  fi
  "${apt[@]}" update && "${install[@]}"
}

# build_release CMAKE_OPTION...: configures and builds build/release with one line of progress.
build_release() {
  mkdir -p "$scarab_root/build"
  cd "$scarab_root" || exit 1
  : >"$build_log"
  [ -t 1 ] || echo "building; log: $build_log"
  cmake --preset release "$@" >>"$build_log" 2>&1 || build_failed "configuring"
  NINJA_STATUS='[%f/%t] ' cmake --build --preset release 2>&1 | tee -a "$build_log" | show_progress ||
    build_failed "building"
  echo "built: build/release/bin"
}

build_failed() {
  # The compiler's message stands before the lines of what else was being compiled.
  { grep -m 1 -A 20 -E '^(FAILED|CMake Error)' "$build_log" || tail -n 40 "$build_log"; } >&2
  fail "$1 failed; the whole log is $build_log"
}

# show_progress: how far ninja or apt-get has come, read from standard input, on one line of the terminal.
show_progress() {
  local line count
  [ -t 1 ] || { cat >/dev/null; return; }
  while IFS= read -r line; do
    case $line in
      \[*/*\]*)
        count=${line%%]*}
        printf '\r\033[Kbuilding %s ' "${count#[}" ;;
      Get:* | "Unpacking "* | "Setting up "*) printf '\r\033[K%.70s ' "$line" ;;
    esac
  done
  printf '\r\033[K'
}
