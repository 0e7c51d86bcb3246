#pragma once
// The hash SHA-256, by which what is kept is found again and recognised.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace armlet::mesh {

// source  NIST, FIPS 180-4, Secure Hash Standard, 2015, section 6.2.
class Sha256 {
 public:
  void add(std::string_view bytes);
  // The bytes and how many they are, so that what follows is kept apart from them.
  void add_text(std::string_view text);
  // 64 digits to the base 16. Nothing is added after it.
  [[nodiscard]] std::string digits();

 private:
  void take_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> block_{};
  std::uint64_t length_ = 0;  // bytes
};

std::string sha256(std::string_view bytes);

}  // namespace armlet::mesh
