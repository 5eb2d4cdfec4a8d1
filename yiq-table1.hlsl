// yiq-table1, made by lumaknot.
// Entry points: vertex_main (vs_5_0, vs_6_0), fragment_main (ps_5_0, ps_6_0).

cbuffer Parameters : register(b0) {
  column_major float4x4 world;
  column_major float4x4 world_inverse_transpose;
  column_major float4x4 world_view_projection;
  float3 light_position;  // the lamp, world space (scene units)
  float3 eye_position;  // the eye, world space (scene units)
  float ambient;  // ambient light times its weight, L_A (of white)
  float shininess;  // k of the highlight max(v.R, 0)^k (exponent)
  float luma_offset;  // added to the lit brightness; Table 1: -0.1 (of white)
};

Texture2D color_texture : register(t0);  // the surface's colour, r'g'b' as it is in the file: no sRGB decoding (image)
SamplerState color_sampler : register(s0);

struct Vertex {
  float3 position : POSITION;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};

struct Surface {
  float4 clip_position : SV_Position;
  float3 position : TEXCOORD0;
  float3 normal : TEXCOORD1;
  float2 uv : TEXCOORD2;
};

// base >= 0; 0 to the power 0 is 1.
float safe_power(float base, float exponent) {
  return base > 0.0 ? pow(base, exponent) : (exponent > 0.0 ? 0.0 : 1.0);
}

// Zero stays zero.
float3 safe_normalize(float3 v) {
  return v * rsqrt(max(dot(v, v), 1e-36));
}

float3 yiq_table1(float3 position, float3 normal, float3 texture_color) {
  float y = dot(float3(0.29889531, 0.58662247, 0.11448223), texture_color);
  float3 to_light = safe_normalize(light_position - position);
  float n_dot_l = dot(normal, to_light);
  float light = saturate(saturate(n_dot_l) + ambient);
  float3 reflection = safe_normalize(normal * (2.0 * n_dot_l) - to_light);
  float3 to_eye = safe_normalize(eye_position - position);
  float r_dot_v = max(dot(reflection, to_eye), 0.0);
  float highlight = safe_power(r_dot_v, shininess);
  float lit_brightness = y * light + highlight + luma_offset;
  float i = dot(float3(0.59597799, -0.2741761, -0.32180189), texture_color);
  float q = dot(float3(0.21147017, -0.52261711, 0.31114694), texture_color);
  return saturate(float3(lit_brightness, lit_brightness, lit_brightness) + float3(0.95608445,
      -0.27137664, -1.10561724) * i + float3(0.6208885, -0.6486059, 1.70250126) * q);
}

Surface vertex_main(Vertex vertex) {
  Surface surface;
  float3 position = mul(world, float4(vertex.position, 1.0)).xyz;
  float3 normal =
      safe_normalize(mul(world_inverse_transpose, float4(vertex.normal, 0.0)).xyz);
  surface.position = position;
  surface.normal = normal;
  surface.uv = vertex.uv;
  surface.clip_position = mul(world_view_projection, float4(vertex.position, 1.0));
  return surface;
}

float4 fragment_main(Surface surface) : SV_Target {
  return float4(yiq_table1(surface.position, surface.normal, color_texture.Sample(color_sampler,
      surface.uv).rgb), 1.0);
}
