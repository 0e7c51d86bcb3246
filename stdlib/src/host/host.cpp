#include "armlet/stdlib/host.hpp"

#include <algorithm>
#include <utility>

#include "host/journal.hpp"

namespace armlet {
namespace {

// A host that paces the clock is called at each multiple: short enough for a viewer to see motion,
// and for Ctrl-C to have effect.
constexpr std::int64_t kPaceStep = 10'000'000;  // ns

// The longest part of a motion between two checks for a stop request.
constexpr std::int64_t kLongestPart = 3'600'000'000'000;  // ns

}  // namespace

Host::Host(HostOptions options) : options_(std::move(options)), cell_(World(0.0)) {
  for (const NamedPlanner& own : options_.planners) planners_.add(own.name, own.plan, own.through);
}

void Host::refuse_no_host() {
  throw ArgumentError(
      "this program runs without a cell: the host has to set VmOptions::host, or to use a Session");
}

Result<int> Host::add_robot(std::shared_ptr<const Robot> robot) {
  try {
    return cell_.add_robot(std::move(robot));
  } catch (const ArgumentError& error) {
    return Error{"robot", error.what()};
  }
}

Result<int> Host::default_robot() {
  if (default_robot_ >= 0) return default_robot_;
  if (options_.robot == nullptr) return Error{"robot", "This host supplies no robot."};
  Result<int> id = add_robot(options_.robot);
  if (id.ok()) default_robot_ = *id;
  return id;
}

const Robot* Host::only_robot() const {
  if (cell_.robot_count() == 0) return options_.robot.get();
  return cell_.robot_count() == 1 ? cell_.robot(0).model.get() : nullptr;
}

void Host::want_world(const std::vector<std::string>& declared) {
  if (has_world() || !options_.default_world) return;
  skipped_ = declared;
  filling_ = true;
  options_.default_world(*this, declared);
  filling_ = false;
}

bool Host::is_skipped(std::string_view name) const {
  return filling_ && std::ranges::find(skipped_, name) != skipped_.end();
}

void Host::remember_motion(int robot, LastMotion motion) {
  const auto index = static_cast<std::size_t>(robot);
  if (index >= last_motions_.size()) last_motions_.resize(index + 1);
  last_motions_[index] = std::move(motion);
}

const LastMotion* Host::last_motion(int robot) const {
  const auto index = static_cast<std::size_t>(robot);
  if (index >= last_motions_.size() || !last_motions_[index]) return nullptr;
  return &*last_motions_[index];
}

void Host::remember_velocity(int robot, LastVelocity velocity) {
  const auto index = static_cast<std::size_t>(robot);
  if (index >= last_velocities_.size()) last_velocities_.resize(index + 1);
  last_velocities_[index] = std::move(velocity);
}

const LastVelocity* Host::last_velocity(int robot) const {
  const auto index = static_cast<std::size_t>(robot);
  if (index >= last_velocities_.size() || !last_velocities_[index]) return nullptr;
  const bool moves = cell_.is_moving(robot);
  const LastVelocity& last = *last_velocities_[index];
  return moves && cell_.robot(robot).motion_id == last.motion ? &last : nullptr;
}

void Host::remember_rest(int robot, LastRest rest) {
  const auto index = static_cast<std::size_t>(robot);
  if (index >= last_rests_.size()) last_rests_.resize(index + 1);
  last_rests_[index] = std::move(rest);
}

std::optional<LastRest> Host::take_rest(int robot) {
  const auto index = static_cast<std::size_t>(robot);
  if (index >= last_rests_.size()) return {};
  return std::exchange(last_rests_[index], std::nullopt);
}

void Host::note_way(PlannedWay way) {
  if (ways_.size() < kMostWays) ways_.push_back(std::move(way));
}

void Host::report_move(const FinishedMove& report) {
  ++moves_;
  const bool is_silent = options_.journal != nullptr && options_.journal->is_silent();
  if (options_.on_move && !is_silent) options_.on_move(report);
}

Figure& Host::begin_figure(Figure figure) {
  figure.index = static_cast<int>(figures_.size());
  return figures_.emplace_back(std::move(figure));
}

void Host::figure_changed() {
  if (!figures_.empty()) cell_.figure_changed(figures_.back());
}

std::vector<CellEvent> Host::take_events() { return cell_.take_events(); }

bool Host::first_contact_pick() { return !std::exchange(contact_pick_reported_, true); }

bool Host::first_fall() { return !std::exchange(fall_reported_, true); }

bool Host::first_collision(const void* call, std::string pair) {
  return collisions_reported_.emplace(call, std::move(pair)).second;
}

bool Host::knows_collision(const void* call, const std::string& pair) const {
  return collisions_reported_.contains({call, pair});
}

std::int64_t Host::now_ns() const { return cell_.now_ns(); }
std::int64_t Host::tick_ns() const { return cell_.options().tick_ns; }

// Calls the host while time passes, except for the last step. False: it requests that the program
// stops.
bool Host::pace_to(std::int64_t t_ns) {
  Journal* journal = options_.journal;
  if (!options_.pace || (journal != nullptr && journal->is_silent())) return true;
  while (cell_.now_ns() < t_ns) {
    const std::int64_t next = std::min(t_ns, (cell_.now_ns() / kPaceStep + 1) * kPaceStep);
    if (!options_.pace(next)) {
      if (journal != nullptr) journal->stop_time(cell_.now_ns());
      return false;
    }
    if (next == t_ns) break;
    cell_.advance_to(next);
  }
  return true;
}

bool Host::advance_to(std::int64_t t_ns) {
  Journal* journal = options_.journal;
  if (journal != nullptr) {
    if (const auto stop = journal->next_stop(cell_.now_ns(), t_ns)) {
      cell_.advance_to(*stop);
      journal->pass_stop();
      return false;
    }
  }
  if (!pace_to(t_ns)) return false;
  if (cell_.next_event()) t_ns = std::min(t_ns, cell_.now_ns() + kLongestPart);
  cell_.advance_to(t_ns);
  return true;
}

}  // namespace armlet
