#include "exodus_model.hpp"

#include <algorithm>
#include <array>

namespace toile::result {
namespace {

Texts with(Texts first, const Texts& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

void add_units(Texts& records, const char* kind, const std::vector<FieldName>& fields) {
  for (const FieldName& field : fields) {
    const std::string record = std::string(kind) + " " + field.name + " [" + field.unit + "]";
    records.push_back(record.substr(0, MAX_LINE_LENGTH));
  }
}

void put_units(const ExodusFile& file, const FieldNames& fields) {
  Texts records;
  add_units(records, "nodal", geometry_fields());
  add_units(records, "nodal", fields.nodal);
  add_units(records, "element", fields.element);
  add_units(records, "element", fields.body_element);
  add_units(records, "global", fields.global);
  file.check(ex_put_info(file.id(), static_cast<int>(records.size()), pointers(records).data()), "the units");
}

void put_coordinates(const ExodusFile& file, const mesh::Mesh& garment, const body::TriangleMesh* body) {
  std::array<std::vector<double>, 3> x;
  for (int k = 0; k < 3; ++k) {
    for (const mesh::Vec3& node : garment.placed) {
      x[k].push_back(node[k]);
    }
    for (std::size_t i = 0; body != nullptr && i < body->vertices.size(); ++i) {
      x[k].push_back(body->vertices[i][k]);
    }
  }
  file.check(ex_put_coord(file.id(), x[0].data(), x[1].data(), x[2].data()), "the coordinates");
  file.check(ex_put_coord_names(file.id(), pointers({"x", "y", "z"}).data()), "the names of the coordinates");
}

void put_block(const ExodusFile& file, int id, int nodes_per_element, const std::vector<int>& connectivity) {
  const int elements = static_cast<int>(connectivity.size()) / nodes_per_element;
  const char* type = nodes_per_element == 4 ? "SHELL4" : "SHELL3";
  file.check(ex_put_block(file.id(), EX_ELEM_BLOCK, id, type, elements, nodes_per_element, 0, 0, 0), "a block");
  file.check(ex_put_conn(file.id(), EX_ELEM_BLOCK, id, connectivity.data(), nullptr, nullptr), "the elements");
}

void put_blocks(const ExodusFile& file, const mesh::Mesh& garment, const body::TriangleMesh* body) {
  int id = 0;
  for (const mesh::Block& block : garment.blocks) {
    std::vector<int> connectivity = block.connectivity;
    std::for_each(connectivity.begin(), connectivity.end(), [](int& node) { ++node; });
    put_block(file, ++id, block.nodes_per_element, connectivity);
  }
  if (body != nullptr) {
    std::vector<int> connectivity;
    for (const auto& triangle : body->triangles) {
      for (int vertex : triangle) {
        connectivity.push_back(garment.nodes() + vertex + 1);
      }
    }
    put_block(file, ++id, 3, connectivity);
  }
  file.check(ex_put_names(file.id(), EX_ELEM_BLOCK, pointers(block_names(garment, body)).data()),
             "the names of the panels");
}

void put_node_sets(const ExodusFile& file, const mesh::Mesh& garment) {
  int id = 0;
  Texts names;
  for (const auto& [name, edge] : garment.edges) {
    std::vector<int> nodes = edge;
    std::for_each(nodes.begin(), nodes.end(), [](int& node) { ++node; });
    ++id;
    file.check(ex_put_set_param(file.id(), EX_NODE_SET, id, static_cast<int>(nodes.size()), 0), "an edge");
    file.check(ex_put_set(file.id(), EX_NODE_SET, id, nodes.data(), nullptr), "an edge");
    names.push_back(name);
  }
  if (!names.empty()) {
    file.check(ex_put_names(file.id(), EX_NODE_SET, pointers(names).data()), "the names of the edges");
  }
}

void put_fields(const ExodusFile& file, const FieldNames& fields, int garment_blocks, bool has_body) {
  file.put_variable_names(EX_NODAL, nodal_names(fields));
  file.put_variable_names(EX_GLOBAL, names_of(fields.global));
  const Texts names = element_names(fields);
  if (names.empty()) {
    return;
  }
  file.put_variable_names(EX_ELEM_BLOCK, names);
  std::vector<int> table;
  for (int block = 0; block < garment_blocks + (has_body ? 1 : 0); ++block) {
    for (std::size_t field = 0; field < names.size(); ++field) {
      table.push_back((field >= fields.element.size()) == (block >= garment_blocks) ? 1 : 0);
    }
  }
  file.check(ex_put_truth_table(file.id(), EX_ELEM_BLOCK, static_cast<int>(table.size() / names.size()),
                                static_cast<int>(names.size()), table.data()),
             "the table of fields and blocks");
}

}  // namespace

Texts names_of(const std::vector<FieldName>& fields) {
  Texts names;
  for (const FieldName& field : fields) {
    names.push_back(field.name);
  }
  return names;
}

Texts nodal_names(const FieldNames& fields) {
  return with(names_of(geometry_fields()), names_of(fields.nodal));
}

Texts element_names(const FieldNames& fields) {
  return with(names_of(fields.element), names_of(fields.body_element));
}

Texts block_names(const mesh::Mesh& garment, const body::TriangleMesh* body) {
  Texts names;
  for (const mesh::Block& block : garment.blocks) {
    names.push_back(block.name);
  }
  if (body != nullptr) {
    names.emplace_back("body");
  }
  return names;
}

void put_model(const ExodusFile& file, const mesh::Mesh& garment, const body::TriangleMesh* body,
               const FieldNames& fields) {
  const int nodes = garment.nodes() + (body != nullptr ? static_cast<int>(body->vertices.size()) : 0);
  const int elements = garment.elements() + (body != nullptr ? static_cast<int>(body->triangles.size()) : 0);
  const int blocks = static_cast<int>(block_names(garment, body).size());
  file.check(ex_put_init(file.id(), "Toile", 3, nodes, elements, blocks, static_cast<int>(garment.edges.size()), 0),
             "the sizes");
  put_units(file, fields);
  put_coordinates(file, garment, body);
  put_blocks(file, garment, body);
  put_node_sets(file, garment);
  put_fields(file, fields, static_cast<int>(garment.blocks.size()), body != nullptr);
}

}  // namespace toile::result
