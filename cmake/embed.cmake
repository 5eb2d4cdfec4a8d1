# Writes OUTPUT, a C++ file whose function lumaknot::embedded::SYMBOL() returns the text of SOURCE.
# Bytes, not a raw string: compilers limit the length of string literals.
file(READ ${SOURCE} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
file(
  WRITE ${OUTPUT}
  "#include <string_view>
namespace lumaknot::embedded {
namespace {
constexpr char kText[] = {${bytes}};
}
std::string_view ${SYMBOL}();
std::string_view ${SYMBOL}() { return {kText, sizeof kText}; }
}  // namespace lumaknot::embedded
")
