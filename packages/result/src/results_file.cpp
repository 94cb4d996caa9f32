#include "toile/result/results_file.hpp"

#include <exodusII.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>

#include "netcdf_size.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "toile/result/exodus_writer.hpp"

namespace toile::result {
namespace {

const std::string title = "Toile";  // see put_model()
const std::string body_name = "body";

/// An open file, and what every call needs.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {
    base::require_file(path, "an Exodus file");
    check_whole();
    ex_opts(EX_DEFAULT);
    int memory_word = sizeof(double), file_word = 0;
    float version = 0.0F;
    id_ = ex_open(path.c_str(), EX_READ, &memory_word, &file_word, &version);
    if (id_ < 0) fail("it is not an Exodus file");
    ex_set_max_name_length(id_, longest_name);
    check(ex_get_init_ext(id_, &sizes_), "the sizes");
    if (sizes_.title != title) fail("it is an Exodus file, and none that Toile wrote");
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() {
    if (id_ >= 0) ex_close(id_);
  }

  Results read() {
    Results results;
    results.steps = static_cast<int>(ex_inquire_int(id_, EX_INQ_TIME));
    if (results.steps < 1) fail("it holds no step");
    steps_ = results.steps;
    read_units();
    read_blocks(results);
    results.nodal = nodal_fields();
    results.position = positions(results.nodal);
    results.global = global_fields();
    return results;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw base::InputError(path_ + ": " + reason); }
  void check(int status, const std::string& what) const {
    if (status < 0) fail("cannot read " + what + " of this Exodus file");
  }
  /// netCDF does not tell.
  void check_whole() const {
    const std::uint64_t wanted = netcdf_size(path_), found = std::filesystem::file_size(path_);
    if (found < wanted) fail("it was cut off: it has " + std::to_string(found) + " bytes of " + std::to_string(wanted));
  }

  std::vector<std::string> texts(std::size_t count, std::size_t length, const std::string& what,
                                 const std::function<int(char**)>& get) const {
    std::vector<std::string> buffers(count, std::string(length + 1, '\0'));
    std::vector<char*> places;
    for (std::string& buffer : buffers) places.push_back(buffer.data());
    check(get(places.data()), what);
    for (std::string& buffer : buffers) buffer.resize(buffer.find('\0'));
    return buffers;
  }

  std::vector<std::string> names(ex_entity_type type) const {
    int count = 0;
    check(ex_get_variable_param(id_, type, &count), "the number of fields");
    if (count == 0) return {};
    return texts(static_cast<std::size_t>(count), longest_name, "the names of fields",
                 [&](char** places) { return ex_get_variable_names(id_, type, count, places); });
  }

  /// Records "nodal pressure [kPa]".
  void read_units() {
    const auto count = static_cast<std::size_t>(ex_inquire_int(id_, EX_INQ_INFO));
    if (count == 0) return;
    for (const std::string& record :
         texts(count, MAX_LINE_LENGTH, "the units", [&](char** places) { return ex_get_info(id_, places); })) {
      const std::size_t open = record.find(" ["), close = record.rfind(']');
      if (open != std::string::npos && close != std::string::npos)
        units_[record.substr(0, open)] = record.substr(open + 2, close - open - 2);
    }
  }

  FieldName field_name(const std::string& kind, const std::string& name) const {
    const auto unit = units_.find(kind + " " + name);
    return {name, unit == units_.end() ? std::string() : unit->second};
  }

  std::vector<double> values(ex_entity_type type, int step, int field, ex_entity_id id, std::int64_t count) const {
    std::vector<double> all(static_cast<std::size_t>(count));
    check(ex_get_var(id_, step, type, field, id, count, all.data()), "a field");
    return all;
  }

