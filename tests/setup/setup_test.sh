#!/usr/bin/env bash
# cmake/setup.sh against a package system whose lock another program holds: install_missing waits, says so once, and
# gives up in the end. apt-get, dpkg-query and sudo are stand-ins; nothing is installed.
set -euo pipefail
source_dir=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir "$place/bin" "$place/cmake"
printf '[build]\nsome-package\n' > "$place/cmake/packages.txt"
export STATE=$place/state

cat > "$place/bin/apt-get" <<'END'
#!/bin/sh
echo "$*" >> "$STATE/calls"
left=$(cat "$STATE/locked")
if [ "$left" -gt 0 ]; then
  echo $((left - 1)) > "$STATE/locked"
  echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 4711 (apt-get)" >&2
  echo "E: Unable to lock directory /var/lib/apt/lists/" >&2
  exit 100
fi
[ ! -e "$STATE/broken" ] || { echo "E: Unable to locate package some-package" >&2; exit 100; }
END
printf '#!/bin/sh\nexit 1\n' > "$place/bin/dpkg-query"
printf '#!/bin/sh\nexec "$@"\n' > "$place/bin/sudo"
chmod +x "$place/bin/"*

failed=0
expect() { # WHAT CONDITION...
  local what=$1
  shift
  "$@" || { echo "FAILED: $what" >&2; sed 's/^/    /' "$STATE/said" >&2; failed=1; }
}
# setup LOCKED: how often apt-get finds the lock held. Its exit code is in $code, what it said in $STATE/said.
setup() {
  rm -rf "$STATE"
  mkdir "$STATE"
  echo "$1" > "$STATE/locked"
  [ -z "${2:-}" ] || touch "$STATE/$2"
  code=0
  (cd "$place" && PATH=$place/bin:$PATH APT_AGAIN_S=0.01 bash -c ". '$source_dir/cmake/setup.sh'; install_missing build") \
    > "$STATE/said" 2>&1 || code=$?
}
count() { grep -c -- "$1" "$2" || true; }

setup 0
expect "a free lock: installed" test "$code" -eq 0
expect "update, then install" test "$(count '' "$STATE/calls")" -eq 2
expect "nothing is said of a lock" test "$(count lock "$STATE/said")" -eq 0

setup 3
expect "a lock that is given back: installed" test "$code" -eq 0
expect "tried until it was free" test "$(count '' "$STATE/calls")" -eq 5
expect "said once" test "$(count 'holds the lock of the package system' "$STATE/said")" -eq 1
expect "who holds it" test "$(count 'process 4711' "$STATE/said")" -eq 1

APT_WAIT_S=0 setup 1000000
expect "a lock that is kept: no success" test "$code" -eq 100
expect "says what to do" test "$(count 'run this again when it has ended' "$STATE/said")" -eq 1

setup 0 broken
expect "another failure is no lock" test "$code" -eq 100
expect "it ends at once" test "$(count '' "$STATE/calls")" -eq 1
expect "and its words are shown" test "$(count 'Unable to locate' "$STATE/said")" -eq 1
exit $failed
