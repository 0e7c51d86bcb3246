#include "run_report.hpp"

#include <fmt/format.h>

#include "armlet/math/format_vector.hpp"
#include "console.hpp"

namespace armlet::cli {

static std::string seconds(double s) { return fmt::format("{:.2f} s", s); }

void show_summary(const Session& session, const std::string& trace, Progress status) {
  const Host& host = *session.host();
  const char* how = status == Progress::kDone        ? "finished"
                    : status == Progress::kCancelled ? "stopped by the user"
                                                     : "ended by an error";
  progress(fmt::format("{} at t = {}, {} move{}", how, seconds(to_seconds(host.now_ns())),
                       host.move_count(), host.move_count() == 1 ? "" : "s"));
  const World& world = host.cell().world();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    if (object.fixed) continue;
    const std::string where = place_text(host.cell(), object.name);
    progress(fmt::format("  {} at {}{}{}", object.name,
                         format_point_mm(object.T_world_obj.translation()),
                         where.empty() ? "" : ", ", where));
  }
  if (!trace.empty()) progress(fmt::format("  trace in {}", trace));
}

}  // namespace armlet::cli
