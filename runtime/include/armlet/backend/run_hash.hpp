#pragma once

#include <string>

#include "armlet/backend/backend.hpp"
#include "armlet/core/hash.hpp"

namespace armlet {

// One number for all that a run tells: robots, samples, objects and their events, notes and figures
// as they are left, in order, as bits. Two runs with the same hash went the same way.
//
// It does not depend on who else listens, nor on where the run pauses: states of figures that a
// later one replaces and the frames of links, which follow from the samples, do not count.
class RunHash : public Backend {
 public:
  void on(const Event& event) override;
  [[nodiscard]] EventKinds ignores() const override;

  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }
  // 16 hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  Fnv1a hash_;
};

}  // namespace armlet
