#pragma once

#include "exodus_file.hpp"
#include "toile/result/exodus_writer.hpp"

namespace toile::result {

using Texts = std::vector<std::string>;

Texts names_of(const std::vector<FieldName>& fields);
/// Names of the blocks: the panels, then "body".
Texts block_names(const mesh::Mesh& garment, const body::TriangleMesh* body);
/// Names in the order of the variables in the file.
Texts nodal_names(const FieldNames& fields);
Texts element_names(const FieldNames& fields);

/// Everything that does not change from step to step: sizes, units, coordinates, blocks, node sets, names of fields.
void put_model(const ExodusFile& file, const mesh::Mesh& garment, const body::TriangleMesh* body,
               const FieldNames& fields);

}  // namespace toile::result
