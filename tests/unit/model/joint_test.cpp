#include "armlet/model/joint.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE("turning joints are shown in degrees and sliding ones in millimetres") {
  CHECK(format_joint_value(JointKind::kRevolute, std::numbers::pi / 2) == "90 deg");
  CHECK(format_joint_value(JointKind::kPrismatic, 0.15) == "150 mm");
  CHECK(joint_word(JointKind::kRevolute) == "turn");
  CHECK(joint_word(JointKind::kPrismatic) == "slide");
}
