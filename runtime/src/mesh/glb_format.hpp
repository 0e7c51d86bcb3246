// The numbers of glTF 2.0 and of its binary form.
#pragma once

#include <cstdint>

namespace armlet::glb {

inline constexpr std::uint32_t kMagic = 0x46546C67;        // "glTF"
inline constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
inline constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"
inline constexpr std::uint32_t kNotesChunk = 0x45544F4E;   // "NOTE", of Armlet alone

inline constexpr int kArrayBuffer = 34962;
inline constexpr int kElementArrayBuffer = 34963;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kUnsignedInt = 5125;
inline constexpr int kFloat = 5126;
inline constexpr int kTriangles = 4;

}  // namespace armlet::glb
