#include "recorded_drawings.hpp"

#include <algorithm>

namespace armlet::lab {

void RecordedDrawings::add(std::size_t number, const Row& row, bool is_kept) {
  LeftOut& left_out = left_out_[number];
  const std::size_t halvings = std::min<std::size_t>(rows_[0].count() / kMostRows, 20);
  if (!is_kept && ++left_out.count < std::size_t{1} << halvings) {
    left_out.newest = row;
    return;
  }
  left_out = {};
  rows_[0].add(row, true);
}

void RecordedDrawings::end(const std::string& name, double t) {
  const auto shown = shown_.find(name);
  if (shown == shown_.end()) return;
  add(shown->second, {t, static_cast<double>(shown->second)}, true);
  shown_.erase(shown);
}

void RecordedDrawings::take(const DrawingChanged& changed, double t,
                            const std::optional<TextSpan>& here) {
  const DrawingInfo& info = changed.drawing;
  if (changed.removed) return end(info.name, t);
  Key key{info.name, info.kind, info.text, info.color, info.robot, info.link, info.object};
  auto known = numbers_.find(key);
  if (known == numbers_.end()) {
    if (list_.size() >= kMostShapes) return;
    known = numbers_.emplace(std::move(key), list_.size()).first;
    list_.push_back({t, info, here});
    left_out_.emplace_back();
  }
  const std::size_t number = known->second;
  const auto shown = shown_.find(info.name);
  const bool is_new = shown == shown_.end() || shown->second != number;
  if (is_new) end(info.name, t);
  shown_[info.name] = number;
  const Eigen::Quaterniond turn(info.T_on_drawing.linear());
  const Eigen::Vector3d p = info.T_on_drawing.translation();
  add(number,
      {t, static_cast<double>(number), p.x(), p.y(), p.z(), turn.w(), turn.x(), turn.y(), turn.z(),
       info.size[0], info.size[1], info.size[2]},
      is_new);
}

void RecordedDrawings::flush() {
  for (std::size_t number = 0; number < left_out_.size(); ++number) {
    if (left_out_[number].newest) add(number, Row(*left_out_[number].newest), true);
  }
}

}  // namespace armlet::lab
