#pragma once
// A GLB file as its parts, and its description with checks of every access.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/mesh/glb.hpp"
#include "mesh/glb_format.hpp"

namespace armlet::glb {

using Json = nlohmann::json;

inline constexpr std::size_t kMostJson = 8 << 20;       // bytes
inline constexpr int kDeepest = 64;                     // nesting depth of values
inline constexpr std::uint64_t kMostNumber = 1U << 31;  // of counts, offsets and lengths

[[noreturn]] inline void refuse(const std::string& why) { throw ArgumentError(why); }

inline std::uint32_t u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// ---- the file: a header and chunks

struct Chunks {
  std::string_view json;
  std::string_view binary;
};

inline Chunks chunks_of(std::string_view bytes) {
  if (bytes.size() < 4 || u32(bytes, 0) != kMagic)
    refuse("it is no GLB file: it does not begin with \"glTF\"");
  if (bytes.size() < 20) refuse(fmt::format("it is cut off: it has {} bytes", bytes.size()));
  if (u32(bytes, 4) != 2) refuse(fmt::format("it is GLB of version {}; expected 2", u32(bytes, 4)));
  if (u32(bytes, 8) != bytes.size()) {
    refuse(fmt::format("its header says {} bytes, but it has {}", u32(bytes, 8), bytes.size()));
  }
  Chunks chunks;
  for (std::size_t at = 12; at < bytes.size();) {
    if (bytes.size() - at < 8) refuse("it is cut off in the header of a chunk");
    const std::size_t length = u32(bytes, at);
    const std::uint32_t kind = u32(bytes, at + 4);
    if (length > bytes.size() - at - 8) {
      refuse(fmt::format("a chunk of {} bytes does not fit into it", length));
    }
    const std::string_view chunk = bytes.substr(at + 8, length);
    if (at == 12 && kind != kJsonChunk) refuse("its first chunk is not JSON");
    if (at == 12) chunks.json = chunk;
    if (kind == kBinaryChunk && chunks.binary.empty()) chunks.binary = chunk;
    at += 8 + length;
  }
  return chunks;
}

// ---- the JSON part

// A description, with the checks that every access needs.
class Document {
 public:
  explicit Document(std::string_view text) {
    if (text.size() > kMostJson)
      refuse(fmt::format("its JSON part has {} bytes; expected 8 MB at most", text.size()));
    if (json_depth(text) > kDeepest)
      refuse(fmt::format("its JSON part has more than {} values in one another", kDeepest));
    root_ = Json::parse(text.begin(), text.end(), nullptr, false);
    if (!root_.is_object()) refuse("its JSON part is broken");
  }

  [[nodiscard]] const Json& root() const { return root_; }

  // Element `index` of a list at the top level; `what` is its name in messages.
  [[nodiscard]] const Json& element(const char* list, std::uint64_t index, const char* what) const {
    const Json& all = member(root_, list);
    if (!all.is_array() || index >= all.size()) {
      refuse(fmt::format("{} {} is not there; it has {}", what, index,
                         all.is_array() ? all.size() : 0));
    }
    const Json& found = all[static_cast<std::size_t>(index)];
    if (!found.is_object()) refuse(fmt::format("{} {} is broken", what, index));
    return found;
  }
  [[nodiscard]] std::size_t count(const char* list) const {
    const Json& all = member(root_, list);
    return all.is_array() ? all.size() : 0;
  }

  // Null if there is none.
  [[nodiscard]] static const Json& member(const Json& object, const char* key) {
    static const Json kNothing;
    const auto found = object.find(key);
    return found == object.end() ? kNothing : *found;
  }
  // An integer from 0 on, or `otherwise` if it is missing.
  [[nodiscard]] static std::uint64_t number(const Json& object, const char* key,
                                            std::optional<std::uint64_t> otherwise = {}) {
    const Json& value = member(object, key);
    if (value.is_null() && otherwise) return *otherwise;
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMostNumber)
      refuse(fmt::format(
          "`{}` is {}; expected a whole number up to 2^31", key,
          value.is_null()
              ? "missing"
              : value.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, 40)));
    return value.get<std::uint64_t>();
  }
  // Reads `size` finite numbers; false if the list is missing.
  [[nodiscard]] static bool numbers(const Json& object, const char* key, double* out,
                                    std::size_t size) {
    const Json& list = member(object, key);
    if (list.is_null()) return false;
    if (!list.is_array() || list.size() != size)
      refuse(fmt::format("`{}` has not {} numbers", key, size));
    for (std::size_t k = 0; k < size; ++k) {
      if (!list[k].is_number()) refuse(fmt::format("`{}` has not {} numbers", key, size));
      out[k] = list[k].get<double>();
      if (!std::isfinite(out[k])) refuse(fmt::format("`{}` has a number that is too large", key));
    }
    return true;
  }

 private:
  Json root_;
};

}  // namespace armlet::glb
