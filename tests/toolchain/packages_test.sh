#!/bin/sh
# setup, missing and require, tried with a fake apt and a fake dpkg.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"

if ! [ -e /etc/debian_version ]; then
  echo 'skipped: this is no Debian, nothing to pretend on'
  exit 77
fi

tools=$scratch/src/toolchain
mkdir -p "$tools" "$scratch/debian" "$scratch/elsewhere"
cp "$source_dir/src/toolchain/setup" "$source_dir/src/toolchain/require" \
  "$source_dir/src/toolchain/missing" "$tools"
mkdir -p "$scratch/src/literate/scripts"
cp "$source_dir/src/literate/scripts/stage.sh" "$scratch/src/literate/scripts"
cat >"$tools/packages.txt" <<'END'
# a comment
report why:    build
test:          build tests [block]
test-all:      build tests [block]
page:          build page
paper:         build tex

= libraries
libone-dev     build  -      # One 1.2 [there]
libtwo-dev     build  -      # Two 2.3 [not there]
shell          build  sh     # a shell [not a package, but a command that is there]

= tests
libtest-dev    tests  -      # Test [not there]
old-test|new-test  tests  -  # Tester
solver         block  slv    # a solver
poppler        page   pdfto  # Poppler

= TeX
tex-large/nice tex    nice.sty  # nice
END

# The scripts under test find only these commands.
for command in sh awk cut dirname date id env cat sed sort tr grep head mkdir rm mv wc cksum sleep tar gzip; do
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
case "$*" in
  *--print-uris*) echo "'http://x/y.deb' y.deb 2000000 SHA256:0" ;;
  *download*) : >"$PWD/tex-large_1_all.deb" ;;
  *update*)
    if [ -n "${LOCKED_ONCE:-}" ] && [ -e "$LOCKED_ONCE" ]; then
      rm "$LOCKED_ONCE"
      echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7 (apt)'
      exit 100
    fi
    if [ -n "${UPDATE_SAYS:-}" ]; then echo "$UPDATE_SAYS"; fi; exit "${UPDATE_STATUS:-0}"
    ;;
  *install*) if [ -n "${BROKEN:-}" ]; then echo "E: $BROKEN" >&2; exit 100; fi ;;
esac
END
cat >"$scratch/debian/apt-cache" <<'END'
#!/bin/sh
shift
for package; do
  case " $LACKS " in *" $package "*) ;; *) printf '%s:\n  Installed: (none)\n  Candidate: 2024.1\n' "$package" ;; esac
done
END
cat >"$scratch/debian/dpkg" <<'END'
#!/bin/sh
echo "dpkg $*" >>"$LOG"
END
cat >"$scratch/debian/dpkg-deb" <<'END'
#!/bin/sh
case $1 in
  --fsys-tarfile) cat "$TARRED" ;;
  *) cp -r "$3" "$BUILT" ;;
