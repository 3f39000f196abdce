// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/rubric.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "course/assignment/student_text.hpp"
#include "system/csv.hpp"
#include "system/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace {

constexpr std::array<const char*, 5> rubric_columns = {"student", "criterion", "points", "comment",
                                                       "marker"};

constexpr const char* drawn_name = "report-";
constexpr std::size_t n_drawn_digits = 10;

/// Whether a name looks like one of anonymous_names.
bool is_drawn(std::string_view name) {
  return name.starts_with(drawn_name) &&
         name.size() == std::string_view(drawn_name).size() + n_drawn_digits;
}

[[noreturn]] void fail_at(const sys::CsvField& field, const std::string& message) {
  throw sys::SourceError(field.place + ": " + message);
}

/// The markers' file while it is read.
class RubricReader {
 public:
  RubricReader(const Assignment& assignment, const std::filesystem::path& file,
               const std::map<std::string, std::string>& names)
      : assignment_(assignment), rows_(sys::parse_csv(sys::read_file(file), file.string())) {
    for (const auto& [unit, name] : names) units_[name] = unit;
    if (rows_.empty()) throw sys::SourceError(file.string() + ":1:1: there is no header line");
  }

  std::vector<RubricLine> read() {
    read_header();
    std::vector<RubricLine> lines;
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      RubricLine line = read_line(rows_[i]);
      if (!known_.emplace(line.unit, line.criterion).second) {
        fail_at(rows_[i][at_["student"]],
                fmt::format("there is a line for {} and {} already",
                            shown_name(rows_[i][at_["student"]].text), line.criterion));
      }
      if (!rows_[i][at_["points"]].text.empty()) lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  void read_header() {
    for (std::size_t i = 0; i < rows_[0].size(); ++i) {
      const sys::CsvField& head = rows_[0][i];
      const bool is_known = std::ranges::find(rubric_columns, head.text) != rubric_columns.end();
      if (!is_known || !at_.emplace(head.text, i).second) {
        fail_at(head, fmt::format("there is a column '{}'; the columns are student, criterion, "
                                  "points, comment and marker, each once",
                                  shown_name(head.text)));
      }
    }
    for (const char* column : rubric_columns) {
      if (!at_.contains(column)) {
        fail_at(rows_[0][0], fmt::format("there is no column '{}'", column));
      }
    }
  }

  RubricLine read_line(const sys::CsvRow& row) {
    const sys::CsvField& student = row[at_["student"]];
    const sys::CsvField& criterion = row[at_["criterion"]];
    const auto unit = units_.find(student.text);
    const auto known = std::ranges::find(assignment_.criteria, criterion.text, &Criterion::id);
    if (known == assignment_.criteria.end()) {
      fail_at(criterion, fmt::format("there is no criterion '{}'", shown_name(criterion.text)));
    }
    return {.unit = unit == units_.end() ? student.text : unit->second,
            .criterion = criterion.text,
            .mark = {.points = points_of_line(row, *known),
                     .comment = row[at_["comment"]].text,
                     .marker = row[at_["marker"]].text},
            .place = student.place,
            .is_drawn_name = units_.empty() && is_drawn(student.text)};
  }

  double points_of_line(const sys::CsvRow& row, const Criterion& criterion) {
    const sys::CsvField& field = row[at_["points"]];
    if (field.text.empty()) return 0;
    const double points = sys::parsed<double>(field.text).value_or(-1);
    if (!(points >= 0 && points <= criterion.points)) {
      fail_at(field, fmt::format("points: '{}' is no number from 0 to {}, the points of {}",
                                 shown_name(field.text), criterion.points, criterion.id));
    }
    if (row[at_["marker"]].text.empty()) {
      fail_at(row[at_["marker"]], "marker: it is not said who gave the points");
    }
    return points;
  }

  const Assignment& assignment_;
  std::vector<sys::CsvRow> rows_;
  std::map<std::string, std::string> units_;  ///< by the name that markers see
  std::map<std::string, std::size_t> at_;     ///< columns by name
  std::set<std::pair<std::string, std::string>> known_;
};

/// A line that says what is not marked yet; empty if all is.
std::string what_is_open(const Assignment& assignment, const StudentMark& student) {
  std::string open;
  for (const Criterion& criterion : assignment.criteria) {
    if (student.mark->criteria.contains(criterion.id)) continue;
    open += (open.empty() ? "" : ", ") + criterion.id;
  }
  return open.empty() ? ""
                      : fmt::format("the report of {} is not marked: {}", student.student, open);
}

}  // namespace

std::map<std::string, std::string> anonymous_names(const std::vector<std::string>& units,
                                                   const std::string& seed) {
  std::map<std::string, std::string> names;
  std::set<std::string> known;
  for (const std::string& unit : units) {
    const std::string digest = sys::sha256_of_text("report\n" + seed + "\n" + unit);
    names[unit] = drawn_name + digest.substr(0, n_drawn_digits);
    if (!known.insert(names[unit]).second) throw std::logic_error("two reports have one name");
  }
  return names;
}

std::vector<RubricLine> read_rubric_lines(const Assignment& assignment,
                                          const std::filesystem::path& file,
                                          const std::map<std::string, std::string>& names) {
  return RubricReader(assignment, file, names).read();
}

std::string without_markers_file(const Assignment& assignment) {
  if (assignment.criteria.empty()) return "";
  return fmt::format(
      "the rubric has criteria worth {} points for the report, and MARKS=file (--marks), which "
      "says what each report has of them, is missing",
      assignment.report_points());
}

void apply_rubric(const Assignment& assignment, const std::vector<RubricLine>& lines,
                  ClassMarks& marks) {
  marks.most += assignment.report_points();
  bool is_seed_missing = false;
  for (const RubricLine& line : lines) {
    bool is_found = false;
    for (StudentMark& student : marks.students) {
      if (student.unit() != line.unit || !student.mark) continue;
      is_found = true;
      student.mark->criteria[line.criterion] = line.mark;
    }
    if (!is_found && line.is_drawn_name) {
      if (is_seed_missing) continue;
      is_seed_missing = true;
      marks.problems.push_back(fmt::format(
          "{}: student: these names are drawn from the seed: give SEED_FILE=file (--seed-file)",
          line.place));
    } else if (!is_found) {
      marks.problems.push_back(
          fmt::format("{}: student: {} has no mark", line.place, shown_name(line.unit)));
    }
  }
  for (StudentMark& student : marks.students) {
    if (!student.mark) continue;
    if (!student.mark->has_report) {
      for (const Criterion& criterion : assignment.criteria) {
        student.mark->criteria.emplace(criterion.id, CriterionMark{});
      }
    }
    std::string open = what_is_open(assignment, student);
    if (!open.empty() && !is_seed_missing) marks.problems.push_back(std::move(open));
    student.mark->add_up();
  }
}

std::string rubric_form(const Assignment& assignment, const std::vector<std::string>& names) {
  std::string csv = "student,criterion,points,comment,marker\r\n";
  for (const std::string& name : names) {
    for (const Criterion& criterion : assignment.criteria) {
      csv += fmt::format("{},{},,,\r\n", sys::spreadsheet_field(name),
                         sys::spreadsheet_field(criterion.id));
    }
  }
  return csv;
}

}  // namespace course
