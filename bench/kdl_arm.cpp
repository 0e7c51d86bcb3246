#include "kdl_arm.hpp"

#include <cmath>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <optional>

namespace armlet::bench {
namespace {

KDL::Frame to_kdl(const PlainPose& T) {
  return {KDL::Rotation(T[0], T[1], T[2], T[3], T[4], T[5], T[6], T[7], T[8]),
          KDL::Vector(T[9], T[10], T[11])};
}

// Makes a chain with as few segments as possible.
KDL::Chain make_chain(const PlainPose& base, const std::vector<KdlJoint>& joints,
                      const PlainPose& tool) {
  KDL::Chain chain;
  const KDL::Frame T_base = to_kdl(base);
  if (!KDL::Equal(T_base, KDL::Frame::Identity(), 1e-15)) {
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::Fixed), T_base));
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const KdlJoint& joint = joints[i];
    KDL::Frame tip = KDL::Frame(KDL::Rotation::RotZ(joint.theta), KDL::Vector(0, 0, joint.d)) *
                     KDL::Frame(KDL::Rotation::RotX(joint.alpha), KDL::Vector(joint.a, 0, 0));
    if (i + 1 == joints.size()) tip = tip * to_kdl(tool);
    const auto type = joint.revolute ? KDL::Joint::RotZ : KDL::Joint::TransZ;
    chain.addSegment(KDL::Segment(KDL::Joint(type), tip));
  }
  return chain;
}

}  // namespace

struct KdlArm::State {
  State(const PlainPose& base, const std::vector<KdlJoint>& arm, const PlainPose& tool)
      : chain(make_chain(base, arm, tool)),
        joints(arm),
        fk(chain),
        jac(chain),
        frames(chain.getNrOfSegments()),
        J(static_cast<unsigned>(arm.size())),
        q(static_cast<unsigned>(arm.size())) {}

  // Shifts angles by whole revolutions into the limits; false if a joint stays outside.
  bool wrap_into_limits() {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      double& value = q(static_cast<unsigned>(i));
      const double turn = 2.0 * M_PI;
      if (joints[i].revolute) value -= turn * std::ceil((value - joints[i].upper) / turn);
      if (value < joints[i].lower || value > joints[i].upper) return false;
    }
    return true;
  }

  double random() {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(seed >> 11) * 0x1p-53;
  }

  KDL::Chain chain;
  std::vector<KdlJoint> joints;
  KDL::ChainFkSolverPos_recursive fk;
  KDL::ChainJntToJacSolver jac;
  std::optional<KDL::ChainIkSolverPos_LMA> lma;
  int iterations = 0;
  KDL::Frame frame;
  std::vector<KDL::Frame> frames;
  KDL::Jacobian J;
  KDL::JntArray q;
  std::vector<KDL::JntArray> configurations;
  std::vector<KDL::Frame> goals;
  std::uint64_t seed = 1;
};

KdlArm::KdlArm(const PlainPose& base, const std::vector<KdlJoint>& joints, const PlainPose& tool)
    : state_(std::make_unique<State>(base, joints, tool)) {}

KdlArm::~KdlArm() = default;

void KdlArm::add_configuration(const double* q) {
  KDL::JntArray array(static_cast<unsigned>(state_->joints.size()));
  for (unsigned i = 0; i < array.rows(); ++i) array(i) = q[i];
  state_->configurations.push_back(array);
}

void KdlArm::add_goal(const PlainPose& T_world_tool) {
  state_->goals.push_back(to_kdl(T_world_tool));
}

void KdlArm::change_first_joint(int k, double amount) {
  state_->configurations[static_cast<std::size_t>(k)](0) += amount;
}

double KdlArm::pose(int k) {
  state_->fk.JntToCart(state_->configurations[static_cast<std::size_t>(k)], state_->frame);
  return state_->frame.p(0);
}

double KdlArm::frames(int k) {
  state_->fk.JntToCart(state_->configurations[static_cast<std::size_t>(k)], state_->frames);
  return state_->frames.back().p(0);
}

double KdlArm::jacobian(int k) {
  state_->jac.JntToJac(state_->configurations[static_cast<std::size_t>(k)], state_->J);
  return state_->J(0, 0);
}

PlainPose KdlArm::last_pose() const {
  PlainPose T{};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) T[static_cast<std::size_t>(3 * r + c)] = state_->frame.M(r, c);
    T[static_cast<std::size_t>(9 + r)] = state_->frame.p(r);
  }
  return T;
}

std::vector<double> KdlArm::last_jacobian() const {
  std::vector<double> values;
  for (unsigned c = 0; c < state_->J.columns(); ++c) {
    for (unsigned r = 0; r < 6; ++r) values.push_back(state_->J(r, c));
  }
  return values;
}

bool KdlArm::solve(int k, const std::vector<double>& start, double tolerance, int iterations,
                   int restarts) {
  State& s = *state_;
  if (s.iterations != iterations) {
    s.lma.emplace(s.chain, Eigen::Matrix<double, 6, 1>::Ones(), tolerance, iterations);
    s.iterations = iterations;
  }
  KDL::JntArray from(static_cast<unsigned>(start.size()));
  for (unsigned i = 0; i < from.rows(); ++i) from(i) = start[i];
  for (int restart = 0; restart < restarts; ++restart) {
    if (s.lma->CartToJnt(from, s.goals[static_cast<std::size_t>(k)], s.q) == 0 &&
        s.wrap_into_limits()) {
      return true;
    }
    for (unsigned i = 0; i < from.rows(); ++i) {
      const KdlJoint& joint = s.joints[i];
      from(i) = joint.lower + (joint.upper - joint.lower) * s.random();
    }
  }
  return false;
}

}  // namespace armlet::bench
