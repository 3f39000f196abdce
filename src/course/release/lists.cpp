// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/handout.hpp"

#include <fmt/core.h>

#include <map>
#include <optional>
#include <vector>

#include "course/release/markers.hpp"
#include "system/error.hpp"
#include "system/text.hpp"

namespace course {
namespace {

// What stands for each word between two @.
using Words = std::map<std::string, std::string, std::less<>>;

Words words_of(const Exercise& exercise, std::size_t number) {
  return {{"number", std::to_string(number)},
          {"name", exercise.name()},
          {"file", exercise.file},
          {"id", exercise.id},
          {"title", exercise.title},
          {"points", fmt::format("{}", exercise.points())}};
}

std::vector<Words> each_exercise(const Assignment& assignment) {
  std::vector<Words> entries;
  for (const Exercise& exercise : assignment.exercises) {
    entries.push_back(words_of(exercise, entries.size() + 1));
  }
  return entries;
}

/// Each check of one kind.
std::vector<Words> each_check(const Assignment& assignment, Visibility visibility) {
  std::vector<Words> entries;
  std::size_t number = 0;
  for (const Exercise& exercise : assignment.exercises) {
    ++number;
    for (const CheckEntry& check : exercise.checks) {
      if (check.visibility != visibility) continue;
      Words words = words_of(exercise, number);
      words["points"] = fmt::format("{}", check.points);
      words["check"] = check.id;
      words["says"] = check.says;
      words["tests"] = exercise.tests;
      entries.push_back(std::move(words));
    }
  }
  return entries;
}

/// What a list is of; nothing if there is no such list.
std::optional<std::vector<Words>> each(const Assignment& assignment, std::string_view of) {
  if (of == "EXERCISE") return each_exercise(assignment);
  if (of == "PUBLIC CHECK") return each_check(assignment, Visibility::visible);
  if (of == "OWN TESTS") return each_check(assignment, Visibility::tests);
  return std::nullopt;
}

// Replaces each @word@. Throws std::out_of_range with the word if there is no such word.
std::string filled(std::string_view text, const Words& words) {
  std::string result;
  for (auto at = text.find('@'); at != text.npos; at = text.find('@')) {
    const auto end = text.find('@', at + 1);
    const std::string_view word = text.substr(at + 1, end == text.npos ? end : end - at - 1);
    const auto known = words.find(word);
    if (end == text.npos || known == words.end()) throw std::out_of_range(std::string(word));
    result.append(text.substr(0, at)).append(known->second);
    text.remove_prefix(end + 1);
  }
  return result.append(text);
}

}  // namespace

std::string with_lists(const Assignment& assignment, std::string_view text,
                       const std::string& file) {
  const CommentSigns signs = comment_signs(file);
  std::string result;
  int number = 0;
  for (const LineWithEnd& line : lines_with_ends(text)) {
    ++number;
    const auto fail = [&](const std::string& what) {
      throw sys::SourceError(fmt::format("{}:{}: {}", file, number, what));
    };
    const auto words = words_of_comment(line.text, signs);
    const auto colon = words ? words->find(':') : std::string_view::npos;
    if (!words || !words->starts_with("EACH ") || colon == words->npos) {
      result.append(line.text).append(line.end);
      continue;
    }
    const std::string_view of = words->substr(5, colon - 5);
    const auto entries = each(assignment, of);
    if (!entries) {
      fail(
          fmt::format("a list is of «EACH EXERCISE:», «EACH PUBLIC CHECK:» or «EACH OWN TESTS:», "
                      "not of «EACH {}:»",
                      of));
    }
    const std::string_view indentation = line.text.substr(0, line.text.find(signs.begin));
    const std::string_view entry = sys::stripped(words->substr(colon + 1));
    try {
      for (const Words& known : *entries) {
        result.append(indentation).append(filled(entry, known)).append(line.end);
      }
    } catch (const std::out_of_range& unknown) {
      fail(fmt::format("@{}@ is not known in a list of «EACH {}:»", unknown.what(), of));
    }
  }
  return result;
}

}  // namespace course
