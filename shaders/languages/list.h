/// The languages that shaders are emitted to, a line each, in the order of the documentation.
///
/// NAME stands for the value Language::kNAME and for the Backend called kNAMEBackend, which a file
/// of its own in this folder defines: one that is missing does not link.
#define LUMAKNOT_LANGUAGES(language)                                                  \
  language(Glsl330) language(GlslEs300) language(Glsl450) language(Hlsl) language(Fx) \
      language(Osl) language(Blender) language(Pov)
