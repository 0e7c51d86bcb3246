#pragma once
// Facts that rules of the host store about lists of numbers with several units.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// The dimension of a number, or of several numbers whose count is known only at run time.
//
// later  empty: `dim` is the dimension. Otherwise the text from which the host reads the dimensions
//        at run time; it has no comma.
// index  of `later`: the dimension of this number; -1: all dimensions, one after the other.
struct NumberDim {
  Dim dim{};
  std::string later{};
  int index = -1;

  [[nodiscard]] bool is_one() const { return later.empty() || index >= 0; }
  [[nodiscard]] bool is_none() const { return later.empty() && dim.is_none(); }
  bool operator==(const NumberDim&) const = default;
};

// The dimensions of the numbers in a list whose type has none, such as the speeds of parts that
// rotate and of parts that slide. Curves and tables of the list show their units.
class DimsFact : public Fact {
 public:
  explicit DimsFact(std::vector<NumberDim> all) : dims(std::move(all)) {}

  std::vector<NumberDim> dims;
};

// The dimensions of numbers as far as they follow from those of an argument of the call, which may
// be a parameter of the function with the call.
//
// dims  none: the dimensions do not follow from this fact.
class DimsOfArgumentFact : public Fact {
 public:
  using Reader = std::function<std::vector<NumberDim>(const Fact& of_argument)>;

  DimsOfArgumentFact(int parameter, Reader reader) : argument(parameter), dims(std::move(reader)) {}

  int argument;
  Reader dims;
};

}  // namespace armlet
