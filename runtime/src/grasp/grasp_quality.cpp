#include "armlet/grasp/grasp_quality.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/math/det_math.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

void check_contacts(std::span<const GraspContact> contacts, double scale) {
  if (!(scale > 0.0) || !std::isfinite(scale))
    throw ArgumentError(fmt::format("Moments are divided by {} m; expected more than 0.", scale));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const GraspContact& each = contacts[i];
    if (!(each.friction >= 0.0) || !std::isfinite(each.friction)) {
      throw ArgumentError(
          fmt::format("Contact {} has the friction {}; expected 0 or more.", i + 1, each.friction));
    }
    if (!each.p.allFinite() || !(std::abs(each.inward.norm() - 1.0) < 1e-6))
      throw ArgumentError(
          fmt::format("Contact {} needs a point and a unit vector into the body.", i + 1));
  }
}

// Two unit vectors orthogonal to n: the first is computed from the axis on which n has its smallest
// component.
std::array<Vector3d, 2> across(const Vector3d& n) {
  Eigen::Index least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Vector3d t = n.cross(Vector3d::Unit(least)).normalized();
  return {t, n.cross(t)};
}

Vector6d wrench_of(const GraspContact& contact, const Vector3d& force, const Vector3d& center,
                   double scale) {
  Vector6d wrench;
  wrench << force, (contact.p - center).cross(force) / scale;
  return wrench;
}

// The wrench of a contact with a normal force of 1 N, along each edge of its pyramid.
MatrixXd edges_of(const GraspContact& contact, const Vector3d& center, double scale) {
  const auto [t, b] = across(contact.inward);
  const int count = contact.friction > 0.0 ? kConeEdges : 1;
  MatrixXd edges(6, count);
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * kPi * k / kConeEdges;
    const Vector3d along = det::cos(angle) * t + det::sin(angle) * b;
    edges.col(k) = wrench_of(contact, contact.inward + contact.friction * along, center, scale);
  }
  return edges;
}

MatrixXd edges_of(std::span<const GraspContact> contacts, const Vector3d& center, double scale) {
  MatrixXd all(6, 0);
  for (const GraspContact& each : contacts) {
    const MatrixXd edges = edges_of(each, center, scale);
    all.conservativeResize(Eigen::NoChange, all.cols() + edges.cols());
    all.rightCols(edges.cols()) = edges;
  }
  return all;
}

double smallest_singular(const MatrixXd& G) {
  if (G.cols() < G.rows()) return 0.0;  // some load cannot be balanced by any forces
  const Eigen::VectorXd s = singular_values(G).s;
  const double least = s[s.size() - 1];
  return least > 1e-9 * s[0] ? least : 0.0;
}

GraspQuality quality_of(const MatrixXd& edges, const MatrixXd& G, std::size_t contacts) {
  GraspQuality quality{.epsilon = ball_in_hull(edges),
                       .min_singular = smallest_singular(G),
                       .contacts = static_cast<int>(contacts)};
  quality.force_closure = quality.epsilon > 0.0;
  return quality;
}

// The smallest distance |A x - b| over all x >= 0.
//
// source  C. L. Lawson, R. J. Hanson, Solving Least Squares Problems, 1974, chapter 23.
double nonnegative_distance(const MatrixXd& A, const Eigen::VectorXd& b) {
  const Eigen::Index n = A.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Index> used;
  const auto solve = [&] {
    MatrixXd part(A.rows(), static_cast<Eigen::Index>(used.size()));
    for (std::size_t i = 0; i < used.size(); ++i)
      part.col(static_cast<Eigen::Index>(i)) = A.col(used[i]);
    return nearest_solution(part, b);
  };
  for (Eigen::Index turn = 0; turn < 3 * n; ++turn) {
    Eigen::VectorXd gain = A.transpose() * (b - A * x);
    for (const Eigen::Index each : used) gain[each] = 0.0;
    Eigen::Index best = 0;
    if (!(gain.maxCoeff(&best) > 1e-12 * b.norm())) break;
    used.push_back(best);
    Eigen::VectorXd z = solve();
    while (!used.empty() && z.minCoeff() <= 0.0) {
      double step = 1.0;
      for (std::size_t i = 0; i < used.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        if (z[k] <= 0.0) step = std::min(step, x[used[i]] / (x[used[i]] - z[k]));
      }
      for (std::size_t i = 0; i < used.size(); ++i)
        x[used[i]] += step * (z[static_cast<Eigen::Index>(i)] - x[used[i]]);
      std::erase_if(used, [&](Eigen::Index each) {
        if (x[each] > 1e-14) return false;
        x[each] = 0.0;
        return true;
      });
      if (!used.empty()) z = solve();
    }
    for (std::size_t i = 0; i < used.size(); ++i) x[used[i]] = z[static_cast<Eigen::Index>(i)];
  }
  return (b - A * x).norm();
}

}  // namespace

