#pragma once
// What rules of the host tell about lists of numbers with several units.

#include <utility>
#include <vector>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// The dimensions of the numbers in a list whose type has none: speeds of parts that turn and
// slide. What shows the list writes its units from them.
class DimsFact : public Fact {
 public:
  explicit DimsFact(std::vector<Dim> all) : dims(std::move(all)) {}

  std::vector<Dim> dims;
};

}  // namespace armlet
