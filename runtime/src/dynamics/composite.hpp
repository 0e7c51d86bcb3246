#pragma once

#include "chain/by_joints.hpp"
#include "duo.hpp"
#include "dynamics_plan.hpp"

namespace armlet {

// The links beyond a joint as one rigid body, in the axes of the joint's frame about its origin.
struct CompositeBody {
  double mass;
  Triple<Duo<double>> hs;  // first moment beside the last column of the second moment
  double Sxx, Sxy, Syy;

  [[gnu::always_inline]] explicit CompositeBody(const PlanLink& link)
      : mass(link.mass),
        hs{{link.h[0], link.Sxz}, {link.h[1], link.Syz}, {link.h[2], link.Szz}},
        Sxx(link.Sxx),
        Sxy(link.Sxy),
        Syy(link.Syy) {}

  [[gnu::always_inline]] void add(const PlanLink& link) {
    hs = hs +
         Triple<Duo<double>>{{link.h[0], link.Sxz}, {link.h[1], link.Syz}, {link.h[2], link.Szz}};
    mass += link.mass;
    Sxx += link.Sxx;
    Sxy += link.Sxy;
    Syy += link.Syy;
  }

  // The origin moves back along z by d, and then along x by a.
  template <bool kSlides>
  [[gnu::always_inline]] void shift_z(double d) {
    // S += h p' + p h' + m p p' with p = (0, 0, d).
    const double hx = hs.x.first(), hy = hs.y.first(), hz = hs.z.first();
    hs.x = hs.x + Duo<double>{0.0, d * hx};
    hs.y = hs.y + Duo<double>{0.0, d * hy};
    if constexpr (kSlides) {
      hs.z = hs.z + Duo<double>{mass * d, (hz + hz + mass * d) * d};
    } else {
      hs.z = hs.z + Duo<double>{0.0, (hz + hz) * d};
    }
  }
  template <bool kSlides>
  [[gnu::always_inline]] void shift_x(double a) {
    const double hx = hs.x.first();
    if constexpr (kSlides) {
      Sxx += (hx + hx + mass * a) * a;
    } else {
      Sxx += (hx + hx) * a;
    }
    Sxy += a * hs.y.first();
    const double hz = hs.z.first();
    hs.x = hs.x + Duo<double>{kSlides ? mass * a : 0.0, a * hz};
  }

  // R of a rotation about z: the second moment is rotated from both sides.
  [[gnu::always_inline]] void turn_z(double sine, double cosine) {
    hs = turn_in_z<double>(sine, cosine, hs);
    const Duo<double> rows = cosine * Duo<double>{Sxx, Sxy} - sine * Duo<double>{Sxy, Syy};
    const double trace = Sxx + Syy;
    Sxx = cosine * rows.first() - sine * rows.second();
    Sxy = sine * rows.first() + cosine * rows.second();
    Syy = trace - Sxx;
  }

  // The rotation of X_i.
  [[gnu::always_inline]] void turn_x(const PlanLink& link) {
    const double Sxz = hs.x.second(), Syz = hs.y.second(), Szz = hs.z.second();
    if (link.twist == kRightTwist) {
      hs = {{hs.x.first(), Sxy}, {-hs.z.first(), -Syz}, {hs.y.first(), Syy}};
      Sxy = -Sxz;
      Syy = Szz;
    } else if (link.twist == kAnyTwist) {
      const double s = link.sin_alpha, c = link.cos_alpha;
      const double yy = c * Syy - s * Syz, yz = c * Syz - s * Szz;  // rows of R S
      const double zy = s * Syy + c * Syz, zz = s * Syz + c * Szz;
      const double hy = hs.y.first(), hz = hs.z.first();
      hs = {{hs.x.first(), s * Sxy + c * Sxz},
            {c * hy - s * hz, yy * s + yz * c},
            {s * hy + c * hz, zy * s + zz * c}};
      Sxy = c * Sxy - s * Sxz;
      Syy = yy * c - yz * s;
    }
  }
};

// A composite body if only rotations about the axis matter (DynamicsPlan::flat).
struct FlatBody {
  double mass, hx, hy;
  double inertia;  // about the axis

  [[gnu::always_inline]] explicit FlatBody(const CompositeBody& body)
      : mass(body.mass),
        hx(body.hs.x.first()),
        hy(body.hs.y.first()),
        inertia(body.Sxx + body.Syy) {}

  [[gnu::always_inline]] void add(const PlanLink& link) {
    mass += link.mass;
    hx += link.h[0];
    hy += link.h[1];
    inertia += link.Sxx + link.Syy;
  }

  [[gnu::always_inline]] void walk_in(const PlanLink& link, double sine, double cosine) {
    const double x = cosine * hx - sine * hy;
    hy = sine * hx + cosine * hy;
    hx = x;
    if (!link.has_a) return;
    inertia += (hx + hx + mass * link.a) * link.a;
    hx += mass * link.a;
  }
};

// The forces and moments that accelerate joints with numbers `two` and `two` + 1.
struct ColumnPair {
  Triple<Duo<double>> f{}, n{};

