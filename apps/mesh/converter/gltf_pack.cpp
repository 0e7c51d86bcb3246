// glTF as one GLB: the files that it names are included, and nothing else is changed.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armlet/image/picture_size.hpp"
#include "converter/importers.hpp"
#include "converter/refuse.hpp"

namespace armlet::mesh {
namespace {

using Json = nlohmann::json;

constexpr int kDeepestJson = 64;
constexpr std::size_t kMostBytes = std::size_t{128} << 20;  // of the binary part
constexpr std::size_t kMostListed = 100'000;                // buffers, views, images

// A PNG of one white pixel, which replaces a picture that is left out.
constexpr unsigned char kWhite[] = {
    0x89, 'P',  'N',  'G',  '\r', '\n', 0x1a, '\n', 0,    0,    0,    13,   'I',  'H',
    'D',  'R',  0,    0,    0,    1,    0,    0,    0,    1,    8,    0,    0,    0,
    0,    0x3a, 0x7e, 0x9b, 0x55, 0,    0,    0,    10,   'I',  'D',  'A',  'T',  0x78,
    0x9c, 0x63, 0xf8, 0x0f, 0x00, 0x01, 0x01, 0x01, 0x00, 0x1b, 0xb6, 0xee, 0x56, 0,
    0,    0,    0,    'I',  'E',  'N',  'D',  0xae, 0x42, 0x60, 0x82};

std::size_t u32(std::string_view bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// source  RFC 4648, 2006, section 4.
std::string base64_read(std::string_view text) {
  std::string out;
  unsigned bits = 0, value = 0;
  for (const char c : text) {
    unsigned digit = 0;
    if (c >= 'A' && c <= 'Z') {
      digit = static_cast<unsigned>(c - 'A');
    } else if (c >= 'a' && c <= 'z') {
      digit = static_cast<unsigned>(c - 'a') + 26;
    } else if (c >= '0' && c <= '9') {
      digit = static_cast<unsigned>(c - '0') + 52;
    } else if (c == '+' || c == '-') {
      digit = 62;
    } else if (c == '/' || c == '_') {
      digit = 63;
    } else if (c == '=') {
      break;
    } else {
      refuse("a data: address has a sign that base64 has not");
    }
    value = (value << 6 | digit) & 0xffffffU;
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      out += static_cast<char>((value >> bits) & 0xffU);
    }
  }
  return out;
}

class Packer {
 public:
  Packer(const Input& input, Files& files) : files_(files) { split(input); }

  std::string glb() {
    take_buffers();
    move_views();
    take_images();
    if (binary_.empty()) refuse("there is no geometry in it");
    while (binary_.size() % 4 != 0) binary_ += '\0';
    json_["buffers"] = {{{"byteLength", binary_.size()}}};
    for (std::string& each : notes_) each = shown_text(each);
    return make_glb(json_.dump(-1, ' ', true, Json::error_handler_t::replace), std::move(binary_),
                    notes_);
  }

 private:
  void split(const Input& input) {
    std::string_view text = input.bytes;
    if (input.format == "glb") {
      if (text.size() < 20 || !text.starts_with("glTF")) refuse("it is no GLB file");
      const std::size_t length = u32(text, 12);
      if (length > text.size() - 20) refuse("it is cut off in its description");
      const std::string_view rest = text.substr(20 + length);
      text = text.substr(20, length);
      if (rest.size() >= 8) {
        const std::size_t most = u32(rest, 0);
        if (most > rest.size() - 8) refuse("it is cut off in its binary part");
        own_ = rest.substr(8, most);
      }
    }
    if (json_depth(text) > kDeepestJson)
      refuse(fmt::format("it has more than {} values in one another", kDeepestJson));
    json_ = Json::parse(text.begin(), text.end(), nullptr, false);
    if (!json_.is_object()) refuse("it is broken: its text is no JSON object");
  }

  // The list with this name; null if it does not exist.
  Json& list(const char* name) {
    Json& all = json_[name];
    if (all.is_null()) {
      json_.erase(name);
      static Json empty;
      empty = Json::array();
      return empty;
    }
    if (!all.is_array() || all.size() > kMostListed)
      refuse(fmt::format("`{}` is no list, or too long", name));
    for (const Json& each : all) {
      if (!each.is_object()) refuse(fmt::format("`{}` has an element that is broken", name));
    }
    return all;
  }

  static std::size_t number(const Json& object, const char* key,
                            std::optional<std::size_t> otherwise) {
    const auto found = object.find(key);
    if (found == object.end() && otherwise) return *otherwise;
    if (found == object.end() || !found->is_number_unsigned() ||
        found->get<std::size_t>() > 1U << 31)
      refuse(fmt::format("`{}` is no whole number up to 2^31", key));
    return found->get<std::size_t>();
  }

