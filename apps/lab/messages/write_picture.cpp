// Pictures of elements, for pages.

#include <cstring>

#include "armlet/image/shown.hpp"
#include "json_parts.hpp"
#include "write_message.hpp"

namespace armlet::lab {

Message write_picture(std::uint32_t to, const LabPicture& picture) {
  const Image& image = picture.image;
  OrderedJson told = {{"marks", OrderedJson::array()}, {"fault", picture.fault}};
  for (const LabMarks& marks : picture.marks)
    told["marks"].push_back(
        {{"what", marks.what}, {"object", marks.object}, {"pixels", marks.pixels}});
  const std::string text = told.dump();
  const std::uint32_t head[6] = {kPictureMessage,
                                 to,
                                 static_cast<std::uint32_t>(image.channels()),
                                 static_cast<std::uint32_t>(image.width()),
                                 static_cast<std::uint32_t>(image.height()),
                                 static_cast<std::uint32_t>(text.size())};
  Message out{std::string(sizeof head, '\0'), true};
  std::memcpy(out.bytes.data(), head, sizeof head);
  const Image shown = image.kind() == PixelKind::kDepth ? grey_of_depths(image) : image;
  out.bytes.append(reinterpret_cast<const char*>(shown.bytes().data()), shown.bytes().size());
  out.bytes += text;
  return out;
}

}  // namespace armlet::lab
