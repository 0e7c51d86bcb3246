#pragma once
// The types `lab` and `labRow` of programs.

#include "armlet/interpreter/define.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"

namespace armlet::bind {

// A handle of the one `lab` block of a program, which its Host stores.
struct LabRef {};

inline const HostType kLab{.name = "lab",
                           .size = sizeof(LabRef),
                           .is_handle = true,
                           .text = [](const void*, std::string& out) { out += "lab"; },
                           .help = "The page of a virtual laboratory."};
inline const HostType kLabRow{
    .name = "labRow",
    .size = sizeof(LabRow),
    .destroy = [](void* value) { static_cast<LabRow*>(value)->~LabRow(); },
    .text = [](const void* value,
               std::string& out) { out += static_cast<const LabRow*>(value)->name; },
    .help = "One element of a `lab` block."};

}  // namespace armlet::bind

namespace armlet {
template <>
inline constexpr const HostType* kHostType<bind::LabRef> = &bind::kLab;
template <>
inline constexpr const HostType* kHostType<LabRow> = &bind::kLabRow;
}  // namespace armlet
