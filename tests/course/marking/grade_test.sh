#!/bin/sh
# grade_test.sh PROGRAM SOURCE: grades a small class of the real assignment with the script of `make course DO=grade`.
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
  'student,state,mark,not compiling alice,on time,100, bob,on time,63,influence carol,late,90, dave,not graded,, erin,missing,, frank,on time,100, '

grade two 1
claim 'marks do not depend on how many are graded at a time' \
  -z "$(diff -r "$scratch/one/grades" "$scratch/two/grades" && diff "$scratch/one/grades.csv" "$scratch/two/grades.csv")"

# This grader fails for one student. (The contact builds on the influence coefficients, so bob has lost both, and keeps the points of his tests.)
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

# What the grades tell of the class.
results() { # results WORK [VARIABLE=value …]
  work="$scratch/$1"
  shift
  runs env "$@" HALFSPACE_COURSE="$course" WORK="$work" CALLER="$scratch" bash "$source_dir/src/toolchain/course/results"
}
printf 'Student,ID,SIS Login ID,Section,%s (7),Total\n' 'Surface displacements and the contact of two cylinders' >"$scratch/canvas.csv"
printf '%s\n' 'Alice,1,alice,S,,' 'Bob,2,bob,S,,' 'Carol,3,carol,S,,' 'Frank,4,frank,S,,' >>"$scratch/canvas.csv"
results one ROSTER=class.csv SUBMISSIONS='sub missions' CANVAS=canvas.csv
claim 'what is not graded is told' "$status $(says 'student dave handed something in that is not graded')" = '1 yes'
claim 'Canvas gets the marks' "$(tail -n +2 "$scratch/one/results/canvas.csv" | cut -d, -f3,5 | tr -d '\r' | tr '\n' ' ')" = \
  'alice,100 bob,63 carol,90 frank,100 '
claim 'Moodle gets the marks' "$(cut -d, -f1,2 "$scratch/one/results/moodle.csv" | tr -d '\r' | tr '\n' ' ')" = \
  'student,grade alice,100 bob,63 carol,90 frank,100 '
claim 'who has a mark has a page, and nobody else' "$(cd "$scratch/one/results/feedback" && printf '%s ' *)" = \
  'alice.html bob.html carol.html frank.html '
claim 'with the mark' "$(grep -c 'bob: 63 of 100 points' "$scratch/one/results/feedback/bob.html")" = 1
claim 'and they are packed' "$(bsdtar -tf "$scratch/one/results/feedback.zip" | head -1)" = feedback/alice.html
results one CANVAS=canvas.csv COLUMN=Exam
claim 'a column that there is not is told with its place' "$status $(says "canvas.csv:1:1: there are 0 columns named 'Exam'")" = '2 yes'
mkdir "$scratch/none"
results none
claim 'without grades there are no results' "$status $(says 'make course DO=grade comes first')" = '2 yes'

# Markers see reports without names.
course_script() { # course_script NAME VARIABLE=value …
  name=$1
  shift
  runs env HALFSPACE_COURSE="$course" WORK="$scratch/one" CALLER="$scratch" ROSTER=class.csv \
    SEED='autumn 27' "$@" bash "$source_dir/src/toolchain/course/$name"
}
course_script marking SUBMISSIONS='sub missions'
claim 'what is no submission of one student is told' "$status $(says 'student dave has more than one submission')" = '1 yes'
claim 'the instructor alone sees whose each is' "$(tail -n +2 "$scratch/one/reports.csv" | cut -d, -f1 | tr '\n' ' ')" = 'alice bob '
claim 'by the name of its folder' -d "$scratch/one/marking/$(sed -n 's/^bob,\(report-[0-9a-f]*\)\r*$/\1/p' "$scratch/one/reports.csv")"
claim 'whose folder has it' "$(find "$scratch/one/marking" -name report.tex | wc -l | tr -d ' ')" = 2
claim 'each is typeset' "$(find "$scratch/one/marking" -name typeset.pdf | wc -l | tr -d ' ')" = 2
claim 'and what does not compile is told beside it' "$(cat "$scratch"/one/marking/*/findings.txt | grep -c "'nothing' was not declared")" = 1
claim 'and nothing tells whose it is' -z "$(find "$scratch/one/marking" -name '*alice*' -o -name '*bob*')"

# Copies of the solution have no line of their own; a helper under two names has.
mkdir "$scratch/alike"
for student in ada ben; do
  mkdir -p "$scratch/alike/$student"
  cp -R "$submissions/alice/src" "$scratch/alike/$student/src"
done
course_script likeness SUBMISSIONS=alike ROSTER=
claim 'who has the solution only is like nobody' "$status $(wc -l <"$scratch/one/likeness/pairs.csv" | tr -d ' ')" = '0 1'
helper='static double %s(double %s, int n) { double s = 1; while (n > 0) { s = s * %s + n / (s + 2.0); n = n - 1; if (s > 9) s = s - 4; } return s; }\n'
# shellcheck disable=SC2059  # the format is the text
printf "$helper" one a a >>"$scratch/alike/ada/src/influence.cpp"
# shellcheck disable=SC2059
printf "$helper" two bb bb >>"$scratch/alike/ben/src/influence.cpp"
course_script likeness SUBMISSIONS=alike ROSTER=
claim 'a helper under another name is told' "$(tail -1 "$scratch/one/likeness/pairs.csv" | tr -d '\r')" = influence,ada,100,ben,100
claim 'and both are exported, with what was given' "$(cd "$scratch/one/likeness" && find . -path '*/src/influence.cpp' | wc -l | tr -d ' ')" = 3

# A group hands in under its name, and each member has its mark.
mkdir "$scratch/groups" "$scratch/three"
cp "$submissions/carol.tar.gz" "$scratch/groups/g7.tar.gz"
printf '%s\n' student,group,submitted,slip_days alice,g7,2027-01-16T23:59:00Z,2 bob,g7,2027-01-16T23:59:00Z, carol,,, >"$scratch/groups.csv"
grade three 1 groups groups.csv
claim 'a group is graded' "$status" = 0
claim 'each member has its mark' "$(cut -d, -f1,5,10 "$scratch/three/grades.csv" | tr -d '\r' | tr '\n' ' ')" = \
  'student,mark,group alice,90,g7 bob,90,g7 carol,, '

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

runs env HALFSPACE_COURSE="$course" bash "$source_dir/src/toolchain/course/grade-one" "$scratch/one/grades" "$submissions/.."
claim 'a name that is none is refused' "$status $(says 'an id consists of')" = '2 yes'

runs env SUBMISSIONS=nowhere HALFSPACE_COURSE="$course" WORK="$scratch/one" bash "$source_dir/src/toolchain/course/grade"
claim 'a folder that there is not is named' "$(says 'SUBMISSIONS: there is no nowhere')" = yes

# This is the second task of a Slurm array.
mkdir -p "$scratch/slurm/build/course" "$scratch/slurm/src/toolchain"
ln -s "$source_dir/src/toolchain/course" "$scratch/slurm/src/toolchain/course"
ln -s "$scratch/one/course/toolkit" "$scratch/slurm/build/course/toolkit"
"$course" list "$submissions" --null >"$scratch/slurm/build/course/submissions" 2>/dev/null
runs env SLURM_SUBMIT_DIR="$scratch/slurm" SLURM_ARRAY_TASK_ID=2 HALFSPACE_COURSE="$course" \
  bash "$source_dir/src/toolchain/course/class.slurm" --assignment "$source_dir/report/assignment"
claim 'an array task grades its own submission' "$(says 'bob: 63 of 100 points')" = yes
finish
