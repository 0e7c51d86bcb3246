#include "armlet/camera/visual_servo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/vision/planar_pose.hpp"
#include "camera/servo/servo_limits.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// of the width and the height: nearer to the border points slow down
constexpr double kBorder = 0.05;
constexpr double kOfRoom = 0.25;   // of the distance to the border, in one period
constexpr double kStopped = 0.02;  // speeds scaled by less count as zero
constexpr int kStoppedPictures = 10;
constexpr double kNoRoom = 1e-9;     // m or rad: what rounding leaves between a joint and its limit
constexpr std::size_t kWindow = 50;  // number of pictures in which the error has to decrease
constexpr double kFallen = 0.999;
constexpr double kChanges = 0.05;  // of the change of the picture that the gain demands
constexpr double kArmRank = 1e-3;  // of the largest singular value
constexpr double kImageRank = 1e-8;

double to_rotation(const Isometry3d& a, const Isometry3d& b) {
  return rotation_log(a.linear().transpose() * b.linear()).norm();
}

// Pixel and depth of the centre of some points.
struct Middle {
  Eigen::Vector2d seen;
  double depth;
};
Middle middle_of(const ObjectPoints& points, const Isometry3d& T_camera_obj) {
  const Eigen::Vector3d p = T_camera_obj * Eigen::Vector3d(points.colwise().mean().transpose());
  return {p.head<2>() / p.z(), p.z()};
}

VectorXd depths_in(const ObjectPoints& points, const Isometry3d& T_camera_obj) {
  return (T_camera_obj.linear().row(2) * points.transpose()).transpose().array() +
         T_camera_obj.translation().z();
}

}  // namespace

Index camera_directions(const MatrixXd& J_camera) { return rank_above(J_camera, kArmRank); }

VisualServo::VisualServo(const Pinhole& lens, ServoGoal goal, ServoArm arm,
                         const ServoOptions& options)
    : lens_(lens), goal_(std::move(goal)), arm_(std::move(arm)), options_(options) {
  check_options();
  check_goal();
  wanted_ = normalised(goal_.wanted);
  if (goal_.points.rows() > 0) {
    const auto pose = planar_pose(goal_.points, wanted_);
    if (!pose) throw ArgumentError(pose.error().message);
    T_goal_obj_ = pose->best.T_camera_obj;
  }
  if (goal_.depths.size() > 0) {
    depths_wanted_ = goal_.depths.size() == 1 ? VectorXd::Constant(wanted_.rows(), goal_.depths[0])
                                              : goal_.depths;
  } else {
    depths_wanted_ = depths_in(goal_.points, *T_goal_obj_);
  }
  speeds_ = VectorXd::Zero(arm_.lower.size());
  missed_.assign(static_cast<std::size_t>(wanted_.rows()), 0);
}

void VisualServo::finish(ServoEnd end, std::string why) {
  if (end_ != ServoEnd::kNone) return;
  end_ = end;
  why_ = std::move(why);
}

PlanePoints VisualServo::normalised(const PlanePoints& pixels) const {
  PlanePoints out(pixels.rows(), 2);
  for (Index i = 0; i < pixels.rows(); ++i) {
    const auto ray = lens_.ray(pixels.row(i).transpose());
    if (!ray) throw ArgumentError(ray.error().message);
    out.row(i) = ray->head<2>().transpose();
  }
  return out;
}

PlanePoints VisualServo::expected(const VectorXd& qd) const {
  if (points_.rows() == 0) return points_;
  const VectorXd moved = options_.period * (pixel_L_ * (J_camera_ * qd));
  return points_ + Eigen::Map<const PlanePoints>(moved.data(), points_.rows(), 2);
}

