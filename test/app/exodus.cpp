#include "exodus.hpp"

#include <exodusII.h>

#include <cmath>

namespace toile::test {

namespace {

class OpenFile {
 public:
  explicit OpenFile(const std::string& file) {
    int cpu_size = sizeof(double), disk_size = 0;
    float version = 0.0F;
    id = ex_open(file.c_str(), EX_READ, &cpu_size, &disk_size, &version);
    if (id >= 0) ex_set_max_name_length(id, 64);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (id >= 0) ex_close(id);
  }
  int id = -1;
};

/// Number of a variable, from 1; 0: there is none of this name.
int variable(int id, ex_entity_type type, const std::string& name) {
  int count = 0;
  ex_get_variable_param(id, type, &count);
  for (int v = 1; v <= count; ++v) {
    std::string found(65, '\0');
    ex_get_variable_name(id, type, v, found.data());
    if (name == found.c_str()) return v;
  }
  return 0;
}

}  // namespace

ExodusStep::ExodusStep(const std::string& file) : file_(file) {
  const OpenFile exodus(file);
  if (exodus.id < 0) return;
  steps = static_cast<int>(ex_inquire_int(exodus.id, EX_INQ_TIME));
  nodes = static_cast<int>(ex_inquire_int(exodus.id, EX_INQ_NODES));
  times.resize(static_cast<size_t>(steps));
  ex_get_all_times(exodus.id, times.data());
  position.assign(3, std::vector<double>(static_cast<size_t>(nodes)));
  ex_get_coord(exodus.id, position[0].data(), position[1].data(), position[2].data());
  for (size_t d = 0; d < 3; ++d) {
    const std::vector<double> displacement = nodal(std::string("disp_") + "xyz"[d]);
    for (size_t n = 0; n < displacement.size(); ++n) position[d][n] += displacement[n];
  }
}

std::vector<double> ExodusStep::nodal(const std::string& name) const {
  const OpenFile exodus(file_);
  const int v = variable(exodus.id, EX_NODAL, name);
  if (v == 0) return {};
  std::vector<double> values(static_cast<size_t>(nodes));
  ex_get_var(exodus.id, steps, EX_NODAL, v, 1, nodes, values.data());
  return values;
}

double ExodusStep::global(const std::string& name) const {
  const OpenFile exodus(file_);
  const int v = variable(exodus.id, EX_GLOBAL, name);
  if (v == 0) return std::nan("");
  int count = 0;
  ex_get_variable_param(exodus.id, EX_GLOBAL, &count);
  std::vector<double> values(static_cast<size_t>(count));
  ex_get_var(exodus.id, steps, EX_GLOBAL, 1, 0, count, values.data());
  return values[static_cast<size_t>(v - 1)];
}

std::vector<double> ExodusStep::element(const std::string& name) const {
  const OpenFile exodus(file_);
  const int v = variable(exodus.id, EX_ELEM_BLOCK, name);
  if (v == 0) return {};
  std::vector<int> blocks(static_cast<size_t>(ex_inquire_int(exodus.id, EX_INQ_ELEM_BLK)));
  ex_get_ids(exodus.id, EX_ELEM_BLOCK, blocks.data());
  std::vector<double> all;
  for (const int id : blocks) {
    ex_block block{};
    block.id = id;
    block.type = EX_ELEM_BLOCK;
    ex_get_block_param(exodus.id, &block);
    std::vector<double> values(static_cast<size_t>(block.num_entry));
    if (ex_get_var(exodus.id, steps, EX_ELEM_BLOCK, v, id, block.num_entry, values.data()) >= 0)
      all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

}  // namespace toile::test
