#include "run/run_report.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "armlet/math/format_vector.hpp"
#include "console/console.hpp"

namespace armlet::cli {

// The most bodies that the summary lists. The support of each is searched for, which takes
// quadratic time if all are close together; and nobody reads more lines.
constexpr std::size_t kListed = 100;

static std::string seconds(double s) { return fmt::format("{:.2f} s", s); }

void show_summary(const Session& session, const std::string& trace, Progress status) {
  const Host& host = *session.host();
  const char* how = status == Progress::kDone        ? "finished"
                    : status == Progress::kCancelled ? "stopped by the user"
                                                     : "ended by an error";
  progress(fmt::format("{} at t = {}, {} move{}", how, seconds(to_seconds(host.now_ns())),
                       host.move_count(), host.move_count() == 1 ? "" : "s"));
  const World& world = host.cell().world();
  std::size_t movable = 0;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    if (object.fixed || ++movable > kListed) continue;
    const std::string where = place_text(host.cell(), object.name);
    progress(fmt::format("  {} at {}{}{}", object.name,
                         format_point_mm(object.T_world_obj.translation()),
                         where.empty() ? "" : ", ", where));
  }
  if (movable > kListed) {
    progress(fmt::format("  and {} more object{}", movable - kListed,
                         movable == kListed + 1 ? "" : "s"));
  }
  if (!trace.empty()) progress(fmt::format("  trace in {}", trace));
}

}  // namespace armlet::cli
