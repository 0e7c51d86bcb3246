#include "armlet/backend/fan_out.hpp"

#include <algorithm>
#include <exception>

#include "armlet/core/error.hpp"

namespace armlet {

FanOut::FanOut(std::vector<Backend*> backends) { set_backends(std::move(backends)); }

void FanOut::set_backends(std::vector<Backend*> backends) {
  if (std::ranges::find(backends, nullptr) != backends.end()) {
    throw ArgumentError("A backend of the fan-out is null; leave it out instead.");
  }
  backends_ = std::move(backends);
}

void FanOut::on(const Event& event) {
  if (muted_) return;
  std::exception_ptr fault;  // the first one; every backend gets the event before it is thrown
  for (Backend* each : backends_) {
    try {
      each->on(event);
    } catch (...) {
      if (!fault) fault = std::current_exception();
    }
  }
  if (fault) std::rethrow_exception(fault);
}

EventKinds FanOut::ignores() const {
  EventKinds kinds = EventKinds::all();
  for (const Backend* each : backends_) kinds = kinds & each->ignores();
  return kinds;
}

bool FanOut::wants_link_poses() const {
  return std::ranges::any_of(backends_, &Backend::wants_link_poses);
}

std::string FanOut::error() const {
  for (const Backend* each : backends_) {
    if (std::string error = each->error(); !error.empty()) return error;
  }
  return {};
}

}  // namespace armlet
