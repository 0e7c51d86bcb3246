// The door to the library of sampling planners, which is loaded when the first way is searched.
// Nothing but plain numbers and functions goes through it: no header of that library is seen
// outside of its room, runtime/src/planning/ompl.
#pragma once

namespace armlet {

// A search from one position to one of several, among those that are free. Positions are `n`
// numbers each; all functions are called in the thread that searches, with `context`, and throw
// nothing.
//
// lower, upper  the box in which positions lie, n each.
// goals         n numbers each, one behind the other; all of them, and the start, are free.
// longest       no straight piece of a tree is longer.
// sample        a position of the box by chance: the only chance there is.
// go_on         asked before each step of the search.
// found         called for each position of the way that was found, in order.
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

// Whether a way was found; nothing is thrown.
using SearchBySampling = bool (*)(const SamplingSearch*);

inline constexpr const char* kSearchBySampling = "armlet_search_by_sampling";
inline constexpr const char* kSamplingLibrary = "libarmlet_planning.so";

}  // namespace armlet
