#include <algorithm>

#include "validate/gpu/vulkan_pipeline.h"

namespace lumaknot::gpu {
namespace {

using Type = vk::DescriptorType;

/// One resource of descriptor set 0; either `image` or `buffer` is set.
struct Slot {
  int binding;
  Type type;
  vk::DescriptorImageInfo image;
  vk::DescriptorBufferInfo buffer;
};

std::vector<Slot> texture_slots(const Texture& texture, const SampledImage& image) {
  constexpr auto kLayout = vk::ImageLayout::eShaderReadOnlyOptimal;
  const vk::DescriptorImageInfo both(*image.sampler, *image.image.view, kLayout);
  if (texture.sampler < 0) return {{texture.binding, Type::eCombinedImageSampler, both, {}}};
  return {{texture.binding, Type::eSampledImage, {{}, *image.image.view, kLayout}, {}},
          {texture.sampler, Type::eSampler, {*image.sampler, {}, {}}, {}}};
}

std::vector<Slot> all_slots(const Job& job, const Draw& draw, const std::optional<Buffer>& block,
                            const std::vector<SampledImage>& images) {
  std::vector<Slot> slots;
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (const Slot& slot : texture_slots(job.textures[i], images[i])) slots.push_back(slot);
  }
  if (block) {
    slots.push_back(
        {draw.uniform_binding, Type::eUniformBuffer, {}, {*block->buffer, 0, block->size}});
  }
  return slots;
}

std::optional<Buffer> upload_block(const VulkanDevice& vulkan, const Draw& draw) {
  if (!draw.uniform_block) return std::nullopt;
  return make_buffer(vulkan, draw.uniform_block->data(), draw.uniform_block->size(),
                     vk::BufferUsageFlagBits::eUniformBuffer);
}

vk::raii::DescriptorSetLayout make_set_layout(const VulkanDevice& vulkan,
                                              const std::vector<Slot>& slots) {
  constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  bindings.reserve(slots.size());
  for (const Slot& slot : slots) {
    bindings.emplace_back(std::uint32_t(slot.binding), slot.type, 1, kStages);
  }
  return {vulkan.device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

/// A pool for one set; a pool without sizes is not allowed.
vk::raii::DescriptorPool make_pool(const VulkanDevice& vulkan, const std::vector<Slot>& slots) {
  std::vector<vk::DescriptorPoolSize> sizes{{Type::eUniformBuffer, 1}};
  for (const Slot& slot : slots) sizes.emplace_back(slot.type, 1);
  return {vulkan.device, vk::DescriptorPoolCreateInfo(
                             vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
}

void fill(const VulkanDevice& vulkan, const vk::raii::DescriptorSet& set,
          const std::vector<Slot>& slots) {
  std::vector<vk::WriteDescriptorSet> writes;
  for (const Slot& slot : slots) {
    vk::WriteDescriptorSet write(*set, std::uint32_t(slot.binding), 0, 1, slot.type, &slot.image);
    write.pBufferInfo = &slot.buffer;
    writes.push_back(write);
  }
  vulkan.device.updateDescriptorSets(writes, {});
}

}  // namespace

Bindings make_bindings(const VulkanDevice& vulkan, const Job& job, const Draw& draw,
                       const std::vector<SampledImage>& images) {
  std::optional<Buffer> block = upload_block(vulkan, draw);
  const std::vector<Slot> slots = all_slots(job, draw, block, images);
  vk::raii::DescriptorSetLayout set_layout = make_set_layout(vulkan, slots);
  vk::raii::PipelineLayout layout(vulkan.device, vk::PipelineLayoutCreateInfo({}, *set_layout));
  vk::raii::DescriptorPool pool = make_pool(vulkan, slots);
  vk::raii::DescriptorSets sets(vulkan.device, vk::DescriptorSetAllocateInfo(*pool, *set_layout));
  fill(vulkan, sets.front(), slots);
  return {std::move(block), std::move(set_layout), std::move(layout), std::move(pool),
          std::move(sets.front())};
}

}  // namespace lumaknot::gpu
