#include "kdl_dynamics.hpp"

#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

namespace armlet::bench {
namespace {

// One segment for each joint: the part between base and first joint does not change forces.
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

// Solves M x = b by the factors L D L' of a symmetric matrix, in place: for so few rows faster than
// Eigen's and KDL's own, each of which costs more than all the rest.
void solve(Eigen::MatrixXd& M, Eigen::VectorXd& b) {
  const Eigen::Index n = b.size();
  for (Eigen::Index k = 0; k < n; ++k) {
    const double inverse = 1.0 / M(k, k);
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const double l = M(i, k) * inverse;
      for (Eigen::Index j = i; j < n; ++j) M(j, i) -= l * M(j, k);
      b[i] -= l * b[k];
    }
  }
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    double sum = b[k];
    for (Eigen::Index i = k + 1; i < n; ++i) sum -= M(i, k) * b[i];
    b[k] = sum / M(k, k);
  }
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
        none(chain.getNrOfSegments(), KDL::Wrench::Zero()),
        none_yet(n),
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
  KDL::Wrenches none;
  KDL::JntArray none_yet;  // no acceleration
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
  State& s = *state_;
  s.parameters.JntToMass(m.q, s.M);
  s.inverse.CartToJnt(m.q, m.qd, s.none_yet, s.none, s.forces);
  for (unsigned i = 0; i < s.n; ++i) s.forces(i) = m.tau(i) - s.forces(i);
  solve(s.M.data, s.forces.data);
  return s.forces(0);
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
