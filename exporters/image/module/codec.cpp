#include "exporters/image/module/codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <memory>
#include <stdexcept>

namespace lumaknot {
namespace {

std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path) {
  // Unassociated alpha would otherwise be multiplied into colours that are used unchanged.
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) throw std::runtime_error(OIIO::geterror());
  return input;
}

DecodedImage decode(const std::filesystem::path& path,
                    const std::function<void(const ImageSize&)>& check) {
  const auto input = open_image(path);
  const OIIO::ImageSpec& spec = input->spec();
  DecodedImage image;
  image.size = {spec.width, spec.height, spec.nchannels, spec.depth};
  check(image.size);
  image.is_png = std::string_view(input->format_name()) == "png";
  image.values.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, image.values.data())) {
    throw std::runtime_error(input->geterror());
  }
  return image;
}

/// The bytes of a file in the format of `extension`; `spec` describes the samples.
std::string encode(const std::string& extension, const OIIO::ImageSpec& spec, const void* values) {
  const std::string name = "memory." + extension;
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) throw std::runtime_error(OIIO::geterror());
  output->set_ioproxy(&memory);
  if (!output->open(name, spec) || !output->write_image(spec.format, values) || !output->close()) {
    throw std::runtime_error(extension + ": " + output->geterror());
  }
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class Integer>
std::string encode_png(const ImageSize& size, std::span<const Integer> values, int compression) {
  OIIO::ImageSpec spec(size.width, size.height, size.channels, OIIO::BaseTypeFromC<Integer>::value);
  spec["oiio:Gamma"] = 1.0f;
  spec["oiio:UnassociatedAlpha"] = 1;
  spec["png:compressionLevel"] = compression;
  return encode("png", spec, values.data());
}

std::string encode_exr(const ImageSize& size, std::span<const float> values) {
  OIIO::ImageSpec spec(size.width, size.height, size.channels, OIIO::TypeFloat);
  // The writer would otherwise put the current time into the file.
  spec["DateTime"] = "1970:01:01 00:00:00";
  return encode("exr", spec, values.data());
}

std::string base64(std::string_view bytes) {
  return OIIO::Strutil::base64_encode({bytes.data(), bytes.size()});
}

constexpr ImageCodec kCodec{decode, encode_png<std::uint8_t>, encode_png<std::uint16_t>, encode_exr,
                            base64};

}  // namespace
}  // namespace lumaknot

const lumaknot::ImageCodec* lumaknot_image_codec() { return &lumaknot::kCodec; }
