#pragma once

#include <pybind11/pybind11.h>

#include <Teuchos_ParameterList.hpp>
#include <string>

namespace toile::python {

/// Puts what a dictionary holds into the list, as a scene file would: dictionaries as lists, Python's and NumPy's
/// bools, numbers, texts and sequences of them as parameters. `path`: of the list, for messages. Throws TypeError with
/// the path of what no scene can hold.
void fill(Teuchos::ParameterList& list, const pybind11::dict& content, const std::string& path);

/// A value as a scene file has it; entries of a sequence stand apart by semicolons. Throws TypeError with `where`.
std::string text_of(const std::string& where, const pybind11::handle& value);

}  // namespace toile::python
