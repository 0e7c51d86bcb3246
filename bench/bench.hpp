#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace armlet::bench {

// Nanoseconds per call; medians over the rounds.
struct Times {
  double ours = 0.0;
  double theirs = 0.0;
};

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// The time of one call of `work(i)`, i = 0 .. calls - 1. Results are used, so that no call is
// removed.
template <class Work>
double nanoseconds_per_call(int calls, Work& work) {
  using Clock = std::chrono::steady_clock;
  double sum = 0.0;
  const auto start = Clock::now();
  for (int i = 0; i < calls; ++i) sum += work(i);
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
  asm volatile("" : : "g"(sum));  // makes the compiler compute the sum
  return elapsed.count() / calls;
}

// The number of calls per round, of Armlet and of its peer.
struct Calls {
  int ours, theirs;
  Calls(int both) : ours(both), theirs(both) {}
  Calls(int ours_, int theirs_) : ours(ours_), theirs(theirs_) {}
};

// Times two implementations in turn, so that a slow moment of the computer affects both.
template <class Ours, class Theirs>
Times compare(Calls calls, Ours ours, Theirs theirs, int rounds = 11) {
  std::vector<double> a, b;
  for (int round = 0; round < rounds; ++round) {
    a.push_back(nanoseconds_per_call(calls.ours, ours));
    b.push_back(nanoseconds_per_call(calls.theirs, theirs));
  }
  return {median(a), median(b)};
}

inline void print_row(const char* subject, const char* what, const Times& times,
                      const char* target = "") {
  std::printf("%-10s %-24s %10.1f %10.1f %8.2fx  %s\n", subject, what, times.ours, times.theirs,
              times.theirs / times.ours, target);
}

}  // namespace armlet::bench
