#include "validate/gpu/vulkan_scene.h"

#include <fmt/format.h>

#include <array>

#include "validate/gpu/unavailable.h"

namespace lumaknot::gpu {
namespace {

using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;

vk::BufferImageCopy whole_image(vk::Extent2D size) {
  return {0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, {size.width, size.height, 1}};
}

/// Colour and depth are cleared at the start; the colours end up ready to be copied out.
vk::raii::RenderPass make_pass(const VulkanDevice& vulkan) {
  const std::array attachments{
      vk::AttachmentDescription({}, kColorFormat, vk::SampleCountFlagBits::e1,
                                vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eStore,
                                vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                Layout::eUndefined, Layout::eTransferSrcOptimal),
      vk::AttachmentDescription({}, kDepthFormat, vk::SampleCountFlagBits::e1,
                                vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eDontCare,
                                vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                Layout::eUndefined, Layout::eDepthStencilAttachmentOptimal)};
  const vk::AttachmentReference color(0, Layout::eColorAttachmentOptimal);
  const vk::AttachmentReference depth(1, Layout::eDepthStencilAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, color, {}, &depth);
  const vk::SubpassDependency drawn_before_copied(
      0, VK_SUBPASS_EXTERNAL, Stage::eColorAttachmentOutput, Stage::eTransfer,
      Access::eColorAttachmentWrite, Access::eTransferRead);
  return {vulkan.device, vk::RenderPassCreateInfo({}, attachments, subpass, drawn_before_copied)};
}

void check_formats(const VulkanDevice& vulkan) {
  using Feature = vk::FormatFeatureFlagBits;
  const auto needs = [&](vk::Format format, vk::FormatFeatureFlags wanted) {
    const auto has = vulkan.physical.getFormatProperties(format).optimalTilingFeatures;
    if ((has & wanted) == wanted) return;
    throw Unavailable(fmt::format("the Vulkan device lacks {} for {}", vk::to_string(wanted & ~has),
                                  vk::to_string(format)));
  };
  needs(kColorFormat, Feature::eColorAttachment | Feature::eSampledImageFilterLinear);
  needs(kDepthFormat, Feature::eDepthStencilAttachment);
}

/// A layout transition, with what must happen before it and what may happen after.
struct Step {
  Layout from, to;
  vk::PipelineStageFlags before, after;
  vk::AccessFlags written, read;
};

void change_layout(const vk::raii::CommandBuffer& commands, const DeviceImage& image,
                   const Step& step) {
  const vk::ImageMemoryBarrier barrier(step.written, step.read, step.from, step.to,
                                       VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                       *image.image, {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1});
  commands.pipelineBarrier(step.before, step.after, {}, {}, {}, barrier);
}

vk::raii::Sampler make_sampler(const VulkanDevice& vulkan, bool linear) {
  const vk::Filter filter = linear ? vk::Filter::eLinear : vk::Filter::eNearest;
  constexpr auto kRepeat = vk::SamplerAddressMode::eRepeat;
  return {vulkan.device, vk::SamplerCreateInfo({}, filter, filter, vk::SamplerMipmapMode::eNearest,
                                               kRepeat, kRepeat, kRepeat)};
}

SampledImage upload_texture(const VulkanDevice& vulkan, const Texture& texture,
                            const std::string& what) {
  const vk::Extent2D size(std::uint32_t(texture.width), std::uint32_t(texture.height));
  const Buffer staging =
      make_buffer(vulkan, texture.texels.data(), texture.texels.size() * sizeof(float),
                  vk::BufferUsageFlagBits::eTransferSrc);
  DeviceImage image =
      make_image(vulkan, size, kColorFormat,
                 vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst, what);
  submit(vulkan, [&](const vk::raii::CommandBuffer& commands) {
    change_layout(commands, image,
                  {Layout::eUndefined,
                   Layout::eTransferDstOptimal,
                   Stage::eTopOfPipe,
                   Stage::eTransfer,
                   {},
                   Access::eTransferWrite});
    commands.copyBufferToImage(*staging.buffer, *image.image, Layout::eTransferDstOptimal,
                               whole_image(size));
    change_layout(commands, image,
                  {Layout::eTransferDstOptimal, Layout::eShaderReadOnlyOptimal, Stage::eTransfer,
                   Stage::eVertexShader | Stage::eFragmentShader, Access::eTransferWrite,
                   Access::eShaderRead});
  });
  return {std::move(image), make_sampler(vulkan, texture.filter == Filter::kLinear)};
}

}  // namespace

Target make_target(const VulkanDevice& vulkan, const Job& job) {
  using Usage = vk::ImageUsageFlagBits;
  check_formats(vulkan);
  const vk::Extent2D size(std::uint32_t(job.width), std::uint32_t(job.height));
  DeviceImage color = make_image(vulkan, size, kColorFormat,
                                 Usage::eColorAttachment | Usage::eTransferSrc, "the image");
  DeviceImage depth =
      make_image(vulkan, size, kDepthFormat, Usage::eDepthStencilAttachment, "the image");
  vk::raii::RenderPass pass = make_pass(vulkan);
  const std::array views{*color.view, *depth.view};
  vk::raii::Framebuffer framebuffer(
      vulkan.device, vk::FramebufferCreateInfo({}, *pass, views, size.width, size.height, 1));
  Buffer pixels =
      make_buffer(vulkan, image_floats(job) * sizeof(float), vk::BufferUsageFlagBits::eTransferDst);
  return {size,
          std::move(color),
          std::move(depth),
          std::move(pass),
          std::move(framebuffer),
          std::move(pixels)};
}

std::vector<SampledImage> upload_textures(const VulkanDevice& vulkan, const Job& job) {
  std::vector<SampledImage> images;
  images.reserve(job.textures.size());
  for (std::size_t i = 0; i < job.textures.size(); ++i) {
    images.push_back(upload_texture(vulkan, job.textures[i], fmt::format("textures[{}]", i)));
  }
  return images;
}

std::optional<MeshBuffers> upload_mesh(const VulkanDevice& vulkan, const Job& job) {
  using Usage = vk::BufferUsageFlagBits;
  if (!job.mesh) return std::nullopt;
  const auto upload = [&](const auto& values, Usage usage) {
    return make_buffer(vulkan, values.data(), values.size() * sizeof(values.front()), usage);
  };
  return MeshBuffers{upload(job.mesh->vertices, Usage::eVertexBuffer),
                     upload(job.mesh->indices, Usage::eIndexBuffer)};
}

}  // namespace lumaknot::gpu
