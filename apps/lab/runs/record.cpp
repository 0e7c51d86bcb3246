#include "record.hpp"

#include <algorithm>

#include "armlet/cell/clock.hpp"

namespace armlet::lab {

void Rows::add(std::span<const double> row, bool is_kept) {
  if (!is_kept && ++skipped_ < stride_) return;
  skipped_ = 0;
  values_.insert(values_.end(), row.begin(), row.end());
  if (count() >= kMost * 2 && count() % kMost == 0) stride_ *= 2;
  if (count() == kMost) stride_ = 2;
}

bool is_plot(const Figure& figure) {
  if (figure.picture != nullptr || figure.is_spatial() || !figure.names.empty()) return false;
  return std::ranges::all_of(figure.panels, is_plot) &&
         std::ranges::none_of(figure.series,
                              [](const Series& each) { return each.kind == SeriesKind::kBars; });
}

std::size_t values_of(const Figure& figure) {
  std::size_t count = 0;
  for (const Figure& panel : figure.panels) count += values_of(panel);
  for (const Series& series : figure.series) count += series.x.size() + series.y.size();
  return count;
}

std::size_t RunRecord::bytes() const {
  std::size_t sum = 0;
  for (const Rows& each : robot_rows) sum += each.bytes();
  for (const Rows& each : force_rows) sum += each.bytes();
  for (const Rows& each : contact_rows) sum += each.bytes();
  for (const Rows& each : object_rows) sum += each.bytes();
  for (const RecordedText& each : texts) sum += sizeof(each) + each.text.size();
  for (const TextMessage& each : advice)
    sum += sizeof(each) + each.message.size() + each.why.size();
  for (const RecordedFigure& each : figures)
    sum += each.svg.size() + (each.plot ? sizeof(double) * values_of(*each.plot) : 0);
  for (const RecordedWay& each : ways)
    sum += sizeof(each) + each.path.size() * sizeof(Eigen::Vector3d) + each.arms.size() * 64;
  return sum + drawings.bytes() + file_bytes + stretches.size() * sizeof(RecordedStretch) +
         moves.size() * sizeof(RecordedMove) + lines.size() * sizeof(RecordedLine) +
         events.size() * sizeof(RecordedChange);
}

int RunRecord::line_at(double t) const {
  const auto behind = std::ranges::upper_bound(lines, t, {}, &RecordedLine::t);
  return behind == lines.begin() ? 0 : std::prev(behind)->line;
}

std::optional<int> RunRecord::find_robot(std::string_view name) const {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots[i].info.name == name) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::shared_ptr<const Robot> RunRecord::model_at(int robot, double t) const {
  const RecordedRobot& known = robots[static_cast<std::size_t>(robot)];
  std::shared_ptr<const Robot> model = known.model;
  for (const RobotChange& change : known.changes) {
    if (change.t <= t && change.model != nullptr) model = change.model;
  }
  return model;
}

std::vector<double> RunRecord::joints_at(int robot, double t) const {
  const auto index = static_cast<std::size_t>(robot);
  const Rows& rows = robot_rows[index];
  std::size_t first = 0;
  std::size_t count = rows.count();
  while (count > 0) {  // binary search for the first row after t
    const std::size_t half = count / 2;
    if (rows.rows(first + half, 1)[0] <= t) {
      first += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  const std::size_t n = robots[index].info.joints.size();
  if (first == 0) return robots[index].info.home;
  const std::span<const double> row = rows.rows(first - 1, 1);
  return {row.begin() + 1, row.begin() + 1 + static_cast<std::ptrdiff_t>(n)};
}

}  // namespace armlet::lab