  // The bytes at an address; nullopt, and a note or a refusal, if there are none.
  std::optional<std::string> bytes_at(const Json& address, bool is_picture) {
    if (!address.is_string()) refuse("a `uri` is no text");
    const auto& text = address.get_ref<const std::string&>();
    if (text.starts_with("data:")) {
      const std::size_t comma = text.find(";base64,");
      if (comma == std::string::npos) refuse("a data: address is not in base64");
      return base64_read(std::string_view(text).substr(comma + 8));
    }
    if (is_picture) {
      auto image = load_image(files_, text, notes_);
      if (!image) return std::nullopt;
      return std::move(image->bytes);
    }
    const GivenFile& file = files_.find(text);
    if (file.state != Say::kFile)
      refuse(fmt::format("the file \"{:.200}\" cannot be read: {}", text, file.text));
    return file.text;
  }

  std::size_t append(std::string_view bytes) {
    while (binary_.size() % 4 != 0) binary_ += '\0';
    if (bytes.size() > kMostBytes - std::min(binary_.size(), kMostBytes))
      refuse(fmt::format("with what it names it has more than {} MB", kMostBytes >> 20));
    binary_ += bytes;
    return binary_.size() - bytes.size();
  }

  void take_buffers() {
    for (const Json& each : list("buffers")) {
      const std::size_t length = number(each, "byteLength", std::nullopt);
      std::string other;
      std::string_view bytes = own_;
      if (each.contains("uri")) {
        other = *bytes_at(each["uri"], false);
        bytes = other;
      } else if (!places_.empty()) {
        refuse(fmt::format("buffer {} lies nowhere", places_.size()));
      }
      if (length > bytes.size()) {
        refuse(fmt::format("buffer {} says {} bytes, but there are {}", places_.size(), length,
                           bytes.size()));
      }
      places_.push_back({append(bytes.substr(0, length)), length});
    }
  }

  void move_views() {
    std::size_t index = 0;
    for (Json& each : list("bufferViews")) {
      const std::size_t buffer = number(each, "buffer", std::nullopt);
      const std::size_t offset = number(each, "byteOffset", 0);
      const std::size_t length = number(each, "byteLength", std::nullopt);
      if (buffer >= places_.size()) refuse(fmt::format("buffer {} is not there", buffer));
      if (offset + length > places_[buffer].second)
        refuse(fmt::format("bufferView {} does not fit into its buffer", index));
      each["buffer"] = 0;
      each["byteOffset"] = places_[buffer].first + offset;
      ++index;
    }
  }

  void take_images() {
    const std::string_view white(reinterpret_cast<const char*>(kWhite), sizeof kWhite);
    std::size_t index = 0;
    for (Json& each : list("images")) {
      const std::string name = fmt::format("image {}", index++);
      std::string bytes;
      if (each.contains("bufferView")) {
        const std::size_t at = number(each, "bufferView", std::nullopt);
        const Json& views = list("bufferViews");
        if (at >= views.size()) refuse(fmt::format("the bufferView of {} is not there", name));
        bytes =
            binary_.substr(number(views[at], "byteOffset", 0), number(views[at], "byteLength", 0));
      } else if (each.contains("uri")) {
        auto found = bytes_at(each["uri"], true);
        bytes = found ? std::move(*found) : std::string(white);
      } else {
        refuse(fmt::format("{} lies nowhere", name));
      }
      if (image_kind(bytes).empty()) {
        notes_.push_back(fmt::format("{} is left out: it is no PNG and no JPEG", name));
        bytes = white;
      }
      check_image(bytes, name);
      each.erase("uri");
      each["mimeType"] = image_kind(bytes);
      const std::size_t length = bytes.size();
      if (!json_.contains("bufferViews")) json_["bufferViews"] = Json::array();
      json_["bufferViews"].push_back(
          {{"buffer", 0}, {"byteOffset", append(bytes)}, {"byteLength", length}});
      each["bufferView"] = json_["bufferViews"].size() - 1;
    }
  }

  Files& files_;
  Json json_;
  std::string_view own_;
  std::string binary_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;  // offsets in binary_, and lengths
  std::vector<std::string> notes_;
};

}  // namespace

std::string pack_gltf(const Input& input, Files& files) {
  if (input.unit != 0.0 && input.unit != 1.0) refuse("glTF is in metres; it takes no other unit");
  if (input.up == 'z') refuse("glTF has y up; it takes no other axis");
  return Packer(input, files).glb();
}

}  // namespace armlet::mesh
