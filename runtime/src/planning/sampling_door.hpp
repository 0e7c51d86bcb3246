// The interface to the library of sampling planners, which is loaded by the first path search. It
// consists of plain numbers and functions: no header of that library is used outside of
// runtime/src/planning/ompl.
#pragma once

namespace armlet {

// A search from one configuration to one of several, through free ones. A configuration has `n`
// numbers; all functions are called in the thread of the search, with `context`, and do not throw.
//
// lower, upper  the box of all configurations, n each.
// goals         n numbers each, consecutive; all of them, and the start, are free.
// longest       the largest length of an edge of a tree.
// sample        a random configuration of the box; there is no other source of randomness.
// go_on         called before each step of the search.
// found         called for each configuration of the path that was found, in order.
struct SamplingSearch {
  int n;
  const double* lower;
  const double* upper;
  const double* start;
  int goal_count;
  const double* goals;
  double longest;
  void* context;
  void (*sample)(void* context, double* x);
  bool (*is_free)(void* context, const double* x);
  bool (*is_free_between)(void* context, const double* from, const double* to);
  bool (*go_on)(void* context);
  void (*found)(void* context, const double* x);
};

// Returns whether a path was found; does not throw.
using SearchBySampling = bool (*)(const SamplingSearch*);

inline constexpr const char* kSearchBySampling = "armlet_search_by_sampling";
inline constexpr const char* kSamplingLibrary = "libarmlet_planning.so";

}  // namespace armlet