GraspQuality grasp_quality(std::span<const GraspContact> contacts, const Vector3d& center,
                           double scale) {
  check_contacts(contacts, scale);
  check_finite("center", center);
  MatrixXd G(6, 0);
  for (const GraspContact& each : contacts) {
    const auto [t, b] = across(each.inward);
    for (int k = 0; k < (each.friction > 0.0 ? 3 : 1); ++k) {
      G.conservativeResize(Eigen::NoChange, G.cols() + 1);
      G.rightCols(1) = wrench_of(each, k == 0 ? each.inward : k == 1 ? t : b, center, scale);
    }
  }
  return quality_of(edges_of(contacts, center, scale), G, contacts.size());
}

GraspQuality planar_grasp_quality(std::span<const GraspContact> contacts,
                                  const Eigen::Vector2d& center, double scale) {
  check_contacts(contacts, scale);
  check_finite("center", center);
  MatrixXd edges(3, 0), G(3, 0);
  const auto append = [](MatrixXd& to, const Vector6d& wrench) {
    to.conservativeResize(Eigen::NoChange, to.cols() + 1);
    to.rightCols(1) << wrench[0], wrench[1], wrench[5];
  };
  const Vector3d middle(center.x(), center.y(), 0.0);
  for (const GraspContact& each : contacts) {
    const Vector3d n = each.inward, t = Vector3d::UnitZ().cross(n);
    if (std::abs(n.z()) > 1e-9 || std::abs(each.p.z()) > 1e-9)
      throw ArgumentError("Contacts of a body in the plane have z = 0.");
    append(G, wrench_of(each, n, middle, scale));
    if (each.friction > 0.0) append(G, wrench_of(each, t, middle, scale));
    for (const double side : {-1.0, 1.0})
      append(edges, wrench_of(each, n + side * each.friction * t, middle, scale));
  }
  return quality_of(edges, G, contacts.size());
}

double load_factor(std::span<const GraspContact> contacts, std::span<const double> presses,
                   const Vector3d& center, double scale, const Vector6d& load) {
  check_contacts(contacts, scale);
  check_size("presses", static_cast<Eigen::Index>(presses.size()),
             static_cast<Eigen::Index>(contacts.size()));
  check_finite("load", load);
  Vector6d scaled = load;
  scaled.tail<3>() /= scale;
  constexpr double kMost = 1000.0;
  const double size = scaled.norm();
  if (!(size > 0.0)) return kMost;
  // Unknowns: weights x >= 0 of the edges, and for each contact the unused part of its normal
  // force.
  const auto k = static_cast<Eigen::Index>(contacts.size());
  MatrixXd A = MatrixXd::Zero(6 + k, 0);
  for (Eigen::Index i = 0; i < k; ++i) {
    const double press = presses[static_cast<std::size_t>(i)];
    if (!(press >= 0.0) || !std::isfinite(press))
      throw ArgumentError(fmt::format("Contact {} presses with {} N.", i + 1, press));
    const MatrixXd edges = edges_of(contacts[static_cast<std::size_t>(i)], center, scale);
    MatrixXd columns = MatrixXd::Zero(6 + k, edges.cols() + 1);
    columns.topLeftCorner(6, edges.cols()) = press / size * edges;
    columns.row(6 + i).setOnes();
    A.conservativeResize(Eigen::NoChange, A.cols() + columns.cols());
    A.rightCols(columns.cols()) = columns;
  }
  const auto holds = [&](double factor) {
    Eigen::VectorXd b(6 + k);
    b << -factor / size * scaled, Eigen::VectorXd::Ones(k);
    return nonnegative_distance(A, b) < 1e-7 * (1.0 + factor);
  };
  if (holds(kMost)) return kMost;
  double held = 0.0, lost = kMost;
  // First the order of magnitude, then bisection.
  while (lost > 1e-6 && !holds(lost / 2.0)) lost /= 2.0;
  if (lost <= 1e-6) return 0.0;
  held = lost / 2.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (held + lost);
    (holds(middle) ? held : lost) = middle;
  }
  return held;
}

}  // namespace armlet
