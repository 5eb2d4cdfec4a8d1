/// The formats of meshes, in the order in which messages list their endings.
///
/// NAME stands for the MeshFormat kNAMEFormat, which the format's own folder defines: one that is
/// missing does not link. POV-Ray's are two: one is read, the other is written.
#define LUMAKNOT_MESH_FORMATS(format)                                                 \
  format(Obj) format(Ply) format(Stl) format(Off) format(Om) format(Pov) format(Gltf) \
      format(PovInclude)
