/// What plants faults that several lists have.
#pragma once

#include "scene/triangle_mesh.h"
#include "validate/self_test/faults.h"

namespace lumaknot::validate {

/// Every triangle with three vertices of its own and its own normal.
TriangleMesh with_flat_normals(const TriangleMesh& mesh);

/// The transfer function of sRGB, written for the self-test alone: the diagnosis has its own.
Vec3d encoded_srgb(const Vec3d& linear);
Vec3d decoded_srgb(const Vec3d& encoded);

}  // namespace lumaknot::validate
