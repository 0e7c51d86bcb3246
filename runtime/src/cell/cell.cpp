#include "armlet/cell/cell.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/cell/fingers.hpp"
#include "armlet/collision/resting.hpp"
#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "cell/carried_load.hpp"
#include "cell/descriptions.hpp"

namespace armlet {
namespace {

std::span<const double> as_span(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

void check_tick(const char* what, std::int64_t period_ns) {
  if (period_ns > 0) return;
  throw ArgumentError(
      fmt::format("The {} of a cell is {} ns; expected more than 0.", what, period_ns));
}

}  // namespace

// Only while there is a backend.
template <class Told>
void Cell::tell(Told&& event) {
  event.number = told_++;
  backend_->on(std::forward<Told>(event));
}

Cell::Cell(World world, CellOptions options) : world_(std::move(world)), options_(options) {
  check_tick("tick", options.tick_ns);
  check_tick("sample period", options.sample_period_ns);
  world_.set_resting(resting_height_of_shapes);
}

int Cell::add_robot(std::shared_ptr<const Robot> model, std::string name) {
  return join(std::move(model), std::move(name), -1, -1);
}

int Cell::join(std::shared_ptr<const Robot> model, std::string name, int on, int hand) {
  if (model == nullptr) throw ArgumentError("A robot of the cell needs a model.");
  if (name.empty()) name = model->name();
  if (find_robot(name)) {
    throw ArgumentError(fmt::format("There is already a robot \"{}\" in the cell.", name));
  }
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model->n());
  const Eigen::VectorXd home = model->home();
  robots_.push_back({.name = std::move(name),
                     .model = model,
                     .loaded = std::move(model),
                     .q = home,
                     .qd = zero,
                     .qdd = zero,
                     .on = on,
                     .hand = hand});
  published_ns_.push_back(-1);
  const int index = robot_count() - 1;
  if (listening()) {
    tell(RobotAdded{.t_ns = now_ns(), .robot = robot_info(robot(index))});
    publish(index);
  }
  return index;
}

const CellRobot& Cell::robot(int index) const {
  if (index < 0 || index >= robot_count()) {
    throw ArgumentError(
        fmt::format("There is no robot {}; the cell has {}.", index, robot_count()));
  }
  return robots_[static_cast<std::size_t>(index)];
}

CellRobot& Cell::state(int index) {
  (void)robot(index);
  return robots_[static_cast<std::size_t>(index)];
}

std::optional<int> Cell::find_robot(std::string_view name) const {
  const auto found = std::ranges::find(robots_, name, &CellRobot::name);
  if (found == robots_.end()) return std::nullopt;
  return static_cast<int>(found - robots_.begin());
}

void Cell::set_model(int index, std::shared_ptr<const Robot> model) {
  if (model == nullptr) throw ArgumentError("A robot of the cell needs a model.");
  CellRobot& changed = state(index);
  check_size("model", model->n(), changed.model->n());
  if (changed.motion && changed.forces.size() == 0) {
    throw ArgumentError(fmt::format("\"{}\" is moving; it cannot be exchanged now.", changed.name));
  }
  settle_contacts();
  contacts_.forget_robot(index);
  changed.model = std::move(model);
  weigh_loads();
  if (listening())
    tell(RobotChanged{.t_ns = now_ns(), .index = index, .robot = robot_info(changed)});
}

void Cell::set_joints(int index, const Eigen::VectorXd& q) {
  CellRobot& moved = state(index);
  check_size("q", q.size(), moved.model->n());
  check_finite("q", q);
  if (moved.motion) {
    throw ArgumentError(fmt::format("\"{}\" is moving; it cannot be put elsewhere.", moved.name));
  }
  settle_contacts();
  contacts_.forget_robot(index);
  moved.q = q;
  follow_hands();
  for (int i = 0; i < robot_count(); ++i) {
    if (i == index || robot(i).on == index) carry_along(i);
  }
  published_ns_[static_cast<std::size_t>(index)] = -1;
  publish(index);
}

Eigen::Isometry3d Cell::T_world_base(int index) const {
  const CellRobot& arm = robot(index);
  if (arm.on < 0) return arm.model->T_world_base();
  return T_world_flange(arm.on) * arm.model->T_world_base();
}

Eigen::Isometry3d Cell::T_world_link(int index, int frame) const {
  const CellRobot& arm = robot(index);
  if (frame == kFlange) return T_world_flange(index);
  if (frame < 0 || frame > arm.model->rows()) {
    throw ArgumentError(fmt::format("`{}` has the links 0, its base, to {}, but no link {}.",
                                    arm.name, arm.model->rows(), frame));
  }
  if (frame == 0) return T_world_base(index);
  const Eigen::Isometry3d T_link = link_frame(*arm.model, arm.q, frame);
  return arm.on < 0 ? T_link : T_world_flange(arm.on) * T_link;
}

void Cell::carry_along(int index) {
  const CellRobot& arm = robot(index);
  if (!world_.has_mounted(index)) {
    if (!arm.held.empty()) world_.move_carried(index, T_world_flange(index));
    return;
  }
  std::vector<Eigen::Isometry3d> T_world_frames;
  for (int frame = 0; frame <= arm.model->rows(); ++frame)
    T_world_frames.push_back(T_world_link(index, frame));
  world_.move_carried(index, T_world_frames);
}

Eigen::Isometry3d Cell::T_world_flange(int index) const {
  const CellRobot& arm = robot(index);
  const Eigen::Isometry3d T_flange = link_frame(*arm.model, arm.q, arm.model->rows());
  return arm.on < 0 ? T_flange : T_world_flange(arm.on) * T_flange;
}

Eigen::Isometry3d Cell::T_world_tool(int index) const {
  const CellRobot& arm = robot(index);
  if (!arm.fingers.empty()) return T_world_base(index) * arm.model->T_flange_tool();
  const Eigen::Isometry3d T_tool = forward(*arm.model, arm.q);
  return arm.on < 0 ? T_tool : T_world_flange(arm.on) * T_tool;
}

Vector6d Cell::contact_wrench(int index) const {
  const CellRobot& arm = robot(index);
  if (arm.on >= 0) return finger_wrench(*this, index);
  Vector6d wrench = Vector6d::Zero();
  const std::vector<Press> presses = contacts_.presses(robots_, world_, index, now_ns());
  if (!presses.empty()) {
    const Eigen::Vector3d p_tool = T_world_tool(index).translation();
    for (const Press& each : presses) {
      wrench.head<3>() += each.force;
      wrench.tail<3>() += (each.p - p_tool).cross(each.force);
    }
  }
  if (arm.model->tool().kind == ToolKind::kFingers)
    wrench += finger_wrench(*this, hand_on(index), FeltBy::kArm);
  return wrench;
}

std::vector<Press> Cell::presses(int index) const {
  (void)robot(index);
  return contacts_.presses(robots_, world_, index, now_ns());
}

Eigen::VectorXd Cell::contact_forces(int index) const {
  const CellRobot& arm = robot(index);
  const Robot& model = *arm.model;
  if (arm.on >= 0) return Eigen::VectorXd::Zero(model.n());
  const std::vector<Press> presses = this->presses(index);
  const bool has_fingers = model.tool().kind == ToolKind::kFingers;
  if (presses.empty() && !has_fingers) return Eigen::VectorXd::Zero(model.n());
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(model.rows());
  Jacobian J(6, model.rows());
  const Eigen::Isometry3d T_world_tool =
      forward_and_jacobian(model.uncoupled(), row_values(model, arm.q), J);
  for (const Press& each : presses) {
    Vector6d wrench;
    wrench << each.force, (each.p - T_world_tool.translation()).cross(each.force);
    // Joints beyond it do not move that body.
    forces.head(each.frame) += J.leftCols(each.frame).transpose() * wrench;
  }
  if (has_fingers) forces += J.transpose() * finger_wrench(*this, hand_on(index), FeltBy::kArm);
  return joint_forces(model, forces);
}

void Cell::settle_contacts() {
  contacts_.settle(robots_, world_, now_ns());
  forget_ahead();
}

Vector6d Cell::held_wrench(int index) const {
  const CellRobot& arm = robot(index);
  if (arm.held.empty()) return Vector6d::Zero();
  return load_wrench(*arm.model, held_load(world_, index), T_world_flange(index), arm.q, arm.qd,
                     arm.qdd);
}

void Cell::insert(Object object) {
  settle_contacts();
  const Object& inserted = world_.insert(std::move(object));
  weigh_loads();
  if (listening()) tell(ObjectAdded{.t_ns = now_ns(), .object = object_info(inserted)});
}

// Throws ArgumentError if a mount does not exist, or was removed.
Eigen::Isometry3d Cell::T_world_mount(const Mount& on) const {
  switch (on.base) {
    case FrameBase::kWorld:
      return Eigen::Isometry3d::Identity();
    case FrameBase::kObject:
      return world_.at(on.on).T_world_obj;
    case FrameBase::kCarrier:
      return on.frame == kTipFrame ? T_world_tool(on.carrier) : T_world_link(on.carrier, on.frame);
    case FrameBase::kFrame:
      break;
  }
  if (const auto T = world_.T_world_frame(on.on)) return *T;
  throw ArgumentError(fmt::format("The frame \"{}\" is on \"{}\", which was removed.", on.on,
                                  world_.mount_of_frame(on.on).on));
}

void Cell::insert(Object object, const Mount& on) {
  const Mount to = on.base == FrameBase::kFrame ? world_.mount_of_frame(on.on) : on;
  // Bodies are not mounted at the tool point.
  const Eigen::Isometry3d T_world_on =
      on.base == FrameBase::kCarrier ? T_world_link(on.carrier, on.frame) : T_world_mount(on);
  check_object(object);  // its pose relative to its mount
  object.T_world_obj = T_world_on * object.T_world_obj;
  settle_contacts();
  const std::string name = object.name;
  world_.insert(std::move(object));
  if (to.base == FrameBase::kObject) world_.fasten(name, to.on);
  if (to.base == FrameBase::kCarrier)
    world_.mount(name, to.carrier, to.frame, T_world_link(to.carrier, to.frame));
  weigh_loads();
  if (listening()) tell(ObjectAdded{.t_ns = now_ns(), .object = object_info(world_.at(name))});
}

void Cell::insert_frame(NamedFrame frame) {
  if (frame.base == FrameBase::kCarrier)
    frame.T_world_carrier = T_world_link(frame.carrier, frame.frame);
  world_.insert_frame(std::move(frame));
}

std::optional<int> Cell::holder_of(std::string_view name) const {
  const auto found = std::ranges::find(robots_, name, &CellRobot::held);
  if (name.empty() || found == robots_.end()) return std::nullopt;
  return static_cast<int>(found - robots_.begin());
}

void Cell::refuse_held(std::string_view name, std::string_view what) const {
  const auto holder = holder_of(name);
  if (!holder) return;
  throw ArgumentError(
      fmt::format("\"{}\" is held by `{}`, so it cannot be {}.", name, robot(*holder).name, what));
}

std::vector<Fall> Cell::remove(std::string_view name) {
  const std::string removed(name);  // the caller's text may be part of the object itself
  refuse_held(removed, "removed");
  settle_contacts();
  contacts_.forget_object(removed);
  std::vector<Fall> falls = world_.remove(removed);
  std::erase(task_objects_, removed);
  weigh_loads();
  for (const std::string& each : drawings_.on_object(removed)) undraw(each);
  publish_event(ObjectChange::kRemoved, removed, -1);
  publish_falls(falls);
  return falls;
}

std::vector<Fall> Cell::set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj) {
  refuse_held(name, "put elsewhere");
  settle_contacts();
  std::vector<Fall> falls = world_.set_pose(name, T_world_obj);
  contacts_.forget_object(name);
  weigh_loads();
  publish_object(name);
  publish_falls(falls);
  return falls;
}

