#include "exporters/gltf/schema.h"

#include <algorithm>
#include <string>
#include <type_traits>

namespace lumaknot::gltf {
namespace {

using Kind = GltfKind;
using Scalar = GltfScalar;
using Shape = GltfShape;
using Member = GltfMember;
using Begin = void (*)(GltfModel& model);
using Put = void (*)(GltfModel& model, const Scalar& value);

constexpr Shape one(Kind kind, Put put) { return {.kind = kind, .put = put}; }
constexpr Shape list_of(const Shape& item, Begin begin = nullptr, std::size_t count = 0) {
  return {.kind = Kind::kList, .item = &item, .count = count, .begin = begin};
}
constexpr Shape object_of(std::span<const Member> members, Begin begin = nullptr) {
  return {.kind = Kind::kObject, .members = members, .begin = begin};
}

/// The last element of each list being read, to which any value belongs.
GltfNode& node(GltfModel& model) { return model.nodes.back(); }
GltfAccessor& accessor(GltfModel& model) { return model.accessors.back(); }
GltfView& view(GltfModel& model) { return model.views.back(); }
GltfPrimitive& primitive(GltfModel& model) { return model.meshes.back().primitives.back(); }

/// A member of the last element.
template <auto& last, auto member>
constexpr Put put_in = [](GltfModel& model, const Scalar& value) {
  auto& place = last(model).*member;
  place = static_cast<std::remove_reference_t<decltype(place)>>(value.integer);
};

constexpr Shape kNumber = one(Kind::kNumber, [](GltfModel& model, const Scalar& value) {
  model.numbers.push_back(value.number);
});

/// `count` numbers of the last node.
template <auto member, std::size_t count>
constexpr Shape kNumbers = list_of(
    kNumber, [](GltfModel& model) { node(model).*member = int(model.numbers.size()); }, count);

constexpr Shape kChild = one(Kind::kIndex, [](GltfModel& model, const Scalar& value) {
  model.node_lists.push_back(int(value.integer));
  ++node(model).children.count;
});
constexpr Shape kRootNode = one(Kind::kIndex, [](GltfModel& model, const Scalar& value) {
  model.node_lists.push_back(int(value.integer));
  ++model.scenes.back().count;
});
constexpr Shape kExtension = one(Kind::kText, [](GltfModel& model, const Scalar& value) {
  model.extensions_required.emplace_back(value.text);
});

constexpr Member kAssetMembers[]{
    {"version",
     one(Kind::kText, [](GltfModel& model, const Scalar& value) { model.version = value.text; }),
     true}};
constexpr Member kSceneMembers[]{{"nodes", list_of(kRootNode, [](GltfModel& model) {
                                    model.scenes.back().first =
                                        std::uint32_t(model.node_lists.size());
                                  })}};
constexpr Member kNodeMembers[]{{"children", list_of(kChild,
                                                     [](GltfModel& model) {
                                                       node(model).children.first =
                                                           std::uint32_t(model.node_lists.size());
                                                     })},
                                {"mesh", one(Kind::kIndex, put_in<node, &GltfNode::mesh>)},
                                {"matrix", kNumbers<&GltfNode::matrix, 16>},
                                {"translation", kNumbers<&GltfNode::translation, 3>},
                                {"rotation", kNumbers<&GltfNode::rotation, 4>},
                                {"scale", kNumbers<&GltfNode::scale, 3>}};
constexpr Member kAttributeMembers[]{
    {"POSITION", one(Kind::kIndex, put_in<primitive, &GltfPrimitive::positions>)},
    {"NORMAL", one(Kind::kIndex, put_in<primitive, &GltfPrimitive::normals>)},
    {"TEXCOORD_0", one(Kind::kIndex, put_in<primitive, &GltfPrimitive::uvs>)}};
constexpr Member kPrimitiveMembers[]{
    {"attributes", object_of(kAttributeMembers), true},
    {"indices", one(Kind::kIndex, put_in<primitive, &GltfPrimitive::indices>)},
    {"mode", one(Kind::kIndex, put_in<primitive, &GltfPrimitive::mode>)}};
constexpr Shape kPrimitive = object_of(
    kPrimitiveMembers, [](GltfModel& model) { model.meshes.back().primitives.emplace_back(); });
constexpr Member kMeshMembers[]{{"primitives", list_of(kPrimitive), true}};
constexpr Member kAccessorMembers[]{
    {"bufferView", one(Kind::kIndex, put_in<accessor, &GltfAccessor::view>)},
    {"byteOffset", one(Kind::kSize, put_in<accessor, &GltfAccessor::offset>)},
    {"componentType", one(Kind::kComponent, put_in<accessor, &GltfAccessor::component>), true},
    {"count", one(Kind::kSize, put_in<accessor, &GltfAccessor::count>), true},
    {"type",
     one(Kind::kType,
         [](GltfModel& model, const Scalar& value) {
           accessor(model).type = GltfType(gltf_type_number(value.text));
         }),
     true},
    {"normalized", one(Kind::kBoolean, put_in<accessor, &GltfAccessor::is_normalized>)},
    {"sparse", {.kind = Kind::kRefused}}};
constexpr Member kViewMembers[]{
    {"buffer", one(Kind::kIndex, put_in<view, &GltfView::buffer>), true},
    {"byteOffset", one(Kind::kSize, put_in<view, &GltfView::offset>)},
    {"byteLength", one(Kind::kSize, put_in<view, &GltfView::size>), true},
    {"byteStride", one(Kind::kStride, put_in<view, &GltfView::stride>)}};
constexpr Member kBufferMembers[]{
    {"byteLength",
     one(Kind::kSize,
         [](GltfModel& model, const Scalar& value) { model.buffers.back().size = value.integer; }),
     true},
    {"uri", one(Kind::kText, [](GltfModel& model, const Scalar& value) {
       model.buffers.back().uri = std::string(value.text);
     })}};

constexpr Shape kScene =
    object_of(kSceneMembers, [](GltfModel& model) { model.scenes.emplace_back(); });
constexpr Shape kNode =
    object_of(kNodeMembers, [](GltfModel& model) { model.nodes.emplace_back(); });
constexpr Shape kMesh =
    object_of(kMeshMembers, [](GltfModel& model) { model.meshes.emplace_back(); });
constexpr Shape kAccessor =
    object_of(kAccessorMembers, [](GltfModel& model) { model.accessors.emplace_back(); });
constexpr Shape kView =
    object_of(kViewMembers, [](GltfModel& model) { model.views.emplace_back(); });
constexpr Shape kBuffer =
    object_of(kBufferMembers, [](GltfModel& model) { model.buffers.emplace_back(); });
constexpr Member kRootMembers[]{
    {"asset", object_of(kAssetMembers), true},
    {"extensionsRequired", list_of(kExtension)},
    {"scene", one(Kind::kIndex,
                  [](GltfModel& model, const Scalar& value) { model.scene = int(value.integer); })},
    {"scenes", list_of(kScene)},
    {"nodes", list_of(kNode)},
    {"meshes", list_of(kMesh)},
    {"accessors", list_of(kAccessor)},
    {"bufferViews", list_of(kView)},
    {"buffers", list_of(kBuffer)}};
constexpr Shape kRoot = object_of(kRootMembers);

}  // namespace

const GltfShape& gltf_root() { return kRoot; }

std::size_t gltf_type_number(std::string_view name) {
  return std::size_t(std::ranges::find(kGltfTypes, name) - kGltfTypes.begin()) + 1;
}

}  // namespace lumaknot::gltf
