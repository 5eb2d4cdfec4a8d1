#include "bench/embree/tracer.h"

#include <fmt/format.h>

#include <stdexcept>

namespace lumaknot::embree {
namespace {

void check(RTCDevice device, const char* what) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  throw std::runtime_error(fmt::format("Embree can't {} (error {})", what, int(error)));
}

}  // namespace

Tracer::Tracer(const gpu::Mesh& mesh) : device_(rtcNewDevice(nullptr)) {
  check(device_.get(), "start");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
  const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.vertices.data(), 0, gpu::kFloatsPerVertex * sizeof(float),
                             mesh.vertices.size() / gpu::kFloatsPerVertex);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.indices.data(), 0, 3 * sizeof(std::uint32_t),
                             mesh.indices.size() / 3);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_.get());
  check(device_.get(), "build a hierarchy over the mesh");
}

void Tracer::trace(const int* valid, RTCRayHit16& rays) const {
#if RTC_VERSION_MAJOR < 4
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene_.get(), &context, &rays);
#else
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(valid, scene_.get(), &rays, &arguments);
#endif
}

std::string Tracer::version() const {
  const auto number = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_VERSION);
  return fmt::format("Embree {}.{}.{}", number / 10000, number / 100 % 100, number % 100);
}

}  // namespace lumaknot::embree
