# shellcheck shell=bash
# To be sourced: how Ninja is run, and what is left of what it says. $name is the paper; $ran collects the stages that began.

# run_ninja FOLDER TARGET…: prints only what the commands say, and on a terminal how far it is. V=1 in the environment shows
# the commands.
run_ninja() {
  if [[ ${V:-} == 1 ]]; then
    ninja -C "$1" -v "${@:2}"
  elif [[ -t 1 ]]; then
    NINJA_STATUS='[%f/%t] ' ninja -C "$1" "${@:2}" | without_frame
  else
    ninja -C "$1" --quiet "${@:2}" | without_frame
  fi
}

# without_frame: prints the output of a failed command without what Ninja prints around it:
#   FAILED: outputs
#   the command, one line
#   … its output …
#   ninja: build stopped: subcommand failed.
# If there is no output, because the compiler was killed, the frame is all that tells of it and stays. The paper's own stages
# have explained their failure on the terminal before their frame arrives. Each line of progress is written over the last one.
# CMake's lines about its own progress are left out.
without_frame() {
  local line place said='' over=''
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\ (.*) ]]; then
      place="${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}" line=${BASH_REMATCH[3]}
      if [[ $line != *' '* ]]; then ran+="$line "; fi
      if [[ $line =~ ^(Building|Linking|Generating)\  ]]; then line="compile   $place"; fi
      printf '\r\e[K%.*s …' "$((${COLUMNS:-80} - 3))" "$line"
      over=$'\r\e[K'
      continue
    fi
    case $line in
      'ninja: Entering directory '* | 'ninja: no work to do.' | '-- '*) continue ;;
      'FAILED: '* | 'ninja: build stopped: '*)
        if [[ -n $said ]]; then printf '%s%s\n' "$over" "$said"; fi
        said='' over=''
        if [[ $line == FAILED:* ]]; then
          said=$line
          # shellcheck disable=SC2154  # name is its user's
          if [[ $said =~ /state/[a-z]+( |$)|/$name\.html( |$)|CMakeFiles/$name(-[a-z]+)?( |$) ]]; then said=; fi
          IFS= read -r line
          said+=${said:+$'\n'$line}
        fi
        ;;
      *)
        said=
        printf '%s%s\n' "$over" "$line"
        over=
        ;;
    esac
  done
  printf '%s' "$over"
}
