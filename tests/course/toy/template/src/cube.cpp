#include "assignment.hpp"
double cube(double x) {
  // BEGIN SOLUTION
  // STUB: return 0;
  return x * square(x);
  // END SOLUTION
}
