#include "base64.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstdint>
#include <cstring>
#include <utility>

namespace toile::report {
namespace {

/// The lowest byte first, whatever the processor does.
void append(std::uint32_t bits, std::string& bytes) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xffU);
}

std::string encoded(std::string bytes) {
  using Letters = boost::archive::iterators::base64_from_binary<
      boost::archive::iterators::transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  bytes.append(missing, '\0');
  std::string text(Letters(bytes.cbegin()), Letters(bytes.cend()));
  text.replace(text.size() - missing, missing, missing, '=');
  return text;
}

}  // namespace

std::string base64(const std::vector<double>& values) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const double value : values) {
    const auto single = static_cast<float>(value);
    std::uint32_t bits = 0;
    static_assert(sizeof single == sizeof bits);
    std::memcpy(&bits, &single, sizeof bits);
    append(bits, bytes);
  }
  return encoded(std::move(bytes));
}

std::string base64(const std::vector<int>& values) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const int value : values) append(static_cast<std::uint32_t>(value), bytes);
  return encoded(std::move(bytes));
}

}  // namespace toile::report
