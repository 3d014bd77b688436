# Completion of mpmstudy for bash. Verbs and options are those that the program itself says.
_mpmstudy() {
  local word=${COMP_WORDS[COMP_CWORD]} help
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    help=$("${COMP_WORDS[0]}" --help 2>/dev/null | sed -n '/^Subcommands:/,$ s/^  \([a-z][a-z-]*\) .*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "$help --help --version" -- "$word")
  elif [[ $word == -* ]]; then
    help=$("${COMP_WORDS[0]}" "${COMP_WORDS[1]}" --help 2>/dev/null | grep -oE -- '--[a-z][a-z-]*' | sort -u)
    mapfile -t COMPREPLY < <(compgen -W "$help" -- "$word")
  fi
}
complete -o default -F _mpmstudy mpmstudy
