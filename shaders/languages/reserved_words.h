/// The words that names of a language may not be: its keywords, those that it reserves, its
/// functions, and what our own skeletons declare.
#pragma once

#include <string_view>

namespace lumaknot {

// Words as in a dictionary, not one a line.
// clang-format off

// GLSL 1.30 to 4.60 and GLSL ES 3.00.
inline constexpr std::string_view kGlslWords[] = {
    "Parameters", "abs", "acos", "acosh", "active", "all", "any", "asin", "asinh", "asm", "atan",
    "atanh", "atomic_uint", "attribute", "axes_texture", "bool", "break", "buffer", "bvec2",
    "bvec3", "bvec4", "case", "cast", "ceil", "centroid", "clamp", "class", "coherent",
    "color_texture", "common", "const", "continue", "cos", "cosh", "cross", "dFdx", "dFdy",
    "default", "degrees", "demote", "determinant", "discard", "distance", "dmat2", "dmat3",
    "dmat4", "do", "dot", "double", "dvec2", "dvec3", "dvec4", "else", "enum", "equal", "exp",
    "exp2", "extern", "external", "faceforward", "false", "filter", "fixed", "flat", "float",
    "floor", "fma", "for", "fract", "fragment_color", "frexp", "fvec2", "fvec3", "fvec4", "fwidth",
    "goto", "greaterThan", "half", "highp", "hvec2", "hvec3", "hvec4", "if", "iimage2D", "image1D",
    "image2D", "image3D", "imageBuffer", "imageCube", "in", "inline", "inout", "input", "int",
    "interface", "interpolateAtSample", "invariant", "inverse", "inversesqrt", "isampler2D",
    "isampler3D", "isamplerCube", "isinf", "isnan", "ivec2", "ivec3", "ivec4", "layout", "ldexp",
    "length", "lessThan", "log", "log2", "long", "lowp", "main", "mat2", "mat3", "mat4",
    "matrixCompMult", "max", "mediump", "min", "mix", "mod", "modf", "namespace", "noinline",
    "noise1", "noise2", "noise3", "noperspective", "normalize", "not", "notEqual", "out",
    "outerProduct", "output", "partition", "patch", "pow", "precise", "precision", "public",
    "radians", "readonly", "reflect", "refract", "resource", "restrict", "return", "round",
    "roundEven", "safe_normalize", "safe_power", "sample", "sampler", "sampler1D", "sampler2D",
    "sampler2DShadow", "sampler3D", "samplerBuffer", "samplerCube", "samplerCubeShadow", "shared",
    "short", "sign", "sin", "sinh", "sizeof", "smooth", "smoothstep", "sqrt", "static", "step",
    "struct", "subroutine", "superp", "surface_normal", "surface_position", "surface_uv", "switch",
    "tan", "tanh", "template", "texelFetch", "texture", "texture1D", "texture2D", "texture3D",
    "textureCube", "textureGrad", "textureLod", "textureOffset", "textureProj", "textureSize",
    "this", "transpose", "true", "trunc", "typedef", "uimage2D", "uint", "uniform", "union",
    "unsigned", "usampler2D", "using", "uvec2", "uvec3", "uvec4", "varying", "vec2", "vec3",
    "vec4", "vertex_normal", "vertex_position", "vertex_uv", "void", "volatile", "while", "world",
    "world_inverse_transpose", "world_view_projection", "writeonly"};

// HLSL, shader models 2 to 6, and effects.
inline constexpr std::string_view kHlslWords[] = {
    "AppendStructuredBuffer", "BlendState", "Buffer", "ByteAddressBuffer", "ColorSampler",
    "ColorTexture", "CompileShader", "ComputeShader", "ConsumeStructuredBuffer",
    "DepthStencilState", "DepthStencilView", "DomainShader", "GeometryShader", "Hullshader",
    "InputPatch", "LineStream", "NULL", "OutputPatch", "Parameters", "PixelShader", "PointStream",
    "RWBuffer", "RWTexture2D", "RasterizerState", "RenderTargetView", "SamplerComparisonState",
    "SamplerState", "StructuredBuffer", "Surface", "Texture1D", "Texture2D", "Texture3D",
    "TextureCube", "TriangleStream", "Vertex", "VertexShader", "abort", "abs", "acos", "all",
    "any", "asfloat", "asin", "asint", "asm", "asm_fragment", "asuint", "atan", "atan2", "auto",
    "axes_texture", "bool", "break", "case", "catch", "cbuffer", "ceil", "centroid", "char",
    "clamp", "class", "clip", "color_sampler", "color_texture", "column_major", "compile",
    "compile_fragment", "const", "const_cast", "continue", "cos", "cosh", "cross", "ddx", "ddy",
    "decl", "default", "degrees", "delete", "determinant", "discard", "distance", "do", "dot",
    "double", "dst", "dword", "dynamic_cast", "else", "enum", "errorf", "exp", "exp2", "explicit",
    "export", "extern", "faceforward", "false", "firstbithigh", "float", "float2", "float3",
    "float3x3", "float4", "float4x4", "floor", "fma", "fmod", "for", "frac", "fragment_main",
    "frexp", "friend", "fwidth", "fxgroup", "goto", "groupshared", "half", "half2", "half3",
    "half4", "if", "in", "inline", "inout", "int", "int2", "int3", "int4", "interface", "isfinite",
    "isinf", "isnan", "ldexp", "length", "lerp", "line", "lineadj", "linear", "lit", "log",
    "log10", "log2", "long", "lowp", "mad", "matrix", "max", "min", "min10float", "min12int",
    "min16float", "min16int", "min16uint", "modf", "msad4", "mul", "mutable", "namespace", "new",
    "nointerpolation", "noise", "noperspective", "normalize", "operator", "out", "packoffset",
    "pass", "pixelfragment", "pixelshader", "point", "pointadj", "pow", "precise", "printf",
    "private", "protected", "public", "radians", "rcp", "reflect", "refract", "register",
    "reinterpret_cast", "return", "reversebits", "round", "row_major", "rsqrt", "safe_normalize",
    "safe_power", "sample", "sampler", "sampler1D", "sampler2D", "sampler3D", "samplerCUBE",
    "sampler_state", "saturate", "shared", "short", "sign", "signed", "sin", "sincos", "sinh",
    "sizeof", "smoothstep", "snorm", "sqrt", "stateblock", "stateblock_state", "static",
    "static_cast", "step", "string", "struct", "switch", "tan", "tanh", "tbuffer", "technique",
    "technique10", "technique11", "template", "tex1D", "tex2D", "tex2Dlod", "tex3D", "texCUBE",
    "texture", "texture1D", "texture2D", "texture3D", "textureCUBE", "this", "throw", "transpose",
    "triangle", "triangleadj", "true", "trunc", "try", "typedef", "typename", "uint", "uint2",
    "uint3", "uint4", "uniform", "union", "unorm", "unsigned", "using", "vector", "vertex_main",
    "vertexfragment", "vertexshader", "virtual", "void", "volatile", "while", "world",
    "world_inverse_transpose", "world_view_projection"};

// OSL 1.12.
inline constexpr std::string_view kOslWords[] = {
    "Ci", "Dx", "Dy", "Dz", "I", "M_E", "M_PI", "M_PI_2", "M_SQRT2", "N", "Ng", "P", "Ps",
    "aastep", "abs", "absorption", "acos", "ambient_occlusion", "and", "area", "arraylength",
    "ashikhmin_velvet", "asin", "atan", "atan2", "atof", "atoi", "backfacing", "background",
    "bitand", "blackbody", "bool", "break", "bssrdf", "bump", "calculatenormal", "case", "catch",
    "cbrt", "ceil", "cellnoise", "char", "clamp", "class", "closure", "color", "compl", "concat",
    "const", "constant", "continue", "cos", "cosh", "cross", "dPdtime", "dPdu", "dPdv", "debug",
    "default", "degrees", "determinant", "dict_find", "dict_next", "dict_value", "diffuse",
    "diffuse_ramp", "diffuse_toon", "displace", "displacement", "distance", "do", "dot", "double",
    "dtime", "else", "emission", "emit", "endswith", "enum", "environment", "erf", "erfc", "error",
    "exit", "exp", "exp2", "expm1", "extern", "fabs", "faceforward", "false", "filterwidth",
    "float", "floor", "fmod", "for", "format", "fprintf", "fresnel", "friend", "getattribute",
    "getchar", "getmatrix", "getmessage", "gettextureinfo", "global", "goto", "hair_diffuse",
    "hair_reflection", "half", "hash", "hashnoise", "henyey_greenstein", "holdout", "hypot", "if",
    "illuminance", "illuminate", "imager", "in", "inline", "int", "inversesqrt", "isconnected",
    "isconstant", "isfinite", "isinf", "isnan", "layer", "length", "light", "linearstep", "log",
    "log10", "log2", "logb", "long", "luminance", "matrix", "max", "microfacet", "min", "mix",
    "mod", "new", "nil", "noise", "normal", "normalize", "not", "operator", "or", "oren_nayar",
    "out", "output", "perspective", "phong", "phong_ramp", "pnoise", "point", "pointcloud_get",
    "pointcloud_search", "pointcloud_write", "pow", "printf", "private", "protected", "psnoise",
    "public", "radians", "random", "raytype", "reflect", "reflection", "refract", "refraction",
    "regex_match", "regex_search", "return", "rotate", "round", "safe_normalize", "safe_power",
    "select", "setmessage", "shader", "sheen", "short", "sign", "signed", "sin", "sincos", "sinh",
    "sizeof", "smooth_linearstep", "smoothstep", "snoise", "spectrum", "spline", "splineinverse",
    "split", "sqrt", "startswith", "static", "step", "stof", "stoi", "string", "strlen", "strtof",
    "struct", "substr", "subsurface", "surface", "surfacearea", "switch", "tan", "tanh",
    "template", "texture", "texture3d", "this", "throw", "time", "trace", "transform",
    "transformc", "transformn", "transformp", "transformu", "translucent", "transparent",
    "transpose", "true", "trunc", "try", "typedef", "u", "uniform", "union", "unsigned", "using",
    "v", "varying", "vector", "vertex", "virtual", "void", "volatile", "volume", "ward", "warning",
    "wavelength_color", "while"};

// clang-format on

}  // namespace lumaknot
