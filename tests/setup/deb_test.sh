#!/bin/bash
# The Debian package of a build, in an empty root: program, library, manual page, completion. $1: source folder,
# $2: build folder, $3: a folder of its own.
set -euo pipefail
source=$1 build=$2 work=$3
fail() { echo "deb_test: $*" >&2; exit 1; }
rm -rf "$work"
mkdir -p "$work/root"
(cd "$work" && cpack --config "$build/CPackConfig.cmake" -G DEB -B "$work/made" > "$work/cpack.log" 2>&1) || {
  cat "$work/cpack.log" >&2
  fail "cpack"
}
deb=$(echo "$work"/made/mpmstudy_*.deb)
[ -f "$deb" ] || fail "no package: $deb"
dpkg-deb --field "$deb" Depends | grep -q 'libc6.*gnuplot\|gnuplot.*libc6' || fail "$(dpkg-deb --field "$deb" Depends)"
dpkg-deb -x "$deb" "$work/root"
root=$work/root/usr
for file in bin/mpmstudy share/man/man1/mpmstudy.1 share/bash-completion/completions/mpmstudy include/libmpm/mpm.hpp; do
  [ -s "$root/$file" ] || fail "$file is missing"
done
[ "$(find "$root" -name 'libmpm.a' -o -name 'mpmConfig.cmake' | wc -l)" = 2 ] || fail "the library is not whole"
! grep -rlI "$source\|$build" "$root" || fail "files hold paths of this machine"

"$root/bin/mpmstudy" --version | grep -q "^mpmstudy [0-9.]*, commit " || fail "--version"
cd "$work"
"$root/bin/mpmstudy" run "$source/studies/examples/smoke.toml" --cells 2 -q > "$work/run.log" 2>&1 || {
  cat "$work/run.log" >&2
  fail "a study does not run"
}
"$root/bin/mpmstudy" status smoke > "$work/status.log" || fail "status"

# Every verb has its paragraph in the manual and is offered by the completion; options are those of the verb.
verbs=$("$root/bin/mpmstudy" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z][a-z-]*\) .*/\1/p')
[ "$(wc -w <<< "$verbs")" -gt 15 ] || fail "no verbs"
for verb in $verbs; do
  grep -qx "\.B $verb" "$root/share/man/man1/mpmstudy.1" || fail "the manual page lacks $verb"
done
. "$root/share/bash-completion/completions/mpmstudy"
complete_words() { COMP_WORDS=("$root/bin/mpmstudy" "$@") COMP_CWORD=$#; _mpmstudy; }
complete_words ""
for verb in $verbs; do
  [[ " ${COMPREPLY[*]} " == *" $verb "* ]] || fail "completion lacks $verb"
done
complete_words se
[ "${COMPREPLY[*]}" = sensitivity ] || fail "se -> ${COMPREPLY[*]}"
complete_words gc --d
[ "${COMPREPLY[*]}" = --dry-run ] || fail "gc --d -> ${COMPREPLY[*]}"
echo "$(basename "$deb"): $(du -h "$deb" | cut -f1)"
