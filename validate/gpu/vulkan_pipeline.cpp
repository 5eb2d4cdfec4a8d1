#include "validate/gpu/vulkan_pipeline.h"

#include <array>

#include "validate/gpu/spirv.h"

namespace lumaknot::gpu {
namespace {

constexpr vk::VertexInputBindingDescription kVertexBinding(0, kFloatsPerVertex * sizeof(float),
                                                           vk::VertexInputRate::eVertex);

/// Positions are location 0, normals 1, texture coordinates 2.
constexpr std::array kVertexAttributes{
    vk::VertexInputAttributeDescription(0, 0, vk::Format::eR32G32B32Sfloat, 0),
    vk::VertexInputAttributeDescription(1, 0, vk::Format::eR32G32B32Sfloat, 3 * sizeof(float)),
    vk::VertexInputAttributeDescription(2, 0, vk::Format::eR32G32Sfloat, 6 * sizeof(float))};

vk::PipelineVertexInputStateCreateInfo vertex_input(bool with_mesh) {
  if (!with_mesh) return {};
  return {
      {}, 1, &kVertexBinding, std::uint32_t(kVertexAttributes.size()), kVertexAttributes.data()};
}

vk::PipelineRasterizationStateCreateInfo rasterization() {
  vk::PipelineRasterizationStateCreateInfo state;
  state.polygonMode = vk::PolygonMode::eFill;
  state.cullMode = vk::CullModeFlagBits::eNone;
  state.lineWidth = 1;
  return state;
}

vk::PipelineColorBlendAttachmentState no_blending() {
  using Channel = vk::ColorComponentFlagBits;
  vk::PipelineColorBlendAttachmentState state;
  state.colorWriteMask = Channel::eR | Channel::eG | Channel::eB | Channel::eA;
  return state;
}

}  // namespace

vk::raii::Pipeline make_pipeline(const VulkanDevice& vulkan, const Target& target,
                                 const Bindings& bindings, const Job& job, const Draw& draw) {
  const SpirvStages code = checked_spirv(job, draw);
  const vk::raii::ShaderModule vertex(vulkan.device, vk::ShaderModuleCreateInfo({}, code.vertex));
  const vk::raii::ShaderModule fragment(vulkan.device,
                                        vk::ShaderModuleCreateInfo({}, code.fragment));
  using Bit = vk::ShaderStageFlagBits;
  const std::array stages{
      vk::PipelineShaderStageCreateInfo({}, Bit::eVertex, *vertex, draw.vertex.entry.c_str()),
      vk::PipelineShaderStageCreateInfo({}, Bit::eFragment, *fragment,
                                        draw.fragment.entry.c_str())};
  const vk::PipelineVertexInputStateCreateInfo input = vertex_input(job.mesh.has_value());
  const vk::PipelineInputAssemblyStateCreateInfo triangles({},
                                                           vk::PrimitiveTopology::eTriangleList);
  const vk::Viewport whole(0, 0, float(target.size.width), float(target.size.height), 0, 1);
  const vk::Rect2D all({}, target.size);
  const vk::PipelineViewportStateCreateInfo viewport({}, whole, all);
  const vk::PipelineRasterizationStateCreateInfo raster = rasterization();
  const vk::PipelineMultisampleStateCreateInfo one_sample;
  const vk::PipelineDepthStencilStateCreateInfo depth({}, true, true, vk::CompareOp::eLessOrEqual);
  const vk::PipelineColorBlendAttachmentState channels = no_blending();
  const vk::PipelineColorBlendStateCreateInfo blending({}, false, {}, channels);
  return {vulkan.device, nullptr,
          vk::GraphicsPipelineCreateInfo({}, stages, &input, &triangles, nullptr, &viewport,
                                         &raster, &one_sample, &depth, &blending, nullptr,
                                         *bindings.layout, *target.pass, 0)};
}

}  // namespace lumaknot::gpu
