#include "armlet/model/joint.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE("revolute joints are shown in degrees and prismatic ones in millimetres") {
  CHECK(format_joint_value(JointKind::kRevolute, std::numbers::pi / 2) == "90 deg");
  CHECK(format_joint_value(JointKind::kPrismatic, 0.15) == "150 mm");
  CHECK(joint_word(JointKind::kRevolute) == "turn");
  CHECK(joint_word(JointKind::kPrismatic) == "slide");
}

TEST_CASE("a value beside another one has as many decimals as distinguish them") {
  constexpr double kDegree = std::numbers::pi / 180.0;
  CHECK(format_joint_value(JointKind::kRevolute, 140.03 * kDegree, 140.0 * kDegree) ==
        "140.03 deg");
  CHECK(format_joint_value(JointKind::kRevolute, 150.0 * kDegree, 140.0 * kDegree) == "150 deg");
  CHECK(format_joint_value(JointKind::kRevolute, 1.0, 1.0) ==
        format_joint_value(JointKind::kRevolute, 1.0));
  CHECK(format_joint_value(JointKind::kPrismatic, 0.1500004, 0.15) == "150.0004 mm");
}
