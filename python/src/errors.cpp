// SPDX-License-Identifier: GPL-3.0-or-later
// Converts errors of the library to Python exceptions.
#include <new>
#include <string>
#include <string_view>

#include "module.h"

namespace mes_python {
namespace {

void raise(PyObject* type, const mesecina::Error& error) {
  PyErr_SetObject(type, text_of(error.what()).ptr());
}

void set_error(const mesecina::Error& error) {
  using mesecina::ErrorCode;
  switch (error.code()) {
    case ErrorCode::usage: return raise(PyExc_ValueError, error);
    case ErrorCode::cannot_write: return raise(PyExc_OSError, error);
    case ErrorCode::out_of_memory: return raise(PyExc_MemoryError, error);
    case ErrorCode::cancelled: return raise(PyExc_KeyboardInterrupt, error);
    case ErrorCode::internal: return raise(PyExc_RuntimeError, error);
    case ErrorCode::bad_input:
    case ErrorCode::cannot_compute: break;
  }
  const py::module_ errors = py::module_::import("mesecina._errors");
  const bool is_input = error.code() == ErrorCode::bad_input;
  const py::object type = errors.attr(is_input ? "InputError" : "ComputationFailed");
  const py::object what = text_of(error.what());
  const py::object out = is_input ? type(what, text_of(error.file()), error.line(), error.column())
                                  : type(what, text_of(error.structure()), array_of_ids(error.witnesses()));
  PyErr_SetObject(type.ptr(), out.ptr());
}

}  // namespace

py::str text_of(std::string_view text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape"));
}

void add_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const mesecina::Error& error) {
      set_error(error);
    }
  });
}

}  // namespace mes_python
