#include "study/measure/fingerprint.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <string_view>
#include <thread>

#include "scene/json.h"
#include "system/atomic_file.h"

namespace lumaknot::measure {
namespace {

/// FNV-1a with 64 bits: G. Fowler, L. Noll, P. Vo.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3u;
  }
  template <class T>
  void add_values(const T& values) {
    add({reinterpret_cast<const char*>(values.data()),
         values.size() * sizeof(typename T::value_type)});
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// The processor's name, if the system reports it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line;
  }
  return {};
}

}  // namespace

std::string scene_key(const Scene& scene, const MeshSpec& mesh) {
  Hash hash;
  const auto* color = std::get_if<Vec3d>(&scene.texture);
  hash.add(scene_to_json({mesh, color ? TextureSpec(PlainColor{*color}) : Bricks{}, scene.view}));
  hash.add_values(scene.mesh.positions);
  hash.add_values(scene.mesh.triangles);
  if (const auto* image = std::get_if<TextureImage>(&scene.texture)) {
    hash.add(fmt::format("{} x {}", image->width, image->height));
    hash.add_values(image->pixels);
  }
  return hash.text();
}

std::string program_key() {
  Hash hash;
  hash.add(read_file("/proc/self/exe", "this program"));
  hash.add(processor());
  hash.add(std::to_string(std::thread::hardware_concurrency()));
  return hash.text();
}

}  // namespace lumaknot::measure
