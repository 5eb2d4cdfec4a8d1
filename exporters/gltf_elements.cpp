#include "exporters/gltf_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "exporters/gltf_outline.h"

namespace lumaknot {
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

/// The accessor's view as bytes, checked.
std::string_view view_of(const GltfFile& file, int index, const std::string& place) {
  const auto& views = file.model.bufferViews;
  if (index < 0) fail_gltf(file.name, place + ".bufferView", "is missing; export it again");
  if (std::size_t(index) >= views.size()) {
    fail_gltf(file.name, place + ".bufferView",
              fmt::format("is {}, but there are {}; export it again", index, views.size()));
  }
  const tinygltf::BufferView& view = views[std::size_t(index)];
  const auto view_place = fmt::format("bufferViews[{}]", index);
  if (std::size_t(view.buffer) >= file.buffers.size()) {
    fail_gltf(
        file.name, view_place + ".buffer",
        fmt::format("is {}, but there are {}; export it again", view.buffer, file.buffers.size()));
  }
  const std::string_view buffer = file.buffers[std::size_t(view.buffer)];
  if (view.byteOffset + view.byteLength > buffer.size()) {  // both below 2^40
    fail_gltf(file.name, view_place,
              fmt::format("ends at byte {} of buffers[{}], which has {}; export it again",
                          view.byteOffset + view.byteLength, view.buffer, buffer.size()));
  }
  return buffer.substr(view.byteOffset, view.byteLength);
}

}  // namespace

GltfElements elements_of(const GltfFile& file, int index, int type, const std::string& path) {
  const auto& accessors = file.model.accessors;
  if (index < 0 || std::size_t(index) >= accessors.size()) {
    fail_gltf(
        file.name, path,
        fmt::format("is {}, but there are {} accessors; export it again", index, accessors.size()));
  }
  const tinygltf::Accessor& a = accessors[std::size_t(index)];
  const auto place = fmt::format("accessors[{}]", index);
  const std::size_t component = component_size(a.componentType);
  if (a.type != type || component == 0) {
    fail_gltf(file.name, place,
              fmt::format("is of a type that {} can't be; export it again", path));
  }
  const std::string_view view = view_of(file, a.bufferView, place);
  const std::size_t width = type == TINYGLTF_TYPE_SCALAR ? 1 : std::size_t(type);
  const std::size_t size = component * width;
  const std::size_t own_stride = file.model.bufferViews[std::size_t(a.bufferView)].byteStride;
  const std::size_t stride = own_stride == 0 ? size : own_stride;
  if (stride < size) {
    fail_gltf(file.name, fmt::format("bufferViews[{}].byteStride", a.bufferView),
              fmt::format("is {}, less than an element's {} bytes; export it again", stride, size));
  }
  // No overflow: count and offset are below 2^40, the stride is at most 252.
  if (a.count == 0 || a.byteOffset + (a.count - 1) * stride + size > view.size()) {
    fail_gltf(file.name, place,
              fmt::format("has {} elements, more than none and no more than its view's {} bytes "
                          "must hold; export it again",
                          a.count, view.size()));
  }
  return {view.data() + a.byteOffset, a.count, stride, a.componentType, a.normalized};
}

std::size_t component_size(int component) {
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

double number_at(const GltfElements& elements, std::size_t i, std::size_t c) {
  const char* at = elements.first + i * elements.stride + c * component_size(elements.component);
  switch (elements.component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return component<std::int8_t>(elements, at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return component<std::uint8_t>(elements, at);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return component<std::int16_t>(elements, at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return component<std::uint16_t>(elements, at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return component<std::uint32_t>(elements, at);
    default:
      return component<float>(elements, at);
  }
}

std::uint32_t index_at(const GltfElements& elements, std::size_t i) {
  const char* at = elements.first + i * elements.stride;
  switch (elements.component) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return unsigned_at<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return unsigned_at<std::uint16_t>(at);
    default:
      return unsigned_at<std::uint32_t>(at);
  }
}

}  // namespace lumaknot
