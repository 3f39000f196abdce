#!/bin/sh
# grade_test.sh HALFSPACE SOURCE: a small class through `make grade`'s script, with the real assignment.
halfspace=$1
shift
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/../toolchain/shell_test.sh"

submissions="$scratch/sub missions"
mkdir "$submissions" "$scratch/one" "$scratch/two"
"$halfspace" course solution --assignment "$source_dir/report/assignment" --source "$source_dir" \
  --output "$submissions/alice" >/dev/null
cp -R "$submissions/alice" "$submissions/bob"
echo 'int x = nothing;' >>"$submissions/bob/src/influence.cpp"
(cd "$submissions/alice" && bsdtar -cf ../carol.tar.gz -z src)
mkdir "$submissions/dave"
cp "$submissions/carol.tar.gz" "$submissions/dave.tgz"
cp "$submissions/carol.tar.gz" "$submissions/it's
zoe.tgz"
printf 'student,submitted\nalice,2027-01-15T23:59:00Z\nbob,\ncarol,2027-01-16T23:59:00Z\ndave,\nerin,\n' \
  >"$scratch/class.csv"

# grade WORK JOBS: by the script.
grade() {
  runs env SUBMISSIONS="sub missions" ROSTER=class.csv J="$2" HALFSPACE="${program:-$halfspace}" WORK="$scratch/$1" \
    CALLER="$scratch" bash "$source_dir/src/toolchain/course/grade"
}

grade one 2
claim 'what could not be graded gives exit code 2' "$status" = 2
claim 'two submissions of one student are told' "$(says 'student dave has more than one submission')" = yes
claim 'a name that is none is told in one line' "$(says "'it's?zoe.tgz' is not named for a student")" = yes
marks=$(cut -d, -f1,2,5,8 "$scratch/one/grades.csv" | tr -d '\r' | tr '\n' ' ')
claim "the table tells all: $marks" "$marks" = \
  'student,state,mark,not compiling alice,on time,100, bob,on time,60,influence carol,late,90, dave,not graded,, erin,missing,, '

grade two 1
claim 'marks do not depend on how many are graded at a time' \
  -z "$(diff -r "$scratch/one/grades" "$scratch/two/grades" && diff "$scratch/one/grades.csv" "$scratch/two/grades.csv")"

# A grader that fails for one. (The contact builds on the influence coefficients: bob has lost both.)
program="$scratch/failing"
cat >"$program" <<EOF
#!/bin/sh
case "\$2 \$3" in 'grade '*/bob) echo 'halfspace: broken' >&2; exit 3 ;; esac
exec '$halfspace' "\$@"
EOF
chmod +x "$program"
grade two 2
claim 'a grader that fails gives exit code 3' "$status" = 3
claim 'and says for whom' "$(says 'bob was not graded (exit 3)')" = yes
claim 'the old mark is gone' "$(grep -c '^bob,not graded' "$scratch/two/grades.csv")" = 1
claim 'the others are graded' "$(grep -c '^carol,late,100,10,90' "$scratch/two/grades.csv")" = 1

runs env SUBMISSIONS=nowhere HALFSPACE="$halfspace" WORK="$scratch/one" bash "$source_dir/src/toolchain/course/grade"
claim 'a folder that there is not is named' "$(says 'SUBMISSIONS: there is no nowhere')" = yes

# A Slurm array's second task.
mkdir -p "$scratch/slurm/build/course" "$scratch/slurm/src/toolchain"
ln -s "$source_dir/src/toolchain/course" "$scratch/slurm/src/toolchain/course"
ln -s "$scratch/one/course/toolkit" "$scratch/slurm/build/course/toolkit"
"$halfspace" course list "$submissions" --null >"$scratch/slurm/build/course/submissions" 2>/dev/null
runs env SLURM_SUBMIT_DIR="$scratch/slurm" SLURM_ARRAY_TASK_ID=2 HALFSPACE="$halfspace" \
  bash "$source_dir/src/toolchain/course/class.slurm" --assignment "$source_dir/report/assignment"
claim 'an array task grades its own submission' "$(says 'bob: 60 of 100 points')" = yes
finish