void Cell::add_to_task(std::string_view name) {
  (void)world_.at(name);
  if (std::ranges::find(task_objects_, name) == task_objects_.end()) {
    task_objects_.emplace_back(name);
  }
}

void Cell::take(int index, std::string_view name) {
  CellRobot& arm = state(index);
  const Object& object = world_.at(name);
  if (!arm.held.empty()) {
    throw ArgumentError(fmt::format("\"{}\" holds \"{}\" already.", arm.name, arm.held));
  }
  settle_contacts();
  arm.held = object.name;
  arm.p_picked = object.T_world_obj.translation();
  world_.attach(object.name, index, T_world_flange(index));
  weigh_loads();
  publish_event(ObjectChange::kAttached, object.name, index);
}

Drop Cell::let_go(int index) {
  CellRobot& arm = state(index);
  if (arm.held.empty()) throw ArgumentError(fmt::format("\"{}\" holds nothing.", arm.name));
  settle_contacts();
  const std::string name = std::exchange(arm.held, {});
  publish_event(ObjectChange::kDetached, name, index);
  for (int other = 0; other < robot_count(); ++other) {
    if (robot(other).held != name) continue;
    if (world_.attachment(name)->carrier == index) {
      world_.attach(name, other, T_world_flange(other));
    }
    weigh_loads();
    return {};
  }
  const std::vector<std::string> above = world_.stacked_on(name);
  const Drop drop = world_.drop(name);
  contacts_.look_again();
  weigh_loads();
  publish_object(name);
  for (const std::string& each : above) {
    if (!world_.are_fastened(each, name)) publish_object(each);
  }
  return drop;
}

