#pragma once

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "armlet/model/robot.hpp"
#include "kdl_arm.hpp"

namespace armlet::bench {

inline PlainPose to_plain(const Eigen::Isometry3d& T) {
  PlainPose plain{};
  for (Eigen::Index r = 0; r < 3; ++r) {
    for (Eigen::Index c = 0; c < 3; ++c) plain[static_cast<std::size_t>(3 * r + c)] = T(r, c);
    plain[static_cast<std::size_t>(9 + r)] = T(r, 3);
  }
  return plain;
}

// The arm as a chain of Orocos KDL, to compare times.
inline KdlArm make_peer(const Robot& robot) {
  const Chain& chain = robot.chain();
  const auto alpha = [&](std::size_t i) {
    return std::atan2(chain.sin_alpha[i], chain.cos_alpha[i]);
  };
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.rotate(Eigen::AngleAxisd(alpha(0), Eigen::Vector3d::UnitX()));
  X.translation().x() = chain.a[0];
  std::vector<KdlJoint> joints;
  for (std::size_t i = 0; i < static_cast<std::size_t>(chain.n); ++i) {
    const Eigen::Index k = static_cast<Eigen::Index>(i);
    joints.push_back({chain.revolute[i], chain.theta[i], chain.d[i], chain.a[i + 1], alpha(i + 1),
                      robot.lower()[k], robot.upper()[k]});
  }
  return {to_plain(robot.T_world_base() * X), joints, to_plain(robot.T_flange_tool())};
}

inline std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

// Prints the subject of the comparison and the head of the table; returns the robots of the command
// line, or the four of the documents.
inline std::vector<std::string> begin_comparison(int count, char** arguments) {
  std::printf("%s, g++ %s, %s, %s\n", processor().c_str(), __VERSION__, ARMLET_BENCH_FLAGS,
              ARMLET_BENCH_KDL);
  std::printf("%-10s %-24s %10s %10s %9s\n", "ns/call", "", "armlet", "KDL", "");
  std::vector<std::string> names(arguments + 1, arguments + count);
  if (names.empty()) names = {"puma560", "ur5", "panda", "scara"};
  return names;
}

}  // namespace armlet::bench
