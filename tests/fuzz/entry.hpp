#pragma once
// What a target is: libFuzzer or replay.cpp calls it with one input after the other.

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
