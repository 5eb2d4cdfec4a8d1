#include "shaders/record.h"

#include "shaders/lighting.h"

namespace lumaknot {

NodePtr record_shot(const View& view, const Shot& shot) {
  const Material& m = shot.material;
  const SurfacePoint<Scalar> point{vector_input("position"), vector_input("normal"),
                                   vector_input("texture")};
  const Lighting<Scalar> lighting{vector_parameter("eye_position", view.camera.position),
                                  vector_parameter("light_position", view.light.position),
                                  scalar_parameter("ambient", view.ambient),
                                  scalar_parameter("diffuse", m.diffuse),
                                  scalar_parameter("specular", m.specular),
                                  scalar_parameter("shininess", m.shininess),
                                  scalar_parameter("luma_offset", m.luma_offset)};
  return stage_color(point, lighting, shot).node;
}

}  // namespace lumaknot
