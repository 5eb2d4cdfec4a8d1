// tinygltf itself, which is a header, without its image decoders and without its file access: see
// the definitions in CMakeLists.txt, which every file that includes it must share.
#include <fstream>  // which tinygltf forgets without file access
#include <sstream>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
