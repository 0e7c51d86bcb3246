#include "kdl_dynamics.hpp"

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

namespace armlet::bench {
namespace {

// One segment for each joint: what is between the base and the first joint changes no force.
KDL::Chain make_chain(const std::vector<KdlJoint>& joints, const std::vector<KdlBody>& bodies) {
  KDL::Chain chain;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const KdlJoint& joint = joints[i];
    const KdlBody& body = bodies[i];
    const KDL::Frame tip =
        KDL::Frame(KDL::Rotation::RotZ(joint.theta), KDL::Vector(0, 0, joint.d)) *
        KDL::Frame(KDL::Rotation::RotX(joint.alpha), KDL::Vector(joint.a, 0, 0));
    const auto& I = body.inertia;
    const KDL::RigidBodyInertia inertia(body.mass,
                                        KDL::Vector(body.com[0], body.com[1], body.com[2]),
                                        KDL::RotationalInertia(I[0], I[1], I[2], I[3], I[4], I[5]));
    chain.addSegment(KDL::Segment(
        KDL::Joint(joint.revolute ? KDL::Joint::RotZ : KDL::Joint::TransZ), tip, inertia));
  }
  return chain;
}

}  // namespace

struct KdlDynamics::State {
  struct Motion {
    KDL::JntArray q, qd, qdd, tau;
  };

  State(const KDL::Chain& arm, const KDL::Vector& g)
      : n(arm.getNrOfJoints()),
        chain(arm),
        parameters(chain, g),
        inverse(chain, g),
        forward(chain, g),
        none(chain.getNrOfSegments(), KDL::Wrench::Zero()),
        forces(n),
        M(n) {}

  KDL::JntArray array(const double* values) const {
    KDL::JntArray result(n);
    for (unsigned i = 0; i < n; ++i) result(i) = values[i];
    return result;
  }
  Motion& motion(int k) { return motions[static_cast<std::size_t>(k)]; }

  unsigned n;
  KDL::Chain chain;
  KDL::ChainDynParam parameters;
  KDL::ChainIdSolver_RNE inverse;
  KDL::ChainFdSolver_RNE forward;
  KDL::Wrenches none;
  KDL::JntArray forces;
  KDL::JntSpaceInertiaMatrix M;
  std::vector<Motion> motions;
};

KdlDynamics::KdlDynamics(const std::vector<KdlJoint>& joints, const std::vector<KdlBody>& bodies,
                         const std::array<double, 3>& gravity)
    : state_(std::make_unique<State>(make_chain(joints, bodies),
                                     KDL::Vector(gravity[0], gravity[1], gravity[2]))) {}

KdlDynamics::~KdlDynamics() = default;

void KdlDynamics::add_motion(const double* q, const double* qd, const double* qdd,
                             const double* tau) {
  state_->motions.push_back(
      {state_->array(q), state_->array(qd), state_->array(qdd), state_->array(tau)});
}

double KdlDynamics::inverse(int k) {
  const auto& m = state_->motion(k);
  state_->inverse.CartToJnt(m.q, m.qd, m.qdd, state_->none, state_->forces);
  return state_->forces(0);
}

double KdlDynamics::gravity(int k) {
  state_->parameters.JntToGravity(state_->motion(k).q, state_->forces);
  return state_->forces(0);
}

double KdlDynamics::mass(int k) {
  state_->parameters.JntToMass(state_->motion(k).q, state_->M);
  return state_->M(0, 0);
}

double KdlDynamics::forward(int k) {
  const auto& m = state_->motion(k);
  state_->forward.CartToJnt(m.q, m.qd, m.tau, state_->none, state_->forces);
  return state_->forces(0);
}

std::vector<double> KdlDynamics::last_forces() const {
  std::vector<double> values;
  for (unsigned i = 0; i < state_->n; ++i) values.push_back(state_->forces(i));
  return values;
}

std::vector<double> KdlDynamics::last_mass() const {
  std::vector<double> values;
  for (unsigned c = 0; c < state_->n; ++c) {
    for (unsigned r = 0; r < state_->n; ++r) values.push_back(state_->M(r, c));
  }
  return values;
}

}  // namespace armlet::bench
