#!/bin/sh
# grade_test.sh PROGRAM SOURCE: grades a small class of the real assignment with the script of `make grade`.
course=$1
shift
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/../../toolchain/shell_test.sh"
need_walls

submissions="$scratch/sub missions"
mkdir "$submissions" "$scratch/one" "$scratch/two"
"$course" solution --assignment "$source_dir/report/assignment" --source "$source_dir" \
  --output "$submissions/alice" >/dev/null
cp -R "$submissions/alice" "$submissions/bob"
echo 'int x = nothing;' >>"$submissions/bob/src/influence.cpp"
(cd "$submissions/alice" && bsdtar -cf ../carol.tar.gz -z src)
mkdir "$submissions/dave"
cp "$submissions/carol.tar.gz" "$submissions/dave.tgz"
cp "$submissions/carol.tar.gz" "$submissions/it's
zoe.tgz"
cp "$submissions/carol.tar.gz" "$submissions/frank.tgz"
printf 'student,submitted,deadline\n' >"$scratch/class.csv"
printf '%s\n' alice,2027-01-15T23:59:00Z, bob,, carol,2027-01-16T23:59:00Z, dave,, erin,, \
  frank,2027-01-18T23:59:00Z,2027-01-18T23:59:00Z \
  >>"$scratch/class.csv"

# grade WORK JOBS [SUBMISSIONS [ROSTER]]: runs the script.
grade() {
  runs env SUBMISSIONS="${3:-sub missions}" ROSTER="${4:-class.csv}" J="$2" HALFSPACE_COURSE="${program:-$course}" WORK="$scratch/$1" \
    CALLER="$scratch" bash "$source_dir/src/toolchain/course/grade"
}

grade one 2
claim 'what could not be graded gives exit code 2' "$status" = 2
claim 'who forgets the seed is told' "$(says 'no SEED is given: everybody is graded with the nominal numbers')" = yes
claim 'two submissions of one student are told' "$(says 'student dave has more than one submission')" = yes
claim 'a name that is none is told in one line' "$(says "'it's?zoe.tgz' is not named for a student")" = yes
marks=$(cut -d, -f1,2,5,8 "$scratch/one/grades.csv" | tr -d '\r' | tr '\n' ' ')
claim "the table tells all: $marks" "$marks" = \
  'student,state,mark,not compiling alice,on time,100, bob,on time,60,influence carol,late,90, dave,not graded,, erin,missing,, frank,on time,100, '

grade two 1
claim 'marks do not depend on how many are graded at a time' \
  -z "$(diff -r "$scratch/one/grades" "$scratch/two/grades" && diff "$scratch/one/grades.csv" "$scratch/two/grades.csv")"

# This grader fails for one student. (The contact builds on the influence coefficients, so bob has lost both.)
program="$scratch/failing"
cat >"$program" <<EOF
#!/bin/sh
case "\$1 \$2" in 'grade '*/bob) echo 'halfspace-course: broken' >&2; exit 3 ;; esac
exec '$course' "\$@"
EOF
chmod +x "$program"
grade two 2
claim 'a grader that fails gives exit code 3' "$status" = 3
claim 'and says for whom' "$(says 'bob was not graded (exit 3)')" = yes
claim 'the old mark is gone' "$(grep -c '^bob,not graded' "$scratch/two/grades.csv")" = 1
claim 'the others are graded' "$(grep -c '^carol,late,100,10,90' "$scratch/two/grades.csv")" = 1

# If grading cannot begin, the old grades stay.
program=
cp -R "$scratch/one/grades" "$scratch/before"
unchanged() {
  claim "$1: exit code 2" "$status" = 2
  claim "$1: it says so" "$(says 'the old grades stay')" = yes
  claim "$1: no table is named as the result" "$(says 'grades.csv')" = no
  claim "$1: the old grades stay" -z "$(diff -r "$scratch/before" "$scratch/one/grades" 2>&1)"
}
printf 'student,submitted\nalice,noon\n' >"$scratch/typo.csv"
grade one 1 "sub missions" typo.csv
unchanged 'a typing error in the roster'
claim 'and it has its place' "$(says "typo.csv:2: 'noon' is no time")" = yes
grade one 1 class.csv
unchanged 'a file instead of a folder'
mkdir "$scratch/empty"
grade one 1 empty
unchanged 'an empty folder'
exec 8>"$scratch/one/course/grade.lock"
flock 8
grade one 1
unchanged 'while another grades'
exec 8>&-

runs env HALFSPACE_COURSE="$course" bash "$source_dir/src/toolchain/course/grade-one" "$scratch/one/grades" \
  "$submissions/bob/" --assignment "$source_dir/report/assignment" --toolkit "$scratch/one/course/toolkit"
claim 'a slash after the name does no harm' "$status $(says 'bob: 60 of 100 points')" = '0 yes'
runs env HALFSPACE_COURSE="$course" bash "$source_dir/src/toolchain/course/grade-one" "$scratch/one/grades" "$submissions/.."
claim 'nor does a name that is none' "$status $(says 'an id consists of')" = '2 yes'

runs env SUBMISSIONS=nowhere HALFSPACE_COURSE="$course" WORK="$scratch/one" bash "$source_dir/src/toolchain/course/grade"
claim 'a folder that there is not is named' "$(says 'SUBMISSIONS: there is no nowhere')" = yes

# This is the second task of a Slurm array.
mkdir -p "$scratch/slurm/build/course" "$scratch/slurm/src/toolchain"
ln -s "$source_dir/src/toolchain/course" "$scratch/slurm/src/toolchain/course"
ln -s "$scratch/one/course/toolkit" "$scratch/slurm/build/course/toolkit"
"$course" list "$submissions" --null >"$scratch/slurm/build/course/submissions" 2>/dev/null
runs env SLURM_SUBMIT_DIR="$scratch/slurm" SLURM_ARRAY_TASK_ID=2 HALFSPACE_COURSE="$course" \
  bash "$source_dir/src/toolchain/course/class.slurm" --assignment "$source_dir/report/assignment"
claim 'an array task grades its own submission' "$(says 'bob: 60 of 100 points')" = yes
finish
