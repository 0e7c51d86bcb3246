#pragma once
// The values and handles that the library adds to the language: posJ, posC, robot, object, shape,
// tool ...

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "armlet/interpreter/define.hpp"
#include "armlet/interpreter/resource.hpp"
#include "armlet/model/joint.hpp"
#include "armlet/model/link.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/model/tool.hpp"
#include "armlet/world/object.hpp"

namespace armlet {
class Cell;
}

namespace armlet::bind {

// Joint values, SI. Their kinds, known if the robot is known, decide how they are printed.
struct PosJ {
  std::uint8_t n = 0;
  bool kinds_known = false;
  std::array<bool, kMaxJoints> turns{};
  std::array<double, kMaxJoints> q{};

  [[nodiscard]] Eigen::VectorXd vector() const {
    return Eigen::Map<const Eigen::VectorXd>(q.data(), n);
  }
};
[[nodiscard]] PosJ make_posj(const Robot& robot, const Eigen::VectorXd& q);

// A position and orientation in the world. A pose made from a position only has no orientation of
// its own (language reference, section 8.6).
struct PosC {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  bool has_orientation = false;
};

struct RobotRef {
  int id = 0;                  // in the cell
  const Cell* cell = nullptr;  // it outlives the values of its programs
};
struct ObjectRef {
  std::string name;
};
struct FrameRef {
  std::string name;
};
// A finger of a hand, counted from 1.
struct FingerRef {
  int id = 0;    // in the cell
  int hand = 0;  // in the cell
  int number = 1;
};
struct ShapeValue {
  Shape shape;
};
struct ToolValue {
  Tool tool;
  std::optional<Eigen::Isometry3d> T_flange_tool;  // set by tcp(p): any tool point
};
struct JointRow {
  Joint joint;
  Link link;
};

// A shape of a link; link 0 is the base. `mesh` is a file that replaces the kind and size of the
// solid; `unit` 0: as the file says.
struct BodyRow {
  std::int64_t link = 0;
  LinkSolid solid{};
  std::string mesh{};
  double unit = 0.0;
  double scale = 1.0;
};

// A robot as a resource, with the name used in failures and by tasks that wait for it.
[[nodiscard]] Resource robot_called(std::string name);

extern const HostType kPosJ;
extern const HostType kPosC;
extern const HostType kRobot;
extern const HostType kObject;
extern const HostType kFrame;
extern const HostType kShape;
extern const HostType kTool;
extern const HostType kJointRow;
extern const HostType kBodyRow;
extern const HostType kTrajectory;
extern const HostType kFinger;
extern const HostType kImage;
extern const HostType kCamera;
extern const HostType kTracker;

[[nodiscard]] Obj* new_posj(Vm& vm, const PosJ& q);
[[nodiscard]] Obj* new_posc(Vm& vm, const PosC& p);
[[nodiscard]] inline const PosJ& posj(Slot s) { return host_value<PosJ>(s); }
[[nodiscard]] inline const PosC& posc(Slot s) { return host_value<PosC>(s); }

// "(300, 120, 20) mm", with the orientation if there is one, and "posJ(0 deg, 20 mm)".
[[nodiscard]] std::string posc_text(const PosC& p);
[[nodiscard]] std::string posj_text(const PosJ& q);

}  // namespace armlet::bind

// The types of the language for these C++ values, for functions declared with `def`.
namespace armlet {
template <>
inline constexpr const HostType* kHostType<bind::PosJ> = &bind::kPosJ;
template <>
inline constexpr const HostType* kHostType<bind::PosC> = &bind::kPosC;
template <>
inline constexpr const HostType* kHostType<bind::RobotRef> = &bind::kRobot;
template <>
inline constexpr const HostType* kHostType<bind::ObjectRef> = &bind::kObject;
template <>
inline constexpr const HostType* kHostType<bind::FrameRef> = &bind::kFrame;
template <>
inline constexpr const HostType* kHostType<bind::FingerRef> = &bind::kFinger;
template <>
inline constexpr const HostType* kHostType<bind::ShapeValue> = &bind::kShape;
template <>
inline constexpr const HostType* kHostType<bind::ToolValue> = &bind::kTool;
template <>
inline constexpr const HostType* kHostType<bind::JointRow> = &bind::kJointRow;
template <>
inline constexpr const HostType* kHostType<bind::BodyRow> = &bind::kBodyRow;
}  // namespace armlet
