#include "validate/gpu/vulkan_run.h"

#include <array>

#include "validate/gpu/vulkan_pipeline.h"

namespace lumaknot::gpu {

struct VulkanRun::State {
  const Job& job;
  VulkanDevice vulkan;
  Target target;
  std::vector<SampledImage> images;
  std::optional<MeshBuffers> mesh;

  explicit State(const Job& j)
      : job(j),
        target(make_target(vulkan, j)),
        images(upload_textures(vulkan, j)),
        mesh(upload_mesh(vulkan, j)) {}
};

namespace {

constexpr std::array<vk::ClearValue, 2> cleared() {
  return {vk::ClearColorValue(std::array{0.0f, 0.0f, 0.0f, 0.0f}),
          vk::ClearDepthStencilValue(1.0f, 0)};
}

void record_mesh(const vk::raii::CommandBuffer& commands, const MeshBuffers& mesh,
                 std::size_t indices) {
  commands.bindVertexBuffers(0, *mesh.vertices.buffer, vk::DeviceSize(0));
  commands.bindIndexBuffer(*mesh.indices.buffer, 0, vk::IndexType::eUint32);
  commands.drawIndexed(std::uint32_t(indices), 1, 0, 0, 0);
}

/// Makes what the device wrote into the target's buffer visible to this program.
void record_copy_out(const vk::raii::CommandBuffer& commands, const Target& target) {
  const vk::BufferImageCopy whole(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                  {target.size.width, target.size.height, 1});
  commands.copyImageToBuffer(*target.color.image, vk::ImageLayout::eTransferSrcOptimal,
                             *target.pixels.buffer, whole);
  const vk::MemoryBarrier readable(vk::AccessFlagBits::eTransferWrite,
                                   vk::AccessFlagBits::eHostRead);
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eHost,
                           {}, readable, {}, {});
}

}  // namespace

VulkanRun::VulkanRun(const Job& job) : state_(std::make_unique<State>(job)) {}
VulkanRun::~VulkanRun() = default;

std::vector<float> VulkanRun::draw(const Draw& draw) const {
  const State& s = *state_;
  const Bindings bindings = make_bindings(s.vulkan, s.job, draw, s.images);
  const vk::raii::Pipeline pipeline = make_pipeline(s.vulkan, s.target, bindings, s.job, draw);
  submit(s.vulkan, [&](const vk::raii::CommandBuffer& commands) {
    const auto clear = cleared();
    commands.beginRenderPass({*s.target.pass, *s.target.framebuffer, {{}, s.target.size}, clear},
                             vk::SubpassContents::eInline);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *bindings.layout, 0,
                                *bindings.set, {});
    if (s.mesh) {
      record_mesh(commands, *s.mesh, s.job.mesh->indices.size());
    } else {
      commands.draw(3, 1, 0, 0);
    }
    commands.endRenderPass();
    record_copy_out(commands, s.target);
  });
  std::vector<float> pixels(image_floats(s.job));
  read_buffer(s.target.pixels, pixels.data());
  return pixels;
}

}  // namespace lumaknot::gpu
