#include "exporters/image/module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "system/error.h"

namespace lumaknot {
namespace {

/// The module's path. Derived from the program's own file, not from the loader's $ORIGIN: under
/// AddressSanitizer that is the sanitizer's folder, since it intercepts dlopen.
std::filesystem::path module_path() {
  std::error_code unreadable;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unreadable);
  const auto beside = program.parent_path() / LUMAKNOT_IMAGES_MODULE;
  const auto above = program.parent_path().parent_path() / LUMAKNOT_IMAGES_MODULE;
  std::error_code missing;
  return !std::filesystem::exists(beside, missing) && std::filesystem::exists(above, missing)
             ? above
             : beside;
}

}  // namespace

const ImageCodec& image_codec() {
  // Loading twice gives the same module, so nothing needs to be kept between calls.
  void* module = ::dlopen(module_path().c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* function = module ? ::dlsym(module, "lumaknot_image_codec") : nullptr;
  if (!function) {
    throw Error(
        fmt::format("{} is needed for image files and can't be loaded ({}): build all of "
                    "lumaknot and keep that file next to the program",
                    LUMAKNOT_IMAGES_MODULE, ::dlerror()));
  }
  return *reinterpret_cast<decltype(&lumaknot_image_codec)>(function)();
}

}  // namespace lumaknot