// Sets the points, each found or predicted by itself, as soon as all have been found once.
void VisualServo::take_points(const ServoSight& sight) {
  const bool is_first = points_.rows() == 0;
  const bool found_none = !sight.pixels || (is_first && !sight.missing.empty());
  const PlanePoints predicted = expected(sight.qd);
  std::vector<bool> is_missing(missed_.size(), found_none);
  for (const Index i : sight.missing) is_missing[static_cast<std::size_t>(i)] = true;
  if (!found_none) points_ = *sight.pixels;
  for (Index i = 0; i < goal_.wanted.rows(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    missed_[at] = is_missing[at] ? missed_[at] + 1 : 0;
    if (is_missing[at] && !is_first) points_.row(i) = predicted.row(i);
  }
  end_if_lost(sight.lost);
}

void VisualServo::end_if_lost(const std::string& lost) {
  const int longest = *std::ranges::max_element(missed_);
  if (longest <= options_.patience) return;
  std::string rows;
  Index count = 0;
  for (std::size_t i = 0; i < missed_.size(); ++i) {
    if (missed_[i] <= options_.patience) continue;
    rows += fmt::format("{}{}", rows.empty() ? "" : ", ", i);
    ++count;
  }
  const std::string which = count == goal_.wanted.rows() ? "the points were"
                            : count == 1                 ? "point " + rows + " was"
                                                         : "points " + rows + " were";
  finish(ServoEnd::kFeatureLost,
         fmt::format("{} not found in {} picture{}; at most {} are bridged{}{}", which, longest,
                     longest == 1 ? "" : "s one after the other", options_.patience,
                     lost.empty() ? "" : ": ", lost));
}

void VisualServo::end_if_outside(const VectorXd& depths, bool depths_are_known) {
  const Intrinsics& of = lens_.intrinsics();
  for (Index i = 0; i < points_.rows(); ++i) {
    if (!lens_.is_inside(points_.row(i).transpose())) {
      finish(ServoEnd::kOutOfImage,
             fmt::format("point {} is at ({:.1f}, {:.1f}), outside of the picture of {} x {}", i,
                         points_(i, 0), points_(i, 1), of.width, of.height));
    } else if (depths_are_known && !(depths[i] > of.near && depths[i] < of.far)) {
      finish(
          ServoEnd::kOutOfImage,
          fmt::format("point {} lies at a depth of {:.4g} m; the camera sees from {:g} m to {:g} m",
                      i, depths[i], of.near, of.far));
    }
  }
}

// Finds the pose of the points; of two possible poses, the one nearer to the last.
bool VisualServo::find_pose(const PlanePoints& seen) {
  const auto found = planar_pose(goal_.points, seen);
  if (!found) {
    finish(ServoEnd::kSingular,
           fmt::format("the pose of the points cannot be found: {}", found.error().message));
    return false;
  }
  const Isometry3d& last = T_camera_obj_ ? *T_camera_obj_ : *T_goal_obj_;
  const bool takes_other = found->is_ambiguous() && to_rotation(last, found->other.T_camera_obj) <
                                                        to_rotation(last, found->best.T_camera_obj);
  T_camera_obj_ = takes_other ? found->other.T_camera_obj : found->best.T_camera_obj;
  return true;
}

std::optional<VisualServo::Task> VisualServo::task_of(const ServoSight& sight) {
  Task task;
  task.depths = sight.depths;
  end_if_outside(task.depths, sight.depths.size() > 0);
  if (end_ != ServoEnd::kNone) return {};
  task.seen = normalised(points_);
  if (needs_pose()) {
    if (!find_pose(task.seen)) return {};
    if (task.depths.size() == 0 && goal_.depths.size() == 0) {
      task.depths = depths_in(goal_.points, *T_camera_obj_);
      end_if_outside(task.depths, true);
      if (end_ != ServoEnd::kNone) return {};
    }
  }
  if (task.depths.size() == 0) task.depths = depths_wanted_;
  set_errors(task, sight);
  const MatrixXd L_now = point_interaction(task.seen, task.depths);
  pixel_L_.resize(L_now.rows(), 6);
  for (Index i = 0; i < points_.rows(); ++i) {
    pixel_L_.middleRows(2 * i, 2) =
        lens_.pixel_jacobian(task.seen.row(i).transpose()) * L_now.middleRows(2 * i, 2);
  }
  J_camera_ = sight.J_camera;
  return task;
}

// Sets the error of the law and its derivative by the joints.
void VisualServo::set_errors(Task& task, const ServoSight& sight) const {
  if (is_image_law()) {
    const ImageGoal goal{task.seen, wanted_, task.depths, depths_wanted_};
    task.L = law_interaction(static_cast<ImageLaw>(options_.law), goal);
    task.A = task.L * sight.J_camera;
    task.error = image_error(goal);
  } else {
    const Isometry3d T_goal_camera = *T_goal_obj_ * T_camera_obj_->inverse(Eigen::Isometry);
    task.L = point_interaction(task.seen, task.depths);
    task.A = sight.J_camera;
    if (options_.law == ServoLaw::kPosition) {
      task.error = -position_twist(T_goal_camera, 1.0);
    } else {
      const Middle now = middle_of(goal_.points, *T_camera_obj_);
      const Middle then = middle_of(goal_.points, *T_goal_obj_);
      task.error =
          -hybrid_twist(now.seen, then.seen, now.depth, then.depth, T_goal_camera.linear(), 1.0);
    }
  }
  task.gain = options_.gain.at(task.error.lpNorm<Eigen::Infinity>());
}

// The interaction matrix for a picture that has ended the loop before the law was computed. The
// points are moved to the border of the picture where they are outside, and to their goals where
// the lens has no ray; depths are those of the goal where they are not known.
MatrixXd VisualServo::last_interaction(const ServoSight& sight) const {
  const Intrinsics& of = lens_.intrinsics();
  PlanePoints seen = wanted_;
  for (Index i = 0; i < seen.rows(); ++i) {
    const Eigen::Vector2d pixel(std::clamp(points_(i, 0), 0.0, of.width - 1.0),
                                std::clamp(points_(i, 1), 0.0, of.height - 1.0));
    if (const auto ray = lens_.ray(pixel)) seen.row(i) = ray->head<2>().transpose();
  }
  VectorXd depths = sight.depths.size() > 0 ? sight.depths
                    : T_camera_obj_         ? depths_in(goal_.points, *T_camera_obj_)
                                            : depths_wanted_;
  if (!(depths.array() > 0.0).all()) depths = depths_wanted_;
  if (!is_image_law()) return point_interaction(seen, depths);
  return law_interaction(static_cast<ImageLaw>(options_.law),
                         {seen, wanted_, depths, depths_wanted_});
}

void VisualServo::end_if_singular(const Task& task, const ServoSight& sight) {
  const Index of_arm = camera_directions(sight.J_camera);
  if (of_arm < arm_.rank) {
    const VectorXd s = singular_values(sight.J_camera).s;
    finish(ServoEnd::kSingular,
           fmt::format("the arm is at a singular posture: its joints move the camera in {} "
                       "directions of {} (singular values {:.3g} and {:.3g})",
                       of_arm, arm_.rank, s[0], s[arm_.rank - 1]));
    return;
  }
  const Index most = std::min(arm_.rank, task.A.rows());
  const Index rank = rank_above(task.A, kImageRank);
  if (rank < most) {
    const VectorXd s = singular_values(task.A).s;
    finish(ServoEnd::kSingular,
           fmt::format("the picture of these points determines {} of {} directions of motion "
                       "(smallest singular value {:.3g})",
                       rank, most, s[s.size() - 1]));
  }
}

// Detects a local minimum: the speeds of the law hardly change the picture.
void VisualServo::end_if_stuck(const Task& task, const ServoSight& sight, const VectorXd& speeds) {
  const ServoRow& row = rows_.back();
  if (row.held) return;
  errors_.push_back(row.error);
  if (errors_.size() <= kWindow) return;
  const double before = errors_.front();
  errors_.pop_front();
  if (row.error < kFallen * before) return;
  const VectorXd image = image_error({task.seen, wanted_, task.depths, depths_wanted_});
  const double asked = task.gain * image.norm();
  const double change = (task.L * (sight.J_camera * speeds)).norm();
  if (change > kChanges * asked) return;
  finish(
      ServoEnd::kLocalMinimum,
      fmt::format("the error stays at {:.3g} px ({:.3g} px {} pictures ago) and the speed that is "
                  "commanded is {:.2g} of what the gain asks for",
                  row.error, before, kWindow, change / asked));
}

// The factor by which speeds are scaled so that no point leaves the picture in the next period.
double VisualServo::keep_in_picture(const VectorXd& speeds) {
  const VectorXd moved = options_.period * (pixel_L_ * (J_camera_ * speeds));
  const double sides[] = {static_cast<double>(lens_.intrinsics().width),
                          static_cast<double>(lens_.intrinsics().height)};
  double scale = 1.0;
  Index first = -1;
  for (Index i = 0; i < moved.size(); ++i) {
    const double side = sides[i % 2], at = points_(i / 2, i % 2);
    const double room = moved[i] > 0.0 ? side - 0.5 - at : at + 0.5;
    const double allowed = room < kBorder * side ? kOfRoom * room : room;
    if (std::abs(moved[i]) * scale <= allowed) continue;
    scale = allowed / std::abs(moved[i]);
    first = i;
  }
  stopped_by_edge_ = scale < kStopped ? stopped_by_edge_ + 1 : 0;
  if (stopped_by_edge_ >= kStoppedPictures) {
    finish(ServoEnd::kOutOfImage,
           fmt::format("point {} is at ({:.1f}, {:.1f}) of the picture of {:g} x {:g}, and the law "
                       "moves it out by {:.3g} px/s",
                       first / 2, points_(first / 2, 0), points_(first / 2, 1), sides[0], sides[1],
                       std::abs(moved[first]) / options_.period));
  }
  return scale;
}

VectorXd VisualServo::command(const Task& task, const ServoSight& sight) {
  LimitedSpeeds limited =
      limited_speeds(task.A, task.error, task.gain, arm_, sight.q, options_.period);
  const VectorXd& asked = limited.qd / (limited.scale > 0.0 ? limited.scale : 1.0);
  end_if_stuck(task, sight, asked);
  const bool stops = limited.at && limited.scale < kStopped;
  stopped_by_joint_ = stops ? stopped_by_joint_ + 1 : 0;
  if (stopped_by_joint_ >= kStoppedPictures) {
    const JointAtLimit& at = *limited.at;
    const std::string where =
        at.room < kNoRoom ? "is at" : "stands " + joint_text(arm_, at.joint, at.room) + " from";
    finish(ServoEnd::kJointLimit,
           fmt::format("joint {} {} its limit of {}, and the law moves it on by {}/s", at.joint + 1,
                       where, joint_text(arm_, at.joint, at.limit),
                       joint_text(arm_, at.joint, std::abs(at.asked))));
  }
  VectorXd qd = limited.qd * keep_in_picture(limited.qd);
  if (options_.smooth > 0.0) {
    if (!first_speeds_) {
      first_speeds_ = qd;
      t_first_ = sight.t;
    }
    qd -= *first_speeds_ * det::exp(-options_.smooth * (sight.t - t_first_));
  }
  return qd;
}

const VectorXd& VisualServo::look(const ServoSight& sight) {
  if (end_ != ServoEnd::kNone) throw ArgumentError("This servo loop has ended.");
  check_sight(sight);
  speeds_.setZero();
  take_points(sight);
  if (points_.rows() == 0) return speeds_;
  ServoRow& row = rows_.emplace_back();
  row.t = sight.t;
  row.points = points_;
  row.held = *std::ranges::max_element(missed_) > 0;
  row.qd = speeds_;
  row.error = (points_ - goal_.wanted).norm();
  const auto task = task_of(sight);
  const VectorXd s = singular_values(task ? task->L : last_interaction(sight)).s;
  row.smallest = s[s.size() - 1];
  row.condition = row.smallest > 0.0 ? s[0] / row.smallest : HUGE_VAL;
  if (task) {
    if (!row.held && row.error <= options_.within)
      finish(ServoEnd::kConverged,
             fmt::format("the error is {:.3g} px; at most {:g} px were asked for", row.error,
                         options_.within));
    end_if_singular(*task, sight);
    if (sight.t >= options_.timeout)
      finish(ServoEnd::kTimeout,
             fmt::format("the error is {:.3g} px after {:g} s; {:g} px were asked for", row.error,
                         options_.timeout, options_.within));
    const VectorXd asked = end_ == ServoEnd::kNone ? command(*task, sight) : speeds_;
    if (end_ == ServoEnd::kNone) speeds_ = asked;
  }
  row.qd = speeds_;
  row.twist = sight.J_camera * speeds_;
  return speeds_;
}

}  // namespace armlet
