// From Python to what a scene file would hold.
#include "scene_list.hpp"

#include <pybind11/stl.h>

#include <Teuchos_Array.hpp>
#include <limits>
#include <vector>

namespace py = pybind11;

namespace toile::python {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& problem) {
  throw py::type_error(where + ": " + problem);
}

/// NumPy's scalars and arrays as Python's own numbers and lists.
py::object plain(const py::handle& value) {
  if (py::hasattr(value, "tolist") && py::hasattr(value, "dtype")) return value.attr("tolist")();
  return py::reinterpret_borrow<py::object>(value);
}

int integer_of(const std::string& where, const py::handle& value) {
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow != 0 || number > std::numeric_limits<int>::max() || number < std::numeric_limits<int>::min())
    refuse(where, "the number " + std::string(py::str(value)) + " is too large for an int");
  return static_cast<int>(number);
}

template <class Kind>
bool all_are(const py::sequence& values) {
  for (const py::handle& value : values)
    if (!py::isinstance<Kind>(value) || py::isinstance<py::bool_>(value)) return false;
  return true;
}

void set_array(Teuchos::ParameterList& list, const std::string& name, const std::string& where,
               const py::sequence& values) {
  if (all_are<py::str>(values)) {
    list.set(name, Teuchos::Array<std::string>(values.cast<std::vector<std::string>>()));
  } else if (all_are<py::int_>(values)) {
    Teuchos::Array<int> numbers;
    for (const py::handle& value : values) numbers.push_back(integer_of(where, value));
    list.set(name, numbers);
  } else {
    Teuchos::Array<double> numbers;
    for (const py::handle& value : values) {
      if (py::isinstance<py::bool_>(value) || !(py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)))
        refuse(where, "a list holds numbers or texts, and this one holds a " + std::string(py::str(value.get_type())));
      numbers.push_back(value.cast<double>());
    }
    list.set(name, numbers);
  }
}

}  // namespace

void fill(Teuchos::ParameterList& list, const py::dict& content, const std::string& path) {
  for (const auto& [key, given] : content) {
    if (!py::isinstance<py::str>(key)) refuse(path, "the name " + std::string(py::repr(key)) + " is no text");
    const std::string name = key.cast<std::string>(), where = path + " > " + name;
    const py::object value = plain(given);
    if (py::isinstance<py::dict>(value))
      fill(list.sublist(name), value.cast<py::dict>(), where);
    else if (py::isinstance<py::bool_>(value))
      list.set(name, value.cast<bool>());
    else if (py::isinstance<py::int_>(value))
      list.set(name, integer_of(where, value));
    else if (py::isinstance<py::float_>(value))
      list.set(name, value.cast<double>());
    else if (py::isinstance<py::str>(value))
      list.set(name, value.cast<std::string>());
    else if (py::hasattr(value, "__fspath__"))
      list.set(name, value.attr("__fspath__")().cast<std::string>());
    else if (py::isinstance<py::sequence>(value))
      set_array(list, name, where, value.cast<py::sequence>());
    else
      refuse(where, "a parameter is a bool, an int, a float, a text, or a list of numbers or texts, not a " +
                        std::string(py::str(value.get_type())));
  }
}

std::string text_of(const std::string& where, const py::handle& given) {
  const py::object value = plain(given);
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::int_>(value) || py::isinstance<py::float_>(value)) return py::repr(value).cast<std::string>();
  if (!py::isinstance<py::sequence>(value)) refuse(where, "a setting is a bool, a number, a text, or a list of them");
  std::string text;
  for (const py::handle& entry : value) text += (text.empty() ? "" : "; ") + text_of(where, entry);
  return text;
}

}  // namespace toile::python
