#pragma once
// What rules of the host tell about lists of numbers with several units.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// The dimension of a number, or of as many numbers as only the run knows.
//
// later  empty: `dim` holds. Otherwise what the host reads the dimensions from when the program
//        runs; no comma is in it.
// index  of `later`, the one of this number; -1: all of them, one after the other.
struct NumberDim {
  Dim dim{};
  std::string later{};
  int index = -1;

  [[nodiscard]] bool is_one() const { return later.empty() || index >= 0; }
  [[nodiscard]] bool is_none() const { return later.empty() && dim.is_none(); }
  bool operator==(const NumberDim&) const = default;
};

// The dimensions of the numbers in a list whose type has none: speeds of parts that turn and
// slide. What shows the list writes its units from them.
class DimsFact : public Fact {
 public:
  explicit DimsFact(std::vector<NumberDim> all) : dims(std::move(all)) {}

  std::vector<NumberDim> dims;
};

// The same where they follow from what is known of an argument of the call, which may be a
// parameter of the function around it.
//
// dims  none: they do not follow from this fact.
class DimsOfArgumentFact : public Fact {
 public:
  using Reader = std::function<std::vector<NumberDim>(const Fact& of_argument)>;

  DimsOfArgumentFact(int parameter, Reader reader) : argument(parameter), dims(std::move(reader)) {}

  int argument;
  Reader dims;
};

}  // namespace armlet
