// A thousand programs at the same time, in four threads: one engine, one compiled program for all
// of them, and a Vm with its own variables, memory and limits for each.
#include <armlet/interpreter/host.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

namespace {

constexpr int kSessions = 1000;
constexpr int kThreads = 4;

constexpr const char* kProgram = R"(
  var id = 0
  var visits: string[] = []
  fn visit(who: string) -> int {
    visits.push(who)
    return id * visits.length
  }
)";

}  // namespace

int main() {
  const armlet::Engine engine;
  const armlet::Compilation compiled = engine.compile(kProgram, "visits.rbt");
  std::cout << compiled.text();
  if (!compiled.program) return 1;

  std::vector<std::unique_ptr<armlet::Vm>> sessions;
  for (int i = 0; i < kSessions; ++i) {
    const armlet::VmOptions options{.limits = {.steps = 10'000, .heap_bytes = 1U << 20U}};
    sessions.push_back(std::make_unique<armlet::Vm>(compiled.program, options));
    if (sessions.back()->run().status != armlet::Progress::kDone) return 1;
    sessions.back()->set("id", i);
  }

  std::vector<std::int64_t> sums(kThreads);
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (int i = t; i < kSessions; i += kThreads) {
        const auto visit = sessions[i]->function<std::int64_t(std::string)>("visit");
        for (const char* who : {"Ada", "Grace", "Karen"})
          if (const auto answer = visit(who)) sums[t] += *answer;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::int64_t sum = std::accumulate(sums.begin(), sums.end(), std::int64_t{0});
  std::printf("%d sessions: %lld\n", kSessions, static_cast<long long>(sum));  // 6 * 999 * 1000 / 2
}

// Prints:
// 1000 sessions: 2997000
