#pragma once
// Parts that several messages contain. Only for the sources that write JSON.

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "text_message.hpp"
#include "write_message.hpp"

namespace armlet::lab {

using OrderedJson = nlohmann::ordered_json;

inline OrderedJson json_of(TextPlace place) { return {place.line, place.column}; }
inline OrderedJson json_of(const TextSpan& span) {
  return {span.begin.line, span.begin.column, span.end.line, span.end.column};
}
inline OrderedJson json_of(int value) { return value; }
inline OrderedJson json_of(double value) { return value; }
template <class T>
OrderedJson json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : OrderedJson();
}
// Column by column.
inline OrderedJson matrix_json(const Eigen::Isometry3d& T) {
  OrderedJson out = OrderedJson::array();
  for (int i = 0; i < 16; ++i) out.push_back(T.matrix().data()[i]);
  return out;
}
inline OrderedJson affine_json(const Eigen::Affine3d& T) {
  OrderedJson out = OrderedJson::array();
  for (int i = 0; i < 16; ++i) out.push_back(T.matrix().data()[i]);
  return out;
}
inline OrderedJson pose_json(const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond turn(T.linear());
  const Eigen::Vector3d p = T.translation();
  return {p.x(), p.y(), p.z(), turn.w(), turn.x(), turn.y(), turn.z()};
}
OrderedJson json_of(const TextMessage& message);
// Numbers in SI; values of other types as texts.
OrderedJson value_json(const Value& value);
OrderedJson values_json(const std::vector<ElementValue>& values);

// Numbers that are not finite become null, invalid UTF-8 a replacement character.
inline Message message_of(const OrderedJson& json) {
  return {json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace), false};
}
inline OrderedJson answer(std::string_view type, Seq to) {
  OrderedJson out = {{"type", type}};
  if (to) out["to"] = *to;
  return out;
}

}  // namespace armlet::lab