  [[gnu::always_inline]] void set(int lane, const Triple<double>& force,
                                  const Triple<double>& moment) {
    f.x.v[lane] = force.x;
    f.y.v[lane] = force.y;
    f.z.v[lane] = force.z;
    n.x.v[lane] = moment.x;
    n.y.v[lane] = moment.y;
    n.z.v[lane] = moment.z;
  }

  // Transforms to the frame of the joint before.
  [[gnu::always_inline]] void walk_in(const PlanLink& link, double d, double sine, double cosine) {
    if (link.has_d) {
      n.x = n.x - d * f.y;
      n.y = n.y + d * f.x;
    }
    f = turn_in_x<double>(link, turn_in_z<double>(sine, cosine, f));
    n = turn_in_x<double>(link, turn_in_z<double>(sine, cosine, n));
    if (link.has_a) {
      n.y = n.y - link.a * f.z;
      n.z = n.z + link.a * f.y;
    }
  }
  // Transforms to the frame of the joint before if the axes are parallel: n.x and n.y are not
  // updated.
  [[gnu::always_inline]] void walk_in_flat(const PlanLink& link, double sine, double cosine) {
    f = turn_in_z<double>(sine, cosine, f);
    if (link.has_a) n.z = n.z + link.a * f.y;
  }
};

// The columns of the joints from the last one inward, in the frame of the present joint of the
// recursion.
template <int N, bool kSlides>
class Columns {
 public:
  // Adds a joint: its accelerating force, and the elements of its row through give(row, column,
  // value).
  template <class Give>
  [[gnu::always_inline]] void add(const PlanLink& link, int i, int behind, const FlatBody& body,
                                  double nx, double ny, const Give& give) {
    const bool slides = kSlides && link.slides;
    ColumnPair& own = pairs_[behind / 2];
    if (slides) {
      own.set(behind % 2, {0.0, 0.0, body.mass}, {body.hy, -body.hx, 0.0});
      give(i, i, body.mass + link.motor_inertia);
    } else {
      own.set(behind % 2, {-body.hy, body.hx, 0.0}, {nx, ny, body.inertia});
      give(i, i, body.inertia + link.motor_inertia);
    }
#pragma GCC unroll 8
    for (int k = 0; k < behind; ++k) {
      const ColumnPair& pair = pairs_[k / 2];
      const Duo<double>& force = slides ? pair.f.z : pair.n.z;
      give(i + behind - k, i, force.v[k % 2]);
    }
  }

  // Calls walk(pair) for the pairs in use.
  template <class Walk>
  [[gnu::always_inline]] void walk_in(int behind, const Walk& walk) {
    const int pairs = behind / 2 < kPairs ? behind / 2 + 1 : kPairs;
#pragma GCC unroll 8
    for (int pair = 0; pair < pairs; ++pair) walk(pairs_[pair]);
  }

 private:
  static constexpr int kPairs = (static_cast<int>(kJointCapacity<N>) + 1) / 2;
  ColumnPair pairs_[kPairs];  // of joints n - 1 and n - 2, n - 3 and n - 4, ...
};

// The inertia matrix with the inertia of the motors, by composite rigid bodies: the lower triangle,
// element (row, column) with row >= column through give(row, column, value). Signs are the plan's.
//
// source  M. W. Walker, D. E. Orin, Efficient dynamic computer simulation of robotic mechanisms,
//         1982; R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 6.2.
template <int N, bool kSlides, class Sines, class Motion, class Give>
[[gnu::always_inline]] inline void composite_bodies(const DynamicsPlan& plan, const Sines& sines,
                                                    const Motion& motion, const Give& give) {
  const int n = N == 0 ? static_cast<int>(plan.n) : N;
  const int flat = flat_links<N, kSlides>(plan);
  Columns<N, kSlides> columns;
  CompositeBody body(plan.links[n - 1]);
  int i = n - 1;
#pragma GCC unroll 8
  for (; i >= flat; --i) {
    const PlanLink& link = plan.links[i];
    const int behind = n - 1 - i;
    columns.add(link, i, behind, FlatBody(body), -body.hs.x.second(), -body.hs.y.second(), give);
    const double sine = sines.sine(i), cosine = sines.cosine(i);
    const double d = kSlides && link.slides ? link.d + motion.q(i) : link.d;
    columns.walk_in(
        behind, [&](ColumnPair & pair)
                    __attribute__((always_inline)) { pair.walk_in(link, d, sine, cosine); });
    if (link.has_d) body.shift_z<kSlides>(d);
    body.turn_z(sine, cosine);
    body.turn_x(link);
    if (link.has_a) body.shift_x<kSlides>(link.a);
    body.add(plan.links[i - 1]);
  }
  FlatBody seen(body);
#pragma GCC unroll 8
  for (; i >= 0; --i) {
    const PlanLink& link = plan.links[i];
    const int behind = n - 1 - i;
    columns.add(link, i, behind, seen, 0.0, 0.0, give);
    if (i == 0) break;
    const double sine = sines.sine(i), cosine = sines.cosine(i);
    columns.walk_in(
        behind, [&](ColumnPair & pair)
                    __attribute__((always_inline)) { pair.walk_in_flat(link, sine, cosine); });
    seen.walk_in(link, sine, cosine);
    seen.add(plan.links[i - 1]);
  }
}

}  // namespace armlet
