# Writes OUTPUT, a C++ file that holds the text of INPUT. String literals are limited in length by some
# compilers, so the text is an array of bytes.
file(READ "${INPUT}" hex HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
string(REGEX REPLACE "(0x[0-9a-f][0-9a-f],0x[0-9a-f][0-9a-f],0x[0-9a-f][0-9a-f],0x[0-9a-f][0-9a-f],0x[0-9a-f][0-9a-f],0x[0-9a-f][0-9a-f],0x[0-9a-f][0-9a-f],0x[0-9a-f][0-9a-f],)"
       "\\1\n" bytes "${bytes}")
file(
  WRITE "${OUTPUT}"
  "#include \"parts/catalogue_data.h\"

namespace liftarm::parts {

namespace {

constexpr unsigned char kCatalogueBytes[] = {
${bytes}};

}  // namespace

std::string_view catalogueJsonText() {
  return {reinterpret_cast<const char*>(kCatalogueBytes), sizeof kCatalogueBytes};
}

}  // namespace liftarm::parts
")
