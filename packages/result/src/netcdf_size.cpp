#include "netcdf_size.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <vector>

#include "toile/base/error.hpp"

namespace toile::result {
namespace {

constexpr int version_1 = 1, version_2 = 2, version_5 = 5;
constexpr std::uint64_t alignment = 4;

/// Reads numbers of the head, whose first byte is the highest.
class Head {
 public:
  explicit Head(const std::string& path) : path_(path), in_(path, std::ios::binary) {}

  std::uint64_t number(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = 256 * value + static_cast<std::uint64_t>(in_.get() & 0xff);
    require();
    return value;
  }
  /// A count, and the length of a name, a dimension or an array.
  std::uint64_t count() { return number(version_ == version_5 ? 8 : 4); }
  std::uint64_t offset() { return number(version_ == version_1 ? 4 : 8); }
  void skip(std::uint64_t bytes) {
    in_.ignore(static_cast<std::streamsize>((bytes + alignment - 1) / alignment * alignment));
    require();
  }
  void skip_name() { skip(count()); }
  /// Of a list that may be absent.
  std::uint64_t entries() {
    number(4);  // its tag
    return count();
  }
  void skip_attributes() {
    for (std::uint64_t left = entries(); left > 0; --left) {
      skip_name();
      const std::uint64_t type = number(4);
      skip(size_of(type) * count());
    }
  }
  /// False if it does not begin as a file of this format does.
  bool begins() {
    char kind[4] = {};
    in_.read(kind, sizeof kind);
    version_ = kind[3];
    return in_ && std::string(kind, 3) == "CDF" &&
           (version_ == version_1 || version_ == version_2 || version_ == version_5);
  }

 private:
  static std::uint64_t size_of(std::uint64_t type) {
    constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type < std::size(sizes) ? sizes[type] : 0;
  }
  void require() const {
    if (!in_) throw base::InputError(path_ + ": it was cut off: its head is not whole");
  }

  std::string path_;
  std::ifstream in_;
  int version_ = 0;
};

}  // namespace

std::uint64_t netcdf_size(const std::string& path) {
  Head head(path);
  if (!head.begins()) return 0;
  const std::uint64_t records = head.count();
  std::vector<bool> unlimited;
  for (std::uint64_t left = head.entries(); left > 0; --left) {
    head.skip_name();
    unlimited.push_back(head.count() == 0);
  }
  head.skip_attributes();
  std::uint64_t end = 0, record_size = 0, records_begin = std::numeric_limits<std::uint64_t>::max();
  for (std::uint64_t left = head.entries(); left > 0; --left) {
    head.skip_name();
    bool of_records = false;
    const std::uint64_t dimensions = head.count();
    for (std::uint64_t d = 0; d < dimensions; ++d) {
      const std::uint64_t id = head.count();
      if (d == 0) of_records = id < unlimited.size() && unlimited[id];
    }
    head.skip_attributes();
    head.number(4);  // type
    const std::uint64_t size = head.count(), begin = head.offset();
    if (of_records) {
      record_size += size;
      records_begin = std::min(records_begin, begin);
    } else {
      end = std::max(end, begin + size);
    }
  }
  if (record_size > 0 && records > 0) end = std::max(end, records_begin + records * record_size);
  return end;
}

}  // namespace toile::result
