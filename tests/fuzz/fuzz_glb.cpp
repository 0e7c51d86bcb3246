// Readers of GLB files: any bytes give a mesh, things that can be cut out, or a reason.
//
// The input is a file if it begins as one does; otherwise it is the description, and behind the
// first zero byte the binary part, of a file that is put together here.

#include "armlet/mesh/glb.hpp"
#include "target.hpp"

using namespace armlet;

namespace {

std::string file_of(std::string input) {
  if (input.starts_with("glTF")) return input;
  const std::size_t end = input.find('\0');
  std::string binary = end == std::string::npos ? std::string() : input.substr(end + 1);
  return make_glb(input.substr(0, end), std::move(binary), {});
}

void demand_reason(const Error& error) {
  fuzz::demand(!error.message.empty(), "what is refused has a reason");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = file_of(fuzz::text_of(data, size));
  glb_notes(bytes);
  const Result<TriangleMesh> mesh = read_glb(bytes);
  if (!mesh.ok()) demand_reason(mesh.error());
  const auto fault = glb_fault(bytes);
  fuzz::demand(fault.has_value() != mesh.ok() && (!fault || fault->message == mesh.error().message),
               "the check of a file says what its reader says");
  const Result<std::vector<GlbThing>> things = read_glb_things(bytes);
  if (!things.ok()) {
    demand_reason(things.error());
    return 0;
  }
  for (const GlbThing& thing : *things) {
    const Result<std::string> cut = cut_glb(bytes, thing);
    fuzz::demand(cut.ok(), "a thing that was read can be cut out");
    const Result<TriangleMesh> alone = read_glb(*cut);
    fuzz::demand(alone.ok(), "what was cut out can be read");
    fuzz::demand(alone->triangles().size() == thing.triangles.triangles().size(),
                 "what was cut out has the triangles of the thing");
  }
  return 0;
}
