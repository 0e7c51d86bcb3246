#pragma once
// The methods that change a list.

#include <string_view>

#include "hir/hir_place.hpp"

namespace armlet::lang {

struct ListMutation {
  std::string_view name;
  hir::Mutation mutation;
};

inline constexpr ListMutation kListMutations[] = {{"push", hir::Mutation::kPush},
                                                  {"pop", hir::Mutation::kPop},
                                                  {"insert", hir::Mutation::kInsert},
                                                  {"removeAt", hir::Mutation::kRemoveAt}};

}  // namespace armlet::lang
