#compdef scarab
# Completion of `scarab` and `deploy/scarab` for zsh: what can come next is asked of the program itself.
# Load it with: source <(deploy/scarab completion zsh)   (after compinit)

_scarab() {
  local program=${(Q)words[1]} line
  program=${program/#\~/$HOME}
  local -a whole open notes_whole notes_open
  for line in ${(f)"$("$program" __complete words "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2>/dev/null)"}; do
    case ${line%%$'\t'*} in
      */ | *=) open+=("${line%%$'\t'*}"); notes_open+=("${line/$'\t'/  -- }") ;;
      *) whole+=("${line%%$'\t'*}"); notes_whole+=("${line/$'\t'/  -- }") ;;
    esac
  done
  compadd -l -d notes_whole -a whole
  compadd -S '' -d notes_open -a open
}
compdef _scarab scarab
