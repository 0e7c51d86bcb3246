// The time of programs with ten thousand bodies, in which an arm moves 40 times with collision
// reports: bodies far from one another, and bodies that intersect. The time includes reading the
// program, creating the bodies, and planning and verifying the moves.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "bench.hpp"

namespace armlet::bench {
namespace {

constexpr int kRounds = 5;

// Processor time of one run, s.
double run(const Engine& engine, const std::string& text) {
  const std::clock_t start = std::clock();
  Session session(engine, {});
  if (!session.compile(text, "bodies.rbt") || session.run().status != Progress::kDone) {
    std::fprintf(stderr, "The program does not run; try `armlet run`.\n");
    std::exit(1);
  }
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void measure(const Engine& engine, const char* what, const char* path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<double> seconds;
  for (int round = 0; round < kRounds; ++round) seconds.push_back(run(engine, text));
  std::printf("%-52s %6.2f s  (target 1.5)\n", what, median(seconds));
}

}  // namespace
}  // namespace armlet::bench

int main() {
  using namespace armlet::bench;
  armlet::Engine engine;
  armlet::install(engine);
  measure(engine, "10,000 bodies apart, 40 moves",
          ARMLET_BENCH "/programs/motion/bodies_spread.rbt");
  measure(engine, "10,000 bodies in one another, 40 moves",
          ARMLET_BENCH "/programs/motion/bodies_overlapping.rbt");
}
