#include "branches.hpp"

namespace armlet {
namespace {

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

// An elbow in which a link, or the line to the target, has length zero: its angle is undetermined.
Elbow elbow_without_length(const Links& links, double X, double Y, const Angle& x1,
                           const Angle& x2) {
  const auto& [lx, ly, mx, my] = links;
  const bool first = length_of(lx, ly) >= kNoLength;
  const bool second = length_of(mx, my) >= kNoLength;
  Elbow out{.count = 1, .free = true, .x1 = {x1, x1}, .x2 = {x2, x2}};
  bool whole = true;
  if (first && second) {
    out.x2[0] = angle_from_to(mx, my, -lx, -ly, whole);
    out.open1 = true;
  } else if (first) {
    out.x1[0] = angle_from_to(lx, ly, X, Y, whole);
    out.open2 = true;
  } else if (second) {
    out.x2[0] = inverse(x1) * angle_from_to(mx, my, X, Y, whole);
    out.open1 = true;
  }
  return out;
}

}  // namespace

Elbow solve_elbow(const Links& links, double X, double Y, const Angle& x1_if_free,
                  const Angle& x2_if_free) {
  const auto& [lx, ly, mx, my] = links;
  Elbow out;
  const double l = length_of(lx, ly);
  const double m = length_of(mx, my);
  const double R = length_of(X, Y);
  const double size = l + m;
  const double miss = std::fmax(R - size, std::abs(l - m) - R);
  if (miss > kClosedSlack * (size + R + 1.0)) return out;
  const double shortest = std::fmin(R, std::fmin(l, m));
  if (shortest < kNoLength) {
    return elbow_without_length(links, X, Y, x1_if_free, x2_if_free);
  }
  // Heron's formula: (1 - c)(1 + c) as a product of lengths keeps all digits where the arm is
  // stretched or folded.
  const double h2 = std::fmax(0.0, (size - R) * (size + R) * (R - (l - m)) * (R + (l - m)));
  const double scale = 1.0 / (2.0 * l * m);
  const double c = std::fmax(-1.0, std::fmin(1.0, (R * R - l * l - m * m) * scale));
  const double s = std::sqrt(h2) * scale;
  out.count = h2 == 0.0 ? 1 : 2;
  out.free = shortest < kNearAxis;
  for (std::size_t i = 0; i < 2; ++i) {
    const double si = i == 0 ? s : -s;
    // The angle from the direction of l to that of m, rotated by x2, has cosine c and sine si.
    const double ux = (lx * c - ly * si) / l;
    const double uy = (ly * c + lx * si) / l;
    bool whole = true;
    out.x2[i] = angle_from_to(mx, my, ux, uy, whole);
    out.x1[i] = angle_from_to(lx + m * ux, ly + m * uy, X, Y, whole);
  }
  return out;
}

Euler solve_euler(const Eigen::Matrix3d& M, const Angle& alpha, const Angle& beta,
                  const Angle& x1_if_free) {
  Euler out;
  const double ss = alpha.s * beta.s;
  double c = (alpha.c * beta.c - M(2, 2)) / ss;
  if (std::abs(c) > 1.0 + kClosedSlack) return out;
  double s = 0.0;
  if (alpha.c == 0.0 && beta.c == 0.0) {
    // sin x2 is computed from entries of the matrix: no digits are lost near the singularity.
    s = 0.5 * (std::sqrt(M(0, 2) * M(0, 2) + M(1, 2) * M(1, 2)) +
               std::sqrt(M(2, 0) * M(2, 0) + M(2, 1) * M(2, 1)));
    const double r = std::sqrt(c * c + s * s);
    c /= r;
    s /= r;
  } else {
    c = std::fmax(-1.0, std::fmin(1.0, c));
    s = std::sqrt((1.0 - c) * (1.0 + c));
  }
  out.count = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    const double si = i == 0 ? s : -s;
    out.x2[i] = {c, si};
    bool whole1 = true;
    bool whole3 = true;
    const double ux = beta.s * si;
    const double uy = -alpha.c * beta.s * c - alpha.s * beta.c;
    const double vx = alpha.s * si;
    const double vy = alpha.s * c * beta.c + alpha.c * beta.s;
    const double near1 = ux * ux + uy * uy;
    out.singular = out.singular || near1 < kNearAxis * kNearAxis;
    if (near1 < 1e-20) {
      out.count = 1;
      out.open = true;
      out.x1[i] = x1_if_free;
      // Rz(x3) = (Rz(x1) Rx(alpha) Rz(x2) Rx(beta))^T M; its first column gives x3.
      const Eigen::Vector3d m =
          rotated_back(out.x2[i], beta, rotated_back(out.x1[i], alpha, Eigen::Vector3d(M.col(0))));
      out.x3[i] = angle_from_to(1.0, 0.0, m.x(), m.y(), whole3);
      break;
    }
    out.x1[i] = angle_from_to(ux, uy, M(0, 2), M(1, 2), whole1);
    out.x3[i] = angle_from_to(M(2, 0), M(2, 1), vx, vy, whole3);
  }
  return out;
}

Eigen::Vector3d rotated_back(const Angle& x, const Angle& alpha, const Eigen::Vector3d& v) {
  const double vx = x.c * v.x() + x.s * v.y();
  const double vy = x.c * v.y() - x.s * v.x();
  return {vx, alpha.c * vy + alpha.s * v.z(), alpha.c * v.z() - alpha.s * vy};
}

Eigen::Matrix3d rotated_back(const Angle& x, const Angle& alpha, const Eigen::Matrix3d& M) {
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i) out.col(i) = rotated_back(x, alpha, Eigen::Vector3d(M.col(i)));
  return out;
}

}  // namespace armlet
