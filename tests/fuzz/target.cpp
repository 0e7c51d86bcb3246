#include "target.hpp"

#include <cstdio>
#include <cstdlib>

#include "armlet/interpreter/render.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"

namespace armlet::fuzz {
namespace {

constexpr std::int64_t kEndOfTime = 60'000'000'000;  // ns

}  // namespace

SessionOptions small_session() {
  static const std::shared_ptr<const Robot> scara = make_robot("scara");
  SessionOptions options;
  options.robot = scara;
  options.default_world = table_world();
  options.limits = {
      .steps = 5'000, .heap_bytes = 1U << 20U, .call_depth = 100, .output_bytes = 1U << 14U};
  options.pace = [](std::int64_t t_ns) { return t_ns < kEndOfTime; };
  return options;
}

void show_all(const Session& session) {
  for (const Problem& problem : session.problems()) {
    demand(!render_text(problem.diagnostic, *problem.sources).empty(), "a message has a text");
    demand(!render_json(problem.diagnostic, *problem.sources).empty(), "a message has a JSON form");
  }
}

void demand(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "a promise is broken: %s\n", promise);
  std::abort();
}

std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace armlet::fuzz
