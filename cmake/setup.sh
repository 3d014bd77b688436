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

# install_missing SECTION...: installs what dpkg does not know as installed; asks for nothing if all is there.
install_missing() {
  command -v apt-get > /dev/null || { echo "this script installs with apt-get (Debian, Ubuntu); install by hand: $(packages "$@" | tr '\n' ' ')" >&2; return 1; }
  local missing=() package
  for package in $(packages "$@"); do
    dpkg-query -W -f '${Status}' "$package" 2> /dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  say "installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null || { echo "as root: apt-get install ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
}

# build PRESET [cmake option...]
build() {
  local preset=$1
  shift
  say "building (preset $preset)"
  cmake --preset "$preset" "$@" > /dev/null
  cmake --build --preset "$preset"
}
