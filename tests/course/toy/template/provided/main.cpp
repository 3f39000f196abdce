#include "assignment.hpp"
#include "judge/answer_questions.hpp"

int main() {
  judge::answer_questions([](const std::string& task, const std::vector<double>& in) {
    std::vector<double> out;
    if (task == "sum") return std::vector<double>{sum(in.at(0), in.at(1))};
    for (const double x : in) out.push_back(task == "square" ? square(x) : cube(x));
    return out;
  });
}
