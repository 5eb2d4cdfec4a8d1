/// A mesh for Embree's rays.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <string>

#include "validate/gpu/mesh_file.h"

namespace lumaknot::embree {

/// A static hierarchy of the best quality over a mesh.
class Tracer {
 public:
  /// Throws std::runtime_error if Embree fails; `mesh` must outlive it.
  explicit Tracer(const gpu::Mesh& mesh);

  /// Intersects sixteen coherent rays, without those whose valid[i] is 0.
  void trace(const int* valid, RTCRayHit16& rays) const;

  /// "Embree 4.3.3"
  std::string version() const;

 private:
  struct End {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<RTCDeviceTy, End> device_;
  std::unique_ptr<RTCSceneTy, End> scene_;
};

}  // namespace lumaknot::embree
