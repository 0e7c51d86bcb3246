#pragma once
// Tables between bytes of pictures and linear light, because every pixel needs the conversion.

#include <array>
#include <cstddef>
#include <cstdint>

namespace armlet::raster {

// decode  linear light of bytes and of kPerByte - 1 values between two of them.
// encode  bytes of linear light in equal steps, fine enough that near black no byte is skipped.
struct SrgbTables {
  static constexpr int kPerByte = 16;
  static constexpr int kDecodeSteps = 255 * kPerByte;
  static constexpr int kEncodeSteps = 4095;
  std::array<float, kDecodeSteps + 1> decode{};
  std::array<std::uint8_t, kEncodeSteps + 1> encode{};
};

const SrgbTables& srgb_tables();

// The byte of linear light, which is clamped to 0 to 1.
inline std::uint8_t encoded_byte(const SrgbTables& tables, float linear) {
  const float step = linear * static_cast<float>(SrgbTables::kEncodeSteps) + 0.5F;
  if (!(step > 0.0F)) return tables.encode.front();
  if (step >= static_cast<float>(SrgbTables::kEncodeSteps)) return tables.encode.back();
  return tables.encode[static_cast<std::size_t>(step)];
}

// Linear light of a value from 0 to 255, which may be between two bytes.
inline float decoded_value(const SrgbTables& tables, float value) {
  return tables.decode[static_cast<std::size_t>(value * SrgbTables::kPerByte + 0.5F)];
}

}  // namespace armlet::raster
