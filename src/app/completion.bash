#compdef halfspace
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for bash, and for zsh by its bashcompinit: commands, flags and choices as the help lists them.
[ -z "$ZSH_VERSION" ] || { autoload -U +X bashcompinit && bashcompinit; }
_halfspace() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} flag=${COMP_WORDS[COMP_CWORD-1]} type words
  if [ "$COMP_CWORD" = 1 ]; then
    words="$(halfspace --help | sed -n '/^Commands:/,/^$/s/^  \([a-z-]*\) .*/\1/p') --help --version"
  else
    type=$(halfspace "$command" --help 2>/dev/null | sed -n "s/^  \(.*,\)*$flag\(,[^ ]*\)* \([^ ]*\).*/\3/p")
    case $type in
      FILE) compopt -o filenames; COMPREPLY=($(compgen -f -- "$word")); return ;;
      *'|'*) words=$(printf %s "$type" | tr '|' ' ') ;;
      '') words=$(halfspace "$command" --help 2>/dev/null | sed -n 's/^  \(-h,\)*\(--[a-z0-9-]*\).*/\2/p') ;;
    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -F _halfspace halfspace