esac
END
cat >"$scratch/debian/sudo" <<'END'
#!/bin/sh
exec "$@"
END
chmod +x "$scratch/debian"/*
ln -s "$(command -v cp)" "$scratch/debian/cp"
export INSTALLED="$scratch/installed" LOG="$scratch/log" LACKS='' TARRED="$scratch/tarred" BUILT="$scratch/built"

on() { # on SYSTEM SCRIPT [ARGUMENT…], SYSTEM being a folder of commands
  system=$1 script=$2
  shift 2
  : >"$LOG"
  runs env PATH="$scratch/$system" SETUP_WAITS="${SETUP_WAITS:-60}" sh "$tools/$script" "$@"
}
asked_dpkg() { grep -c '^asked' "$LOG"; }
asked_apt() { grep -c '^apt-get' "$LOG"; }
lines() { printf '%s\n' "$said" | grep -c .; }
installs() { sed -n 's/.* install .*--reinstall //p' "$LOG"; }

# Everything installed
printf '%s installed\n' libone-dev libtwo-dev libtest-dev new-test solver >"$INSTALLED"
printf '#!/bin/sh\n' >"$scratch/debian/slv" && chmod +x "$scratch/debian/slv"
on debian setup report test
claim 'setup succeeds when nothing is missing' "$status" -eq 0
claim 'setup asks dpkg once for what is needed and once for what more tests would use' "$(asked_dpkg)" -eq 2
claim 'setup leaves apt alone when nothing is missing' "$(asked_apt)" -eq 0
printf 'touch "%s"\n' "$scratch/fetched" >"$tools/axe"
ln -s "$(command -v touch)" "$scratch/debian/touch"
on debian setup report
claim 'setup fetches nothing else for a report' ! -e "$scratch/fetched"
on debian setup test test-all
claim 'setup fetches what is no package although none is missing' "$status $(ls "$scratch/fetched")" = "0 $scratch/fetched"
echo 'exit 1' >"$tools/axe"
on debian setup test test-all
claim 'setup says what it could not fetch' "$status $(says 'axe-core could not be fetched')" = '0 yes'
on debian require test
claim 'require is content' "$status" -eq 0
claim 'require is silent' -z "$said"
rm "$scratch/debian/slv"

# Two missing, one of them half-removed
printf '%s\n' 'libone-dev installed' 'libtwo-dev config-files' >"$INSTALLED"
on debian setup report
claim 'setup succeeds when apt does' "$status" -eq 0
claim 'setup says how much is fetched' "$(says 'installs 1 packages, 2 MB to fetch')" = yes
claim 'the lists are fetched first' "$(grep -m 1 '^apt-get' "$LOG")" = 'apt-get -q -o DPkg::Lock::Timeout=60 update'
claim 'what was broken off is gone on with before anything is installed' "$(grep -A 1 '^dpkg' "$LOG" | head -n 1)" = 'dpkg --configure -a'
claim 'the report does not install what tests need' "$(installs)" = 'libtwo-dev'
on debian setup why test
claim 'each target brings its own' "$(installs)" = 'libtwo-dev libtest-dev old-test solver'
on debian setup
claim 'setup alone is that of the report' "$(installs)" = 'libtwo-dev'
on debian require report
claim 'require fails as where a tool is missing' "$status" -eq 3
claim 'require names what the target lacks, and the command' "$(says 'missing: libtwo-dev — run "make setup report"')" = yes
on debian require test
claim 'require names the command of that target' "$(says 'run "make setup test"')" = yes
claim 'a test that can be skipped is not asked for' "$(says solver)" = no

# A suite that lacks packages
export LACKS='old-test solver'
on debian setup test
claim 'of alternatives the one that there is' "$(installs)" = 'libtwo-dev libtest-dev new-test'
claim 'what the suite lacks is told in one line' "$(says 'has no package solver; the tests that need it are skipped')" = yes
printf '%s installed\n' libone-dev libtwo-dev libtest-dev new-test >"$INSTALLED"
export LACKS='old-test solver poppler'
on debian setup test
claim 'what the suite lacks does not have the lists read again' "$(asked_apt)" -eq 0
on debian setup page
claim 'what a target needs and the suite lacks is an error' "$status" -eq 3
claim 'it is named in one line' "$(says 'has no package poppler')$(lines)" = yes1
printf '%s\n' 'libone-dev installed' >"$INSTALLED"

# No network: apt-get update succeeds all the same
export LACKS='libtwo-dev libc6' UPDATE_SAYS="Err:1 http://x trixie InRelease
  Temporary failure resolving 'x'"
on debian setup report
claim 'no network ends with the status of a missing tool' "$status" -eq 3
claim 'and with one line' "$(says "cannot be reached (Temporary failure resolving 'x')")$(lines)" = yes1
unset UPDATE_SAYS
export LACKS=''

# Another apt
export UPDATE_STATUS=100 UPDATE_SAYS='E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7 (apt)'
export SETUP_WAITS=0
on debian setup report
unset SETUP_WAITS
claim 'a lock that stays is told in one line' \
  "$status$(says 'another process uses apt (Could not get lock /var/lib/apt/lists/lock. It is held by process 7 (apt))')$(lines)" = 3yes1
unset UPDATE_STATUS UPDATE_SAYS
export LOCKED_ONCE="$scratch/locked"
touch "$LOCKED_ONCE"
on debian setup report
claim 'a lock that goes is waited for' "$status$(installs)" = 0libtwo-dev
unset LOCKED_ONCE

# apt-get fails
export BROKEN='Something is wrong'
on debian setup report
claim 'setup fails when apt does' "$status" -eq 3
claim "apt's message is shown" "$(says "setup: $BROKEN")" = yes
export BROKEN="You don't have enough free space in /var/cache/apt/archives/."
on debian setup report
claim 'a full disk is told' "$(says "the disk is full ($BROKEN)")" = yes
export BROKEN='Sub-process /usr/bin/dpkg received signal 9.'
on debian setup report
claim 'a dpkg that was killed is told' "$(says "setup: $BROKEN")$(lines)" = yes2
printf '#!/bin/sh\necho Available\necho / 9 9 0 100%% /\n' >"$scratch/debian/df" && chmod +x "$scratch/debian/df"
on debian setup report
claim 'a disk too full for a message is told' "$(says 'setup: the disk is full')$(lines)" = yes2
rm "$scratch/debian/df"
unset BROKEN

# A folder of a package for TeX
mkdir -p "$scratch/usr/share/texlive/texmf-dist/tex/latex/nice" "$scratch/usr/share/texlive/texmf-dist/tex/latex/other"
touch "$scratch/usr/share/texlive/texmf-dist/tex/latex/nice/nice.sty" "$scratch/usr/share/texlive/texmf-dist/tex/latex/other/other.sty"
(cd "$scratch" && tar -cf "$TARRED" ./usr)
on debian setup paper
claim 'of a folder only that is packed' "$(cd "$BUILT/usr/share/texmf/tex/latex/halfspace-tex" && echo *)" = nice
claim 'its files are there' -e "$BUILT/usr/share/texmf/tex/latex/halfspace-tex/nice/nice.sty"
claim 'the package is for this release of TeX Live alone' \
  "$(sed -n 's/^Depends: //p' "$BUILT/DEBIAN/control")" = 'texlive-base (>= 2024), texlive-base (<< 2025)'
printf 'no archive' >"$TARRED"
on debian setup paper
claim 'a package that cannot be unpacked is told in one line' "$status$(says 'setup: tar: ')$(lines)" = 3yes2
(cd "$scratch" && tar -cf "$TARRED" ./usr)
rm -r "$BUILT"
on debian setup paper
claim 'it is installed with the others' "$(installs | sed 's|/.*/||')" = 'libtwo-dev halfspace-tex.deb'

