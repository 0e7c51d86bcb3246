#pragma once

#include <string>

#include "armlet/backend/backend.hpp"
#include "armlet/core/hash.hpp"

namespace armlet {

// A hash of all events of a run: robots, samples, objects and their events, notes and final
// figures, in order, as bits. Equal hashes mean equal runs.
//
// It depends neither on other listeners nor on where the run pauses: states of figures that a later
// one replaces are left out, and so are the frames of links, which follow from the samples.
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
