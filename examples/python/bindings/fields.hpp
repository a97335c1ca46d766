// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "casters.hpp"
#include "docs.hpp"

namespace python {

/// Assigns the arguments to the fields of `self`, those without a name in the fields' order. Throws
/// TypeError for one too many, or one that is no field.
void set_fields(const py::object& self, const py::args& args, const py::kwargs& kwargs);

/// The fields of `self` with their values.
py::dict fields_of(const py::object& self);

/// "Name(field=value, …)" with the fields of `self`.
std::string fields_text(const py::object& self);

/// Whether what a member holds stays where it is when the member is assigned, so that Python may
/// refer to it: not of an optional or a container.
template <typename Member>
inline constexpr bool stays = true;
template <typename T>
inline constexpr bool stays<std::optional<T>> = false;
template <typename T>
inline constexpr bool stays<std::vector<T>> = false;
template <typename Key, typename T>
inline constexpr bool stays<std::map<Key, T>> = false;

/// A plain struct of the library as a Python class: its members are attributes, and may all be
/// given when it is made; it prints, copies and pickles by them.
template <typename T, typename... Bases>
class Fields : public py::class_<T, Bases...> {
  using Class = py::class_<T, Bases...>;

 public:
  Fields(py::module_& module, const char* name, const char* documented = nullptr)
      : Class(module, name, doc(documented ? documented : name)),
        documented_(documented ? documented : name) {
    this->attr("__fields__") = py::tuple();
    this->def(py::init([](const py::args& args, const py::kwargs& kwargs) {
      T value{};
      set_fields(py::cast(&value, py::return_value_policy::reference), args, kwargs);
      return value;
    }));
    this->def("__repr__", &fields_text);
    this->def(py::pickle(&fields_of, [](const py::dict& state) {
      T value{};
      set_fields(py::cast(&value, py::return_value_policy::reference), py::args(),
                 py::kwargs(state));
      return value;
    }));
  }

  /// A member, with what its header says.
  template <typename Struct, typename Member>
  Fields& field(const char* name, Member Struct::*member) {
    this->def_readwrite(name, member, doc((documented_ + '.' + name).c_str()),
                        stays<Member> ? py::return_value_policy::reference_internal
                                      : py::return_value_policy::copy);
    note(name);
    return *this;
  }

  /// A member of another type in Python.
  template <typename Get, typename Set>
  Fields& field(const char* name, const Get& get, const Set& set) {
    this->def_property(name, get, set, doc((documented_ + '.' + name).c_str()));
    note(name);
    return *this;
  }

 private:
  void note(const char* name) {
    const py::object names = this->attr("__fields__");
    this->attr("__fields__") = names + py::make_tuple(name);
  }

  std::string documented_;
};

/// The attributes of what only the library makes, with what the header says of each.
template <typename Class>
class Attributes {
 public:
  Attributes(Class& type, std::string documented)
      : type_(type), documented_(std::move(documented)) {}

  /// A member, or what a member function without arguments gives.
  template <typename Member>
  Attributes& attribute(const char* name, Member member) {
    const char* const text = doc((documented_ + '.' + name).c_str());
    if constexpr (std::is_member_object_pointer_v<Member>) {
      type_.def_readonly(name, member, text);
    } else {
      type_.def_property_readonly(name, member, text);
    }
    return *this;
  }

 private:
  Class& type_;
  std::string documented_;
};

}  // namespace python