void Cell::weigh_loads() {
  for (int i = 0; i < robot_count(); ++i) {
    CellRobot& arm = state(i);
    arm.loaded =
        arm.held.empty() && !world_.has_mounted(i) ? arm.model : loaded_arm(arm.model, world_, i);
  }
}

void Cell::note(NoteKind kind, std::string_view text) {
  if (backend_ == nullptr) return;
  if (begun_) {
    tell(Note{.t_ns = now_ns(), .kind = kind, .text = text});
  } else {
    pending_notes_.push_back({.t_ns = now_ns(), .kind = kind, .text = std::string(text)});
  }
}

void Cell::begin() {
  if (begun_) return;
  begun_ = true;
  if (backend_ == nullptr) return;
  RunInfo run;
  for (const CellRobot& each : robots_) run.robots.push_back(robot_info(each));
  for (std::size_t i = 0; i < world_.size(); ++i) {
    run.objects.push_back(object_info(world_.object(i)));
  }
  for (int i = 0; i < cameras_.count(); ++i) run.cameras.push_back(camera_info(cameras_.at(i)));
  tell(BeginRun{.t_ns = now_ns(), .run = std::move(run)});
  for (const PendingNote& each : pending_notes_) {
    tell(Note{.t_ns = each.t_ns, .kind = each.kind, .text = each.text});
  }
  pending_notes_.clear();
  for (const Figure& each : pending_figures_) figure_changed(each);
  pending_figures_.clear();
  for (int i = 0; i < robot_count(); ++i) publish(i);
  for (const std::string& name : drawings_.names()) publish_drawing(*drawings_.find(name), false);
}

