#!/bin/sh
# setup and require, tried with a fake dpkg-query and a fake apt-get.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"

if ! [ -e /etc/debian_version ]; then
  echo 'not a Debian system, nothing to pretend on'
  exit 0
fi

tools=$scratch/src/toolchain
mkdir -p "$tools" "$scratch/debian" "$scratch/elsewhere"
cp "$source_dir/src/toolchain/setup" "$source_dir/src/toolchain/require" \
  "$source_dir/src/toolchain/missing" "$tools"
mkdir -p "$scratch/src/literate/scripts"
cp "$source_dir/src/literate/scripts/stage.sh" "$scratch/src/literate/scripts"
cat >"$tools/packages.txt" <<'END'
# a comment
libone-dev   report   -          # there
libtwo-dev   report   -          # not there
shell        report   sh         # not a package, but a command that is there
libtest-dev  test     -          # not there
libtidy-dev  tidy     -          # not there
END

# The scripts under test find only these commands.
for command in sh awk cut dirname date id env cat; do
  ln -s "$(command -v $command)" "$scratch/debian/$command"
  ln -s "$(command -v $command)" "$scratch/elsewhere/$command"
done
cat >"$scratch/debian/dpkg-query" <<'END'
#!/bin/sh
echo asked >>"$LOG"
cat "$INSTALLED"
END
cat >"$scratch/debian/apt-get" <<'END'
#!/bin/sh
echo "apt-get $*" >>"$LOG"
if [ -n "${BROKEN:-}" ]; then echo "E: $BROKEN" >&2; exit 100; fi
END
cat >"$scratch/debian/sudo" <<'END'
#!/bin/sh
exec "$@"
END
chmod +x "$scratch/debian/dpkg-query" "$scratch/debian/apt-get" "$scratch/debian/sudo"
export INSTALLED="$scratch/installed" LOG="$scratch/log"

on() { # on SYSTEM SCRIPT [ARGUMENT…], SYSTEM being a folder of commands
  system=$1 script=$2
  shift 2
  : >"$LOG"
  runs env PATH="$scratch/$system" sh "$tools/$script" "$@"
}
asked_dpkg() { grep -c '^asked' "$LOG"; }
asked_apt() { grep -c '^apt-get' "$LOG"; }

# Everything installed
printf '%s installed\n' libone-dev libtwo-dev libtest-dev >"$INSTALLED"
on debian setup
claim 'setup succeeds when nothing is missing' "$status" -eq 0
claim 'setup asks dpkg once' "$(asked_dpkg)" -eq 1
claim 'setup leaves apt alone when nothing is missing' "$(asked_apt)" -eq 0
on debian require report test
claim 'require is content' "$status" -eq 0
claim 'require is silent' -z "$said"

# Two missing, one of them half-removed
printf '%s\n' 'libone-dev installed' 'libtwo-dev config-files' >"$INSTALLED"
on debian setup
claim 'setup succeeds when apt does' "$status" -eq 0
claim 'the lists are fetched first' "$(sed -n '/^apt-get/{p;q;}' "$LOG")" = \
  'apt-get -q -o DPkg::Lock::Timeout=120 update'
claim 'exactly the missing packages are installed' "$(tail -n 1 "$LOG")" = \
  'apt-get -q -o DPkg::Lock::Timeout=120 install --yes --no-install-recommends libtwo-dev libtest-dev'
on debian require report
claim 'require fails' "$status" -ne 0
claim 'require names what the stage lacks, and the command' "$(says 'missing: libtwo-dev — run "make setup"')" = yes
claim 'require does not name what another stage lacks' "$(says libtest-dev)" = no
on debian require tidy
claim 'the command for tidy installs tidy' "$(says 'make setup STAGES=tidy')" = yes

# apt-get fails
export BROKEN='Unable to locate package libtwo-dev'
on debian setup
claim 'setup fails when apt does' "$status" -ne 0
claim "apt's message is shown" "$(says "E: $BROKEN")" = yes
unset BROKEN

# Neither root nor sudo
rm "$scratch/debian/sudo" "$scratch/debian/id"
printf '#!/bin/sh\necho 1000\n' >"$scratch/debian/id"
chmod +x "$scratch/debian/id"
on debian setup
claim 'setup fails without rights' "$status" -ne 0
claim 'setup tells the command' \
  "$(says 'apt-get install --no-install-recommends libtwo-dev libtest-dev')" = yes
claim 'nothing is tried without rights' "$(asked_apt)" -eq 0

# Another system
on elsewhere setup
claim 'setup fails where there is no apt-get' "$status" -ne 0
claim 'setup lists what to install, with reasons' "$(says 'libtwo-dev                 not there')" = yes
on elsewhere require report
claim 'without dpkg libraries are left to CMake' "$status" -eq 0

finish
