#pragma once

#include <Eigen/Geometry>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "armlet/model/robot.hpp"

// Reads the arms and samples of tests/reference/robots; see the README there for the conventions.
namespace armlet::reference {

using Json = nlohmann::json;

inline const std::vector<std::string>& arm_names() {
  static const std::vector<std::string> names = {"gen_mod_prrr", "gen_mod_rrprpr",
                                                 "gen_std_prrp", "gen_std_rprrpr",
                                                 "pa10_6",       "pa10_7",
                                                 "panda",        "puma560",
                                                 "rrr3",         "scara_rrpr",
                                                 "scorbot_er4u", "stanford",
                                                 "twolink",      "ur5"};
  return names;
}

inline Json load(const std::string& name) {
  std::ifstream file(std::string(ARMLET_REFERENCE_DIR) + "/robots/" + name + ".json");
  return Json::parse(file);
}

inline Eigen::VectorXd vector_of(const Json& json) {
  const std::vector<double> values = json.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

inline Eigen::MatrixXd matrix_of(const Json& json) {
  const Eigen::Index rows = static_cast<Eigen::Index>(json.size());
  Eigen::MatrixXd M(rows, static_cast<Eigen::Index>(json.at(0).size()));
  for (Eigen::Index r = 0; r < rows; ++r) {
    M.row(r) = vector_of(json.at(static_cast<std::size_t>(r))).transpose();
  }
  return M;
}

// A pose written as 3x4 or 4x4.
inline Eigen::Isometry3d pose_of(const Json& json) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.matrix().topRows<3>() = matrix_of(json).topRows<3>();
  return T;
}

inline Joint joint_of(const Json& json) {
  Joint joint;
  const double offset = json.at("offset");
  joint.dh = {json.at("theta"), json.at("d"), json.at("a"), json.at("alpha")};
  if (json.at("joint") == "R") {
    joint.dh.theta = offset;
  } else {
    joint.kind = JointKind::kPrismatic;
    joint.dh.d = offset;
  }
  joint.lower = json.at("qmin");
  joint.upper = json.at("qmax");
  return joint;
}

inline Link link_of(const Json& json) {
  Link link;
  link.mass = json.at("m");
  link.com = vector_of(json.at("com"));
  link.inertia = matrix_of(json.at("I"));
  link.motor_inertia = json.at("Jm");
  link.gear = json.at("G");
  link.friction = {json.at("B"), json.at("Tc_pos"), json.at("Tc_neg")};
  return link;
}

inline Robot robot_of(const Json& json) {
  RobotSpec spec;
  spec.name = json.at("name");
  spec.convention =
      json.at("convention") == "standard" ? DhConvention::kStandard : DhConvention::kModified;
  spec.inertia_check = InertiaCheck::kPublished;
  spec.gravity = vector_of(json.at("gravity"));
  spec.T_world_base = pose_of(json.at("base"));
  spec.T_flange_tool = pose_of(json.at("tool"));
  for (const Json& row : json.at("links")) {
    spec.joints.push_back(joint_of(row));
    spec.links.push_back(link_of(row));
  }
  return Robot(spec);
}

}  // namespace armlet::reference
