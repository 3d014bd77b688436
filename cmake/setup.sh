# What reproduce.sh and test.sh share: packages and build. Source it from the top of the tree.
set -euo pipefail

say() { printf '\n== %s\n' "$*"; }

# packages SECTION...: names of cmake/packages.txt in these sections.
packages() {
  local wanted=" $* " section="" line
  while read -r line; do
    case $line in
      '' | '#'*) ;;
      '['*']') section=${line:1:-1} ;;
      *) [[ $wanted == *" $section "* ]] && echo "$line" ;;
    esac
  done < cmake/packages.txt
  return 0
}

# apt_get ARGUMENT...: apt-get as root. While another program holds a lock of the package system (unattended upgrades
# do, after a start), it says so once and tries again for APT_WAIT_S seconds: apt-get itself waits for the lock of dpkg
# only, not for those of its lists and archives.
apt_get() {
  local as_root=() errors code until=$((SECONDS + ${APT_WAIT_S:-900})) said=
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  errors=$(mktemp)
  while true; do
    code=0
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -o DPkg::Lock::Timeout=10 "$@" 2> "$errors" || code=$?
    if [ $code -eq 0 ] || ! grep -qE 'Could not get lock|Unable to (acquire|lock)' "$errors"; then break; fi
    if [ $SECONDS -ge $until ]; then
      echo "another program still holds the lock of the package system; run this again when it has ended" >&2
      break
    fi
    [ -n "$said" ] || { echo "another program holds the lock of the package system; waiting for it, ${APT_WAIT_S:-900} s at most:" >&2
                        grep -E 'Could not get lock' "$errors" >&2 || true; }
    said=yes
    sleep "${APT_AGAIN_S:-5}"
  done
  cat "$errors" >&2
  rm -f "$errors"
  return $code
}

# install_missing SECTION...: installs what dpkg does not know as installed; asks for nothing if all is there.
install_missing() {
  command -v apt-get > /dev/null || { echo "this script installs with apt-get (Debian, Ubuntu); install by hand: $(packages "$@" | tr '\n' ' ')" >&2; return 1; }
  local missing=() package
  for package in $(packages "$@"); do
    dpkg-query -W -f '${Status}' "$package" 2> /dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  say "installing ${missing[*]}"
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo > /dev/null; then
    echo "as root: apt-get install ${missing[*]}" >&2
    return 1
  fi
  apt_get update -qq || return
  apt_get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
}

# build PRESET [cmake option...]
build() {
  local preset=$1
  shift
  say "building (preset $preset)"
  cmake --preset "$preset" "$@" > /dev/null
  cmake --build --preset "$preset"
}
