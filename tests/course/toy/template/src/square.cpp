#include "assignment.hpp"
double square(double x) {
  // BEGIN SOLUTION
  // STUB: return 0;
  return x * x;
  // END SOLUTION
}