void Cell::publish_drawing(const Drawing& drawing, bool removed) {
  if (listening())
    tell(DrawingChanged{.t_ns = now_ns(), .drawing = drawing_info(drawing), .removed = removed});
}

void Cell::publish_camera(const Camera& camera) {
  if (listening()) tell(CameraAdded{.t_ns = now_ns(), .camera = camera_info(camera)});
}

void Cell::publish_frame(const ImageFrame& frame) {
  begin();
  if (listening()) tell(ImageFrame(frame));
}

void Cell::figure_changed(const Figure& figure) {
  if (backend_ == nullptr) return;
  if (begun_) {
    tell(FigureChanged{.t_ns = now_ns(), .index = figure.index, .figure = &figure});
    return;
  }
  auto pending = std::ranges::find(pending_figures_, figure.index, &Figure::index);
  if (pending == pending_figures_.end())
    pending = pending_figures_.insert(pending, {.index = figure.index});
  // A large figure is copied only if somebody reads it; its event is counted in any case.
  if (!backend_->ignores().has(EventKind::kFigureChanged)) *pending = figure;
}

void Cell::figure(const Figure& figure) {
  begin();
  if (backend_ != nullptr) {
    tell(FinalFigure{.t_ns = now_ns(), .index = figure.index, .figure = &figure});
  }
}

void Cell::end() {
  begin();
  if (backend_ != nullptr) tell(EndRun{.t_ns = now_ns()});
}

void Cell::publish(int index, int motion) {
  if (!listening()) return;
  std::int64_t& last_ns = published_ns_[static_cast<std::size_t>(index)];
  if (last_ns == now_ns()) return;
  last_ns = now_ns();
  const CellRobot& arm = robot(index);
  T_world_links_.clear();
  if (backend_->wants_link_poses()) {
    T_world_links_.resize(static_cast<std::size_t>(arm.model->rows()));
    link_frames(*arm.model, arm.q, T_world_links_);
    if (arm.on >= 0) {
      const Eigen::Isometry3d T_world_flange_on = T_world_flange(arm.on);
      for (Eigen::Isometry3d& each : T_world_links_) each = T_world_flange_on * each;
    }
  }
  tell(JointSample{.t_ns = now_ns(),
                   .robot = index,
                   .motion = motion,
                   .q = as_span(arm.q),
                   .qd = as_span(arm.qd),
                   .qdd = as_span(arm.qdd),
                   .T_world_tool = T_world_tool(index),
                   .T_world_links = T_world_links_});
  for (const std::size_t i : world_.carried()) {
    if (world_.attachment_of(i)->carrier == index && world_.fastened_on(i).empty())
      publish_object(world_.object(i).name);
  }
  for (const int finger : arm.fingers) {
    if (!robot(finger).motion) publish(finger, motion);
  }
}

void Cell::publish_object(std::string_view name) {
  if (!listening()) return;
  const auto tell_of = [&](const Object& object) {
    tell(ObjectSample{.t_ns = now_ns(), .name = object.name, .T_world_obj = object.T_world_obj});
  };
  tell_of(world_.at(name));
  for (const std::string& each : world_.fastened_with(name)) {
    if (each != name) tell_of(world_.at(each));
  }
}

void Cell::publish_falls(const std::vector<Fall>& falls) {
  for (const Fall& each : falls) {
    publish_event(ObjectChange::kFell, each.name, -1);
    publish_object(each.name);
  }
}

void Cell::publish_event(ObjectChange change, std::string_view name, int index) {
  if (!listening()) return;
  tell(ObjectEvent{.t_ns = now_ns(), .change = change, .name = name, .robot = index});
}

}  // namespace armlet