  void read_blocks(Results& results) const {
    const auto count = static_cast<std::size_t>(sizes_.num_elem_blk);
    std::vector<int> ids(count);
    check(ex_get_ids(id_, EX_ELEM_BLOCK, ids.data()), "the panels");
    const std::vector<std::string> block_names =
        texts(count, longest_name, "the names of the panels",
              [&](char** places) { return ex_get_names(id_, EX_ELEM_BLOCK, places); });
    const std::vector<std::string> fields = names(EX_ELEM_BLOCK);
    results.garment_nodes = static_cast<int>(sizes_.num_nodes);
    for (std::size_t b = 0; b < count; ++b) {
      ResultsBlock block = read_block(ids[b], block_names[b], fields);
      const bool is_body = b + 1 == count && block.name == body_name;
      if (is_body && !block.connectivity.empty())
        results.garment_nodes = *std::min_element(block.connectivity.begin(), block.connectivity.end());
      (is_body ? results.body : results.garment).push_back(std::move(block));
    }
  }

  ResultsBlock read_block(int id, const std::string& name, const std::vector<std::string>& fields) const {
    ex_block info{};
    info.id = id;
    info.type = EX_ELEM_BLOCK;
    check(ex_get_block_param(id_, &info), "panel \"" + name + "\"");
    ResultsBlock block{name, static_cast<int>(info.num_nodes_per_entry), {}, {}};
    block.connectivity.resize(static_cast<std::size_t>(info.num_entry * info.num_nodes_per_entry));
    check(ex_get_conn(id_, EX_ELEM_BLOCK, id, block.connectivity.data(), nullptr, nullptr), "panel \"" + name + "\"");
    for (int& node : block.connectivity)
      if (--node < 0 || node >= sizes_.num_nodes)
        fail("panel \"" + name + "\" has an element with a node that is not there");
    if (fields.empty()) return block;
    std::vector<int> has(fields.size());
    check(ex_get_object_truth_vector(id_, EX_ELEM_BLOCK, id, static_cast<int>(has.size()), has.data()),
          "the table of fields and blocks");
    for (std::size_t f = 0; f < fields.size(); ++f)
      if (has[f] != 0)
        block.fields.push_back({field_name("element", fields[f]),
                                values(EX_ELEM_BLOCK, steps_, static_cast<int>(f) + 1, id, info.num_entry)});
    return block;
  }

  std::vector<FieldValues> nodal_fields() const {
    std::vector<FieldValues> all;
    for (const std::string& name : names(EX_NODAL))
      all.push_back(
          {field_name("nodal", name), values(EX_NODAL, steps_, static_cast<int>(all.size()) + 1, 1, sizes_.num_nodes)});
    return all;
  }

  std::vector<std::vector<double>> positions(const std::vector<FieldValues>& nodal) const {
    std::vector<std::vector<double>> x(3, std::vector<double>(static_cast<std::size_t>(sizes_.num_nodes)));
    check(ex_get_coord(id_, x[0].data(), x[1].data(), x[2].data()), "the coordinates");
    const std::array<const char*, 3> names = {"disp_x", "disp_y", "disp_z"};
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto field =
          std::find_if(nodal.begin(), nodal.end(), [&](const FieldValues& f) { return f.name.name == names[k]; });
      if (field == nodal.end()) fail(std::string("it has no field ") + names[k]);
      for (std::size_t n = 0; n < x[k].size(); ++n) x[k][n] += field->values[n];
    }
    return x;
  }

  std::vector<FieldValues> global_fields() const {
    std::vector<FieldValues> all;
    for (const std::string& name : names(EX_GLOBAL)) all.push_back({field_name("global", name), {}});
    for (int step = 1; step <= steps_ && !all.empty(); ++step) {
      const std::vector<double> row = values(EX_GLOBAL, step, 1, 1, static_cast<std::int64_t>(all.size()));
      for (std::size_t f = 0; f < all.size(); ++f) all[f].values.push_back(row[f]);
    }
    return all;
  }

  std::string path_;
  int id_ = -1;
  int steps_ = 0;
  ex_init_params sizes_{};
  std::map<std::string, std::string> units_;
};

}  // namespace

Results read_results(const std::string& path) {
  return Reader(path).read();
}

}  // namespace toile::result
