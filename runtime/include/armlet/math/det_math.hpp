#pragma once

// Elementary functions with the same bits on every machine: only + - * / and sqrt are used, in a
// fixed order, so results depend neither on the C library nor on the processor. Errors stay below
// one unit in the last place. Results that feed a trace use these instead of <cmath>.
//
// Outside its domain a function returns NaN as <cmath> does; callers check their arguments.
namespace armlet::det {

struct SinCos {
  double sin;
  double cos;
};

// Sine and cosine of any finite angle, rad; the range reduction is exact for all angles.
SinCos sincos(double x);
double sin(double x);
double cos(double x);
double tan(double x);

// Sines and cosines of n angles, rad; s and c receive n numbers each.
void sincos(const double* x, double* s, double* c, int n);

double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);

double exp(double x);
double log(double x);  // natural logarithm
double pow(double x, double y);

// Square root of x^2 + y^2 without the C library, for x and y without overflow or underflow.
double hypot(double x, double y);

}  // namespace armlet::det
