#pragma once
double square(double x);
double sum(double a, double b);
double cube(double x);
