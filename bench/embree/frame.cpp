// A tile is drawn in packets of 4 x 4 pixels: sixteen rays, then their shading in as many lanes as
// the processor has. A pixel's rays lie on a lattice: evenly along x, by the golden ratio along y.
#include "bench/embree/frame.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "math/angle.h"
#include "render/fast/simd_number.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::embree {
namespace {

using Packet = fast::Floats<xsimd::default_arch>;
using Batch = Packet::Batch;
using IntBatch = xsimd::batch<std::int32_t>;
using PacketVec = Vec3<Packet>;

constexpr int kLanes = int(Packet::kWidth);
constexpr int kRays = 16, kSide = 4;  // a packet, and its pixels along x and y
constexpr int kTile = 32;             // pixels along a tile's side
// A triangle's attributes: those of its first corner and what is added towards the other two.
constexpr int kAttributes = 5, kStride = 16;

/// Rays through image points: direction of depth one along the camera's axis.
struct Rays {
  Vec3d eye, corner, step_x, step_y;
  double nearest;
};

Rays rays_of(const View& view) {
  const CameraFrame frame = camera_frame(view.camera);
  const double tangent = std::tan(view.camera.fov_degrees * kPi / 360);
  const double pixel = 2 * tangent / view.image.height;
  const Vec3d x = frame.right * pixel, y = frame.up * -pixel;
  const Vec3d corner = -frame.back - x * (view.image.width / 2.0) - y * (view.image.height / 2.0);
  return {view.camera.position, corner, x, y, near_depth(view.camera)};
}

/// The data shared by a frame's packets.
struct Shading {
  const Tracer& tracer;
  const Surface& surface;
  Shot shot;
  Vec3d color;
  Lighting<Packet> lighting;
  Rays rays;
  int samples;
};

/// Sums of a packet's samples.
struct Sums {
  alignas(64) std::array<float, kRays> red{}, green{}, blue{}, covered{};
};

/// The texel of each lane in [0, 255].
PacketVec unpacked(const IntBatch& texel) {
  const auto channel = [&](int shift) { return Packet(xsimd::to_float((texel >> shift) & 255)); };
  return {channel(0), channel(8), channel(16)};
}

/// Two neighbouring texels on one axis and the weight of the second.
struct Neighbors {
  IntBatch first, second;
  Packet weight;
};

Neighbors neighbors(const Batch& coordinate, int size) {
  const Batch texel = (coordinate - xsimd::floor(coordinate)) * Batch(float(size)) - 0.5f;
  const Batch floor = xsimd::floor(texel);
  const IntBatch first = xsimd::to_int(floor), second = first + 1;
  return {xsimd::select(first < 0, first + size, first),
          xsimd::select(second >= size, second - size, second), Packet(texel - floor)};
}

PacketVec texture_color(const PackedTexture& texture, const Batch& u, const Batch& v) {
  const Neighbors x = neighbors(u, texture.width), y = neighbors(v, texture.height);
  const auto row = [&](const IntBatch& j) {
    const auto at = [&](const IntBatch& i) {
      return unpacked(IntBatch::gather(texture.texels.data(), j * texture.width + i));
    };
    const PacketVec left = at(x.first), right = at(x.second);
    return left + (right - left) * x.weight;
  };
  const PacketVec below = row(y.first), above = row(y.second);
  return (below + (above - below) * y.weight) * Packet(1.0 / 255);
}

/// The rays of a packet through the sample at (dx, dy) of each pixel.
void aim(const Rays& rays, double x, double y, RTCRayHit16& packet) {
  const Vec3d first = rays.corner + rays.step_x * x + rays.step_y * y;
  for (int i = 0; i < kRays; ++i) {
    const int column = i % kSide, row = i / kSide;
    const Vec3d d = first + rays.step_x * column + rays.step_y * row;
    packet.ray.org_x[i] = float(rays.eye.x);
    packet.ray.org_y[i] = float(rays.eye.y);
    packet.ray.org_z[i] = float(rays.eye.z);
    packet.ray.dir_x[i] = float(d.x);
    packet.ray.dir_y[i] = float(d.y);
    packet.ray.dir_z[i] = float(d.z);
    packet.ray.tnear[i] = float(rays.nearest);
    packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
    packet.ray.time[i] = 0;
    packet.ray.mask[i] = ~0u;
    packet.ray.id[i] = unsigned(i);
    packet.ray.flags[i] = 0;
    packet.hit.u[i] = packet.hit.v[i] = 0;  // lanes that miss are computed as well
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.primID[i] = 0;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
}

Batch load(const float* values, int first) { return Batch::load_unaligned(values + first); }

/// The attributes of the lanes from `first` on.
std::array<Batch, kAttributes> interpolated(const std::int32_t* attributes, const RTCHit16& hit,
                                            int first) {
  const auto* triangle = reinterpret_cast<const std::int32_t*>(hit.primID) + first;
  const IntBatch at = IntBatch::load_unaligned(triangle) * kStride;
  const Batch u = load(hit.u, first), v = load(hit.v, first);
  std::array<Batch, kAttributes> result;
  for (int a = 0; a < kAttributes; ++a) {
    const auto part = [&](int corner) {
      const IntBatch bits = IntBatch::gather(attributes, at + (corner * kAttributes + a));
      return fast::bits_as<Batch>(bits);
    };
    result[std::size_t(a)] = xsimd::fma(v, part(2), xsimd::fma(u, part(1), part(0)));
  }
  return result;
}

/// The colours of the lanes from `first` on, where something was hit or not.
PacketVec color(const Shading& shading, const RTCRayHit16& rays, int first) {
  const auto a = interpolated(shading.surface.attributes(), rays.hit, first);
  const Batch t = load(rays.ray.tfar, first);
  const auto along = [&](const float* from, const float* direction) {
    return Packet(xsimd::fma(t, load(direction, first), load(from, first)));
  };
  const SurfacePoint<Packet> point{
      {along(rays.ray.org_x, rays.ray.dir_x), along(rays.ray.org_y, rays.ray.dir_y),
       along(rays.ray.org_z, rays.ray.dir_z)},
      {Packet(a[0]), Packet(a[1]), Packet(a[2])}};
  const PackedTexture* texture = shading.surface.texture();
  const PacketVec texel =
      texture ? texture_color(*texture, a[3], a[4]) : constant_vec<Packet>(shading.color);
  return saturate(stage_color(point, texel, shading.lighting, shading.shot));
}

void add(float* sums, int first, const Batch& values) {
  (load(sums, first) + values).store_unaligned(sums + first);
}

void shade(const Shading& shading, const RTCRayHit16& rays, Sums& sums) {
  for (int first = 0; first < kRays; first += kLanes) {
    const auto* ids = reinterpret_cast<const std::int32_t*>(rays.hit.geomID) + first;
    const auto hit = load(rays.ray.tfar, first) < Batch(std::numeric_limits<float>::infinity());
    if (std::all_of(ids, ids + kLanes, [](std::int32_t id) { return id < 0; })) continue;
    const PacketVec c = color(shading, rays, first);
    const Batch none(0.0f);
    add(sums.red.data(), first, xsimd::select(hit, c.x.v, none));
    add(sums.green.data(), first, xsimd::select(hit, c.y.v, none));
    add(sums.blue.data(), first, xsimd::select(hit, c.z.v, none));
    add(sums.covered.data(), first, xsimd::select(hit, Batch(1.0f), none));
  }
}

/// Rounded to the nearest, as colours are not negative.
std::uint32_t byte_of(float sum, float scale) {
  const float above = sum * scale + 0.5f;
  return std::uint32_t(above);
}

void draw_packet(const Shading& shading, int x, int y, Frame& frame) {
  alignas(64) std::array<int, kRays> valid;
  for (int i = 0; i < kRays; ++i) {
    valid[std::size_t(i)] = x + i % kSide < frame.width && y + i / kSide < frame.height ? -1 : 0;
  }
  Sums sums;
  for (int s = 0; s < shading.samples; ++s) {
    const double dx = (s + 0.5) / shading.samples, turns = 0.5 + s * 0.6180339887498949;
    RTCRayHit16 rays;
    aim(shading.rays, x + dx, y + (turns - std::floor(turns)), rays);
    shading.tracer.trace(valid.data(), rays);
    shade(shading, rays, sums);
  }
  const float scale = 255.0f / float(shading.samples);
  for (std::size_t i = 0; i < kRays; ++i) {
    if (!valid[i]) continue;
    frame.at(x + int(i) % kSide, y + int(i) / kSide) =
        byte_of(sums.red[i], scale) | byte_of(sums.green[i], scale) << 8 |
        byte_of(sums.blue[i], scale) << 16 | byte_of(sums.covered[i], scale) << 24;
  }
}

}  // namespace

Surface::Surface(const Job& job) : texture_(job.texture ? &*job.texture : nullptr) {
  attributes_.resize(job.mesh.indices.size() / 3 * kStride);
  for (std::size_t t = 0; t < job.mesh.indices.size() / 3; ++t) {
    for (std::size_t a = 0; a < kAttributes; ++a) {
      const auto at = [&](std::size_t corner) {
        return job.mesh.vertices[job.mesh.indices[t * 3 + corner] * gpu::kFloatsPerVertex + 3 + a];
      };
      const auto set = [&](std::size_t corner, float value) {
        attributes_[t * kStride + corner * kAttributes + a] = std::bit_cast<std::int32_t>(value);
      };
      set(0, at(0));
      set(1, at(1) - at(0));
      set(2, at(2) - at(0));
    }
  }
}

void draw_frame(const Tracer& tracer, const Surface& surface, const Draw& draw, int samples,
                Frame& frame) {
  const Shading shading{tracer,
                        surface,
                        {draw.name, Stage::kFinal, draw.view.material},
                        draw.color,
                        lighting_of<Packet>(draw.view, draw.view.material),
                        rays_of(draw.view),
                        samples};
  oneapi::tbb::parallel_for(
      oneapi::tbb::blocked_range2d<int>(0, (frame.height + kTile - 1) / kTile, 1, 0,
                                        (frame.width + kTile - 1) / kTile, 1),
      [&](const oneapi::tbb::blocked_range2d<int>& tiles) {
        for (int y = tiles.rows().begin() * kTile;
             y < std::min(tiles.rows().end() * kTile, frame.height); y += kSide) {
          for (int x = tiles.cols().begin() * kTile;
               x < std::min(tiles.cols().end() * kTile, frame.width); x += kSide) {
            draw_packet(shading, x, y, frame);
          }
        }
      });
}

std::string shading_width() { return fmt::format("{} lanes a packet", kLanes); }

}  // namespace lumaknot::embree
