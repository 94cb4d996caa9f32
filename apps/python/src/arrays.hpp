// From C++ to NumPy's arrays. `owner` lives as long as the array.
#pragma once

#include <pybind11/numpy.h>

#include <utility>
#include <vector>

#include "toile/solve/fields.hpp"

namespace toile::python {

namespace py = pybind11;

template <class T>
py::array view(const T* data, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<T> array(std::move(shape), data, owner);
  array.attr("flags").attr("writeable") = false;
  return std::move(array);
}

inline py::array vectors(const std::vector<solve::Vec3>& values, const py::object& owner) {
  static_assert(sizeof(solve::Vec3) == 3 * sizeof(double));
  const double* data = values.empty() ? nullptr : values.front().data();
  return view(data, {static_cast<py::ssize_t>(values.size()), 3}, owner);
}

inline py::array scalars(const std::vector<double>& values, const py::object& owner) {
  return view(values.data(), {static_cast<py::ssize_t>(values.size())}, owner);
}

template <class T>
py::array copied(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace toile::python
