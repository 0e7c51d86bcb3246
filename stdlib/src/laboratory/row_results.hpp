#pragma once
// The results of functions in rows of a `lab` block.

#include <optional>
#include <string>
#include <string_view>

#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "laboratory/lab_values.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {

[[nodiscard]] inline Failed refuse_row(Vm& vm, LabRowKind kind, const std::string& why,
                                       CallPart part) {
  Failure f;
  f.headline = {row("R0641"), {std::string(word_of(kind)), why}};
  f.mark = part;
  return fail(vm, std::move(f));
}

[[nodiscard]] inline LabRow row_of(Vm& vm, LabRowKind kind, std::string_view name,
                                   std::optional<std::string_view> label) {
  return {.kind = kind,
          .name = std::string(name),
          .label = std::string(label.value_or(name)),
          .at = running_at(vm)};
}

}  // namespace armlet::bind
