// armlet-mesh: makes a GLB of a mesh in another format. It is started by armlet and communicates
// with it over standard input and output (exchange.hpp); it opens no files itself.

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/mesh/glb.hpp"
#include "converter/confine.hpp"
#include "converter/importers.hpp"

namespace {

using namespace armlet;
using namespace armlet::mesh;

constexpr int kArguments = 7;  // the program's own name, and the arguments from process.cpp
constexpr int kUsage = 64;

template <class T>
T number(const char* text) {
  T value{};
  const std::string_view all(text);
  std::from_chars(all.data(), all.data() + all.size(), value);
  return value;
}

// Reads the result as programs do: a mesh that they would refuse is refused here.
void check_result(const std::string& glb) {
  const Result<TriangleMesh> read = read_glb(glb);
  if (!read.ok()) throw ArgumentError(read.error().message);
}

std::string converted(const Input& input, Files& files) {
  if (input.format == "gltf" || input.format == "glb") return pack_gltf(input, files);
  SceneBuilder scene(files, input.unit == 0.0 ? 1.0 : input.unit);
  if (input.format == "wrl") {
    import_vrml(input, files, scene);
  } else {
    import_with_assimp(input, files, scene);
  }
  files.tell_stage("writing");
  return write_glb(std::move(scene).finish(input.name));
}

[[noreturn]] void convert(char** argv) {
  Files files;
  Input input;
  input.format = argv[1];
  input.unit = number<double>(argv[2]);
  input.up = argv[3][0] == '-' ? '\0' : argv[3][0];
  input.name = argv[4];
  const auto memory = number<std::size_t>(argv[5]);
  if (input.format == "wrl") prepare_vrml();
  if (const std::string why = confine(memory, number<int>(argv[6])); !why.empty())
    files.fail("the converter could not be confined: " + why);
  try {
    input.bytes = files.take_input();
    const std::string glb = converted(input, files);
    check_result(glb);
    files.finish(glb);
  } catch (const std::bad_alloc&) {
    files.fail(
        fmt::format("a size in it is false, or it needs more than {} MB of memory", memory >> 20));
  } catch (const std::length_error&) {
    files.fail("a size in it is larger than any memory");
  } catch (const std::exception& error) {
    files.fail(error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != kArguments) {
    std::fputs("armlet-mesh belongs to armlet, which starts it: armlet mesh convert IN OUT.glb\n",
               stderr);
    return kUsage;
  }
  convert(argv);
}
