# Writes OUTPUT, a C++ file whose function lumaknot::embedded::SYMBOL() returns the text of SOURCE. For a
# script also SYMBOL_sha256(), by which a page's Content-Security-Policy admits it: its hash in base64.
# Bytes, not a raw string: compilers limit the length of string literals.
file(READ ${SOURCE} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
set(hash_function "")
if(SOURCE MATCHES "\\.js$")
  set(digits "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  file(SHA256 ${SOURCE} hash)
  set(base64 "")
  foreach(at RANGE 0 60 6)
    string(SUBSTRING "${hash}00" ${at} 6 three_bytes)
    foreach(shift IN ITEMS 18 12 6 0)
      math(EXPR digit "(0x${three_bytes} >> ${shift}) & 63")
      string(SUBSTRING ${digits} ${digit} 1 character)
      string(APPEND base64 ${character})
    endforeach()
  endforeach()
  string(REGEX REPLACE ".$" "=" base64 ${base64})  # the last byte is not the hash's
  set(hash_function "std::string_view ${SYMBOL}_sha256();
std::string_view ${SYMBOL}_sha256() { return \"${base64}\"; }
")
endif()
file(
  WRITE ${OUTPUT}
  "#include <string_view>
namespace lumaknot::embedded {
namespace {
constexpr char kText[] = {${bytes}};
}
std::string_view ${SYMBOL}();
std::string_view ${SYMBOL}() { return {kText, sizeof kText}; }
${hash_function}}  // namespace lumaknot::embedded
")