# An unknown target
on debian setup nonsense
claim 'an unknown target is bad input' "$status$(lines)" = 21
claim 'it is named' "$(says nonsense)" = yes
claim 'nothing is tried for it' "$(asked_apt)" -eq 0

# Neither root nor sudo
rm "$scratch/debian/sudo" "$scratch/debian/id"
printf '#!/bin/sh\necho 1000\n' >"$scratch/debian/id"
chmod +x "$scratch/debian/id"
on debian setup report test
claim 'setup fails without rights' "$status$(lines)" = 31
claim 'setup tells the command' "$(says 'apt-get install --no-install-recommends libtest-dev libtwo-dev old-test')" = yes
claim 'nothing is tried without rights' "$(asked_apt)" -eq 0

# Another system
on elsewhere setup test
claim 'setup fails where there is no apt-get' "$status" -eq 3
claim 'and says what to do instead' "$(says 'what it lacks of these, then call "make test":')" = yes
claim 'setup lists what is wanted by purpose, in words of any system' "$(says '  libraries: One 1.2, Two 2.3')$(says '  tests: Test, Tester')" = yesyes
on elsewhere require report
claim 'without dpkg libraries are left to CMake' "$status" -eq 0
on elsewhere require page
claim 'a command that is not there is named by what it belongs to' "$(says 'missing: Poppler')" = yes

finish
