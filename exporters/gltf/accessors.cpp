#include "exporters/gltf/accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "exporters/gltf/json.h"

namespace lumaknot::gltf {
namespace {

template <class T>
double component(const GltfElements& elements, const char* at) {
  T value{};
  std::memcpy(&value, at, sizeof(value));
  if constexpr (std::is_integral_v<T>) {
    if (elements.is_normalized) {
      return std::max(double(value) / double(std::numeric_limits<T>::max()), -1.0);
    }
  }
  return double(value);
}

template <class T>
std::uint32_t unsigned_at(const char* at) {
  T value{};
  std::memcpy(&value, at, sizeof(value));
  return value;
}

/// The bytes of one component.
std::size_t component_size(int component) {
  switch (component) {
    case kGltfByte:
    case kGltfUnsignedByte:
      return 1;
    case kGltfShort:
    case kGltfUnsignedShort:
      return 2;
    case kGltfUnsignedInt:
    case kGltfFloat:
      return 4;
    default:
      return 0;
  }
}

/// The accessor's view as bytes, checked.
std::string_view view_of(const GltfFile& file, int index, const std::string& place) {
  const auto& views = file.model.views;
  if (index < 0) fail_gltf(file.name, place + ".bufferView", "is missing; export it again");
  if (std::size_t(index) >= views.size()) {
    fail_gltf(file.name, place + ".bufferView",
              fmt::format("is {}, but there are {}; export it again", index, views.size()));
  }
  const GltfView& view = views[std::size_t(index)];
  const auto view_place = fmt::format("bufferViews[{}]", index);
  if (std::size_t(view.buffer) >= file.buffers.size()) {
    fail_gltf(
        file.name, view_place + ".buffer",
        fmt::format("is {}, but there are {}; export it again", view.buffer, file.buffers.size()));
  }
  const std::string_view buffer = file.buffers[std::size_t(view.buffer)];
  if (view.offset + view.size > buffer.size()) {  // both below 2^40
    fail_gltf(file.name, view_place,
              fmt::format("ends at byte {} of buffers[{}], which has {}; export it again",
                          view.offset + view.size, view.buffer, buffer.size()));
  }
  return buffer.substr(view.offset, view.size);
}

}  // namespace

GltfElements elements_of(const GltfFile& file, int index, GltfType type, const std::string& path) {
  const auto& accessors = file.model.accessors;
  if (index < 0 || std::size_t(index) >= accessors.size()) {
    fail_gltf(
        file.name, path,
        fmt::format("is {}, but there are {} accessors; export it again", index, accessors.size()));
  }
  const GltfAccessor& a = accessors[std::size_t(index)];
  const auto place = fmt::format("accessors[{}]", index);
  if (a.type != type) {
    fail_gltf(file.name, place,
              fmt::format("has a type that {} can't have; export it again", path));
  }
  const std::string_view view = view_of(file, a.view, place);
  const std::size_t component = component_size(a.component);
  const std::size_t size = component * std::size_t(type);
  const std::size_t own_stride = file.model.views[std::size_t(a.view)].stride;
  const std::size_t stride = own_stride == 0 ? size : own_stride;
  if (stride < size) {
    fail_gltf(file.name, fmt::format("bufferViews[{}].byteStride", a.view),
              fmt::format("is {}, less than an element's {} bytes; export it again", stride, size));
  }
  // No overflow: count and offset are below 2^40, the stride is at most 252.
  if (a.count == 0 || a.offset + (a.count - 1) * stride + size > view.size()) {
    fail_gltf(file.name, place,
              fmt::format("has {} elements, which must be at least one and fit in its view's {} "
                          "bytes; export it again",
                          a.count, view.size()));
  }
  return {view.data() + a.offset, a.count, stride, a.component, a.is_normalized};
}

double number_at(const GltfElements& elements, std::size_t i, std::size_t c) {
  const char* at = elements.first + i * elements.stride + c * component_size(elements.component);
  switch (elements.component) {
    case kGltfByte:
      return component<std::int8_t>(elements, at);
    case kGltfUnsignedByte:
      return component<std::uint8_t>(elements, at);
    case kGltfShort:
      return component<std::int16_t>(elements, at);
    case kGltfUnsignedShort:
      return component<std::uint16_t>(elements, at);
    case kGltfUnsignedInt:
      return component<std::uint32_t>(elements, at);
    default:
      return component<float>(elements, at);
  }
}

std::uint32_t index_at(const GltfElements& elements, std::size_t i) {
  const char* at = elements.first + i * elements.stride;
  switch (elements.component) {
    case kGltfUnsignedByte:
      return unsigned_at<std::uint8_t>(at);
    case kGltfUnsignedShort:
      return unsigned_at<std::uint16_t>(at);
    default:
      return unsigned_at<std::uint32_t>(at);
  }
}

}  // namespace lumaknot::gltf
