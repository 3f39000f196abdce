#include "toy_checks.hpp"

int main(int argc, char** argv) {
  return judge::run(argc, argv, toy::exercises(), toy::numbers);
}
