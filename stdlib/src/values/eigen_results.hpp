#pragma once
// Converts vectors and matrices of Eigen to results of native functions: lists and matrices.

#include <Eigen/Core>
#include <type_traits>

#include "armlet/interpreter/define.hpp"

namespace armlet {

template <class T>
concept EigenDense = std::is_base_of_v<Eigen::MatrixBase<T>, T>;

template <EigenDense T>
struct Given<T> {
  static constexpr bool kIsVector = T::ColsAtCompileTime == 1;
  static constexpr ValueKind kKind{kIsVector ? ValueKind::Form::kReals : ValueKind::Form::kMatrix};

  static Signal leave(Vm& vm, const T& values, Slot& slot) {
    if constexpr (kIsVector) {
      return give(&slot, new_reals(vm, {values.data(), static_cast<std::size_t>(values.size())}));
    } else {
      MatrixObj* matrix = new_matrix_unset(vm, static_cast<std::uint32_t>(values.rows()),
                                           static_cast<std::uint32_t>(values.cols()));
      for (Eigen::Index i = 0; matrix != nullptr && i < values.size(); ++i)
        matrix->data()[i] = values(i / values.cols(), i % values.cols());
      return give(&slot, matrix);
    }
  }
};

}  // namespace armlet
