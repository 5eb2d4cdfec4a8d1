/// The renderers, a line each, in the order in which they are reported.
///
/// NAME stands for the RendererEntry kNAMEEntry, which a file of its own in this folder defines:
/// one that is missing does not link.
#define LUMAKNOT_RENDERERS(renderer)                                                             \
  renderer(Cycles) renderer(Povray) renderer(Eevee) renderer(Gl) renderer(Vulkan) renderer(Gles) \
      renderer(Hlsl) renderer(Osl)
