// What the tests of body files share.
#pragma once

#include <string>

#include "toile/body/import.hpp"

namespace toile::test {

/// For the bodies of these tests, which are smaller than a person's limb.
body::ImportOptions small();
/// Message of the InputError that importing `file` throws; empty if it does not.
std::string message(const std::string& file, const body::ImportOptions& options = small());
/// Writes a file of this name in the folder for temporary files and returns its path.
std::string write_text(const std::string& name, const std::string& text);

/// Ball of radius 60 mm.
body::TriangleMesh ball();
/// A ball and its copy, moved by `shift`.
body::TriangleMesh twins(const body::Vec3& shift);
/// mm^3
double volume(const body::TriangleMesh& mesh);

}  // namespace toile::test
