#include "armlet/math/minimise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;
using Status = Minimum::Status;

struct Corner {
  VectorXd x;
  double f = 0.0;
};

class Simplex {
 public:
  Simplex(const VectorFunction& f, const MinimiseOptions& options, Minimum& out)
      : f_(f), options_(options), out_(out) {}

  // One search from the best point so far. Returns false if it ended early; `out` then has the
  // reason.
  bool search() {
    if (!lay_out()) return false;
    while (!is_small()) {
      if (out_.evaluations >= most()) {
        out_.status = Status::kTooMany;
        return false;
      }
      if (!move()) return false;
    }
    return true;
  }

  bool evaluate(Corner& corner) {
    ++out_.evaluations;
    if (!f_(corner.x, corner.f)) return stop(Status::kStopped, corner);
    if (std::isnan(corner.f)) return stop(Status::kUndefined, corner);
    if (corner.f == -INFINITY) return stop(Status::kBottomless, corner);
    if (corner.f < out_.value) {
      out_.x = corner.x;
      out_.value = corner.f;
    }
    return true;
  }

 private:
  [[nodiscard]] int most() const {
    return options_.most_evaluations * static_cast<int>(out_.x.size());
  }

  bool stop(Status status, const Corner& corner) {
    out_.status = status;
    out_.x = corner.x;
    out_.value = corner.f;
    return false;
  }

  // Makes a simplex: one vertex at the best point, and one at a distance from it along every axis.
  bool lay_out() {
    constexpr double kPart = 0.05;
    const Corner first{out_.x, out_.value};
    corners_.assign(1, first);
    for (Eigen::Index i = 0; i < first.x.size(); ++i) {
      Corner corner = first;
      corner.x[i] += kPart * std::max(std::abs(corner.x[i]), 1.0);
      if (!evaluate(corner)) return false;
      corners_.push_back(std::move(corner));
    }
    sort();
    return true;
  }

  // Vertices with equal values keep the order in which they were made.
  void sort() {
    std::ranges::stable_sort(corners_, [](const Corner& a, const Corner& b) { return a.f < b.f; });
  }

  [[nodiscard]] bool is_within(double part) const {
    const Corner& best = corners_.front();
    for (const Corner& corner : corners_) {
      checkpoint(4 * static_cast<std::uint64_t>(best.x.size()));
      for (Eigen::Index i = 0; i < best.x.size(); ++i) {
        const double scale = std::max(std::abs(best.x[i]), 1.0);
        if (!(std::abs(corner.x[i] - best.x[i]) <= part * scale)) return false;
      }
    }
    return true;
  }

  // The vertices may be close together while their values still differ, if f is steep in one of the
  // variables.
  [[nodiscard]] bool is_small() const {
    constexpr double kRounding = 1e-13;
    const double best = corners_.front().f;
    const bool is_level = corners_.back().f - best <= kRounding * std::max(std::abs(best), 1.0);
    return is_within(is_level ? options_.tolerance : 1e-15);
  }

  // The point at the fraction `part` of the line from the worst vertex through the centre of the
  // others.
  bool place(double part, Corner& out) {
    out.x = middle_ + part * (middle_ - corners_.back().x);
    return evaluate(out);
  }

  bool move() {
    const auto n = static_cast<double>(out_.x.size());
    const double stretch = n > 1 ? 1.0 + 2.0 / n : 2.0;
    const double contract = n > 1 ? 0.75 - 0.5 / n : 0.5;
    middle_ = VectorXd::Zero(out_.x.size());
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
      checkpoint(static_cast<std::uint64_t>(middle_.size()));
      middle_ += corners_[i].x;
    }
    middle_ /= n;
    const Corner& worst = corners_.back();
    Corner reflected;
    if (!place(1.0, reflected)) return false;
    if (reflected.f < corners_.front().f) {
      Corner further;
      if (!place(stretch, further)) return false;
      return replace_worst(further.f < reflected.f ? std::move(further) : std::move(reflected));
    }
    if (reflected.f < corners_[corners_.size() - 2].f) return replace_worst(std::move(reflected));
    const bool outside = reflected.f < worst.f;
    Corner nearer;
    if (!place(outside ? contract : -contract, nearer)) return false;
    if (outside ? nearer.f <= reflected.f : nearer.f < worst.f)
      return replace_worst(std::move(nearer));
    return shrink(n > 1 ? 1.0 - 1.0 / n : 0.5);
  }

  bool replace_worst(Corner corner) {
    corners_.back() = std::move(corner);
    sort();
    return true;
  }

  bool shrink(double part) {
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      corners_[i].x = corners_[0].x + part * (corners_[i].x - corners_[0].x);
      if (!evaluate(corners_[i])) return false;
    }
    sort();
    return true;
  }

  const VectorFunction& f_;
  const MinimiseOptions& options_;
  Minimum& out_;
  std::vector<Corner> corners_;  // best one first
  VectorXd middle_;              // mean of all but the worst
};

}  // namespace

Minimum minimise(const VectorFunction& f, const VectorXd& start, const MinimiseOptions& options) {
  if (start.size() == 0) throw ArgumentError("The start is empty; expected at least one value.");
  check_finite("start", start);
  Minimum out;
  out.x = start;
  out.value = INFINITY;
  Simplex simplex(f, options, out);
  Corner first{start, 0.0};
  if (!simplex.evaluate(first)) return out;
  if (first.f == INFINITY) {
    out.status = Status::kUndefined;
    out.value = first.f;
    return out;
  }
  constexpr int kMostSearches = 100;
  for (int k = 0; k < kMostSearches; ++k) {
    const double before = out.value;
    if (!simplex.search()) return out;
    const double gained = before - out.value;
    if (k > 0 && gained <= 1e-12 * std::abs(before) + 1e-20) break;
  }
  return out;
}

}  // namespace armlet
