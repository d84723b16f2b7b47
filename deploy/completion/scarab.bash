# shellcheck shell=bash
# Completion of `scarab` and `deploy/scarab` for bash: what can come next is asked of the program itself.
# Load it with: source <(deploy/scarab completion bash)

_scarab() {
  local program=${COMP_WORDS[0]} current=${COMP_LINE:0:COMP_POINT} candidate
  program=${program/#\~/$HOME}
  COMPREPLY=()
  mapfile -t candidates < <("$program" __complete line "$current" 2>/dev/null)
  [ "${#candidates[@]}" -gt 0 ] || return
  # Bash completes what follows the last = or : only; the candidates are whole words.
  current=${current##*[[:space:]]}
  local before=${current%"${current##*[=:]}"}
  [[ $COMP_WORDBREAKS == *=* ]] || before=
  for candidate in "${candidates[@]%%$'\t'*}"; do
    COMPREPLY+=("${candidate#"$before"}")
  done
  # A folder, or an option that takes its value behind a =, is not the end of the word.
  case ${COMPREPLY[0]} in
    */ | *=) [ "${#COMPREPLY[@]}" -gt 1 ] || compopt -o nospace ;;
  esac
}
complete -o nosort -F _scarab scarab
