#include "run_report.hpp"

#include <fmt/format.h>

#include "armlet/math/format_vector.hpp"
#include "console.hpp"

namespace armlet::cli {

static std::string seconds(double s) { return fmt::format("{:.2f} s", s); }

void show_move(const MoveReport& move) {
  const double end = move.start + move.duration;
  progress(fmt::format("[t = {}] {} {} {}{}, hand at {}", seconds(end), move.robot, move.function,
                       seconds(move.duration), move.stopped ? " (stopped)" : "",
                       format_point_mm(move.T_world_tool.translation())));
}

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
    std::string where = world.resting_on(object.name);
    if (const auto& held = world.attachment(object.name); held && held->on.empty())
      where = fmt::format("held by {}", host.cell().robot(held->carrier).name);
    else if (!where.empty())
      where = "on " + where;
    progress(fmt::format("  {} at {}{}{}", object.name,
                         format_point_mm(object.T_world_obj.translation()),
                         where.empty() ? "" : ", ", where));
  }
  if (!trace.empty()) progress(fmt::format("  trace in {}", trace));
}

}  // namespace armlet::cli
