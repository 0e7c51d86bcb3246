// The speed of a simulated cell relative to real time: a minute of pick and place in 40 moves, with
// conditions that are tested a thousand times a second, and no listener. The time includes reading
// the program, planning and verifying its moves, and the tool with its payload.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "armlet/core/random.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "bench.hpp"
#include "kdl_peer.hpp"

namespace armlet::bench {
namespace {

constexpr int kConfigurations = 1000;

std::string text_of(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Simulated {
  double seconds = 0.0;  // of the simulated clock
  int moves = 0;
};

Simulated simulate(const Engine& engine, const std::string& text, bool run) {
  Session session(engine, {});
  const bool compiled = session.compile(text, "pick_and_place.rbt");
  if (compiled && !run) return {};
  if (!compiled || session.run().status != Progress::kDone) {
    std::fprintf(stderr, "The program does not run; try `armlet run`.\n");
    std::exit(1);
  }
  return {to_seconds(session.host()->now_ns()), session.host()->move_count()};
}

void print(const char* what, double nanoseconds, double kdl, double seconds) {
  std::printf("%-44s %9.2f ms %12.0f %14.0f\n", what, nanoseconds * 1e-6, nanoseconds / kdl,
              seconds / (nanoseconds * 1e-9));
}

}  // namespace
}  // namespace armlet::bench

int main(int argc, char** argv) {
  using namespace armlet::bench;
  const std::string text =
      text_of(argc > 1 ? argv[1] : ARMLET_BENCH "/programs/motion/pick_and_place.rbt");
  armlet::Engine engine;
  armlet::install(engine);
  const armlet::Robot puma = *armlet::make_robot("puma560");
  KdlArm peer = make_peer(puma);
  armlet::Random random(1);
  for (int k = 0; k < kConfigurations; ++k) {
    Eigen::VectorXd q(6);
    for (int i = 0; i < 6; ++i) q[i] = random.uniform(puma.lower()[i], puma.upper()[i]);
    peer.add_configuration(q.data());
  }
  const auto kdl = [&](int k) { return peer.pose(k % kConfigurations); };
  Simulated done;
  const auto first = [&](int) {
    done = simulate(engine, text, true);
    return done.seconds;
  };
  const double cold = nanoseconds_per_call(1, first);
  const Calls calls(1, kConfigurations);
  const Times whole = compare(
      calls, [&](int) { return simulate(engine, text, true).seconds; }, kdl, 31);
  const Times read = compare(
      calls, [&](int) { return simulate(engine, text, false).seconds; }, kdl, 31);
  std::printf("%d moves in %g s, every millisecond looked at\n", done.moves, done.seconds);
  std::printf("%-44s %12s %12s %14s\n", "", "time", "x KDL FK", "x real time");
  print("for the first time in a process", cold, whole.theirs, done.seconds);
  print("then, median (target 1500 x real time)", whole.ours, whole.theirs, done.seconds);
  print("  of which reading and checking it", read.ours, read.theirs, done.seconds);
}
