// A small hash for comparing contents, the same on every machine. Not cryptographic.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace armlet {

// FNV-1a with 64 bits (Fowler, Noll and Vo; the IETF draft "The FNV Non-Cryptographic Hash
// Algorithm"). Numbers are hashed as their bytes, the lowest first.
class Fnv1a {
 public:
  constexpr void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * kPrime; }
  constexpr void add(std::uint64_t word) {
    for (int i = 0; i < 8; ++i, word >>= 8U) add_byte(static_cast<std::uint8_t>(word));
  }
  constexpr void add(std::int64_t number) { add(static_cast<std::uint64_t>(number)); }
  constexpr void add(int number) { add(std::int64_t{number}); }
  // Adds the bits; all NaN count as the same.
  constexpr void add(double number) {
    add(number == number ? std::bit_cast<std::uint64_t>(number) : kNan);
  }
  // Adds the bytes without a separator.
  constexpr void add_bytes(std::string_view bytes) {
    for (const char byte : bytes) add_byte(static_cast<std::uint8_t>(byte));
  }
  // Adds the bytes and their number.
  constexpr void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    add_bytes(text);
  }

  [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

 private:
  static constexpr std::uint64_t kPrime = 0x100000001B3;
  static constexpr std::uint64_t kNan = 0x7FF8'0000'0000'0000;
  std::uint64_t value_ = 0xCBF29CE484222325;
};

}  // namespace armlet
