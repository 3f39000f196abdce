#!/bin/sh
# gradescope_test.sh SOURCE: what the scripts in Gradescope's container make of its files, with a grader that prints its arguments.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/../../toolchain/shell_test.sh"

autograder=$scratch/autograder
program=$autograder/source/halfspace/build/release/halfspace-course
mkdir -p "$(dirname "$program")" "$autograder/results" "$autograder/submission"
cat >"$program" <<EOF
#!/bin/sh
echo "\$@"
mkdir -p '$autograder/graded'
echo '{}' >'$autograder/graded/results.json'
EOF
chmod +x "$program"

# grade METADATA: runs the script for a submission.
grade() {
  printf '%s\n' "$1" >"$autograder/submission_metadata.json"
  runs env AUTOGRADER="$autograder" bash "$source_dir/src/toolchain/course/gradescope_run"
}

grade '{"created_at": "2027-01-16T10:00:00-07:00", "users": [{"email": "ada+x@example.org",
  "assignment": {"due_date": "2027-01-17T23:59:00-07:00"}}],
  "assignment": {"due_date": "2027-01-15T23:59:00-07:00", "late_due_date": "2027-01-20T23:59:00-07:00"}}'
claim 'a submission is graded' "$status" = 0
claim 'as that of its student' "$(says '--student ada_x@example.org ')" = yes
claim "until the student's own due date it is on time" "$(says '--deadline 2027-01-17T23:59:00-07:00')" = yes
claim 'after the late due date nothing counts' "$(says '--late-until 2027-01-20T23:59:00-07:00')" = yes
claim 'the results are where Gradescope looks' -f "$autograder/results/results.json"

grade '{"users": [{"email": "ada@example.org"}], "assignment": {"due_date": null, "late_due_date": null}}'
claim 'without dates nobody is late' "$status $(says --deadline) $(says --late-until)" = '0 no no'

mv "$program" "$program.works"
cat >"$program" <<'EOF'
#!/bin/sh
echo "halfspace-course: 'a' cannot be taken: the submission is empty" >&2
exit 2
EOF
chmod +x "$program"
grade '{"users": [{"email": "ada@example.org"}], "assignment": {}}'
claim 'of what cannot be taken the student is told why' "$status $(grep -c 'Nothing is graded: the submission is empty' "$autograder/results/results.json")" = '0 1'
mv "$program.works" "$program"

for users in '[]' '[{"email": ""}]' 'null'; do
  grade '{"users": '"$users"', "assignment": {}}'
  claim "users $users are refused" "$status $(says 'names no user')" = '2 yes'
done

# set_up ID VERSION: begins to set up a container of this system.
set_up() {
  printf 'ID=%s\nVERSION_ID="%s"\n' "$1" "$2" >"$scratch/os-release"
  mkdir -p "$scratch/tools"
  printf '#!/bin/sh\nexit 42\n' >"$scratch/tools/cmake"
  chmod +x "$scratch/tools/cmake"
  runs env OS_RELEASE="$scratch/os-release" IS_SET_UP=1 AUTOGRADER="$autograder" PATH="$scratch/tools:$PATH" \
    bash "$source_dir/src/toolchain/course/gradescope_setup.sh"
}
for system in 'ubuntu 24.04' 'ubuntu 26.04' 'debian 12' 'debian 13'; do
  # shellcheck disable=SC2086  # two words
  set_up $system
  claim "$system is compiled on" "$status" = 42
done
for system in 'ubuntu 18.04' 'ubuntu 22.04' 'debian 11' 'fedora 42'; do
  # shellcheck disable=SC2086  # two words
  set_up $system
  claim "$system is refused, and what to choose is said" "$status $(says 'choose the base image Ubuntu 24.04')" = '2 yes'
done
finish
