// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a Python interpreter for the program, which loads this library with the first Python experiment.
#include <Python.h>
#include <dlfcn.h>

#include <mutex>
#include <stdexcept>
#include <string>

#include <mesecina/experiment.h>

namespace {

using AddFile = void (*)(mesecina::Experiment& to, const char* file);

/// The text of the current exception.
std::string raised() {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  PyObject* const text = value == nullptr ? nullptr : PyObject_Str(value);
  const char* const utf8 = text == nullptr ? nullptr : PyUnicode_AsUTF8(text);
  std::string out = utf8 == nullptr ? "Python has failed" : utf8;
  PyErr_Clear();
  Py_XDECREF(text);
  Py_XDECREF(type);
  Py_XDECREF(value);
  Py_XDECREF(trace);
  return out;
}

/// The folder of the package that contains this library.
std::string folder_of_package() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&folder_of_package), &info) == 0) return {};
  const std::string self = info.dli_fname;
  const std::size_t package = self.rfind('/');
  const std::size_t folder = self.rfind('/', package - 1);
  return folder == std::string::npos ? std::string() : self.substr(0, folder);
}

/// Starts the interpreter and finds the function of the package. The calling thread releases the interpreter lock.
AddFile begin() {
  // Extension modules need the symbols of the interpreter, and this library was loaded with RTLD_LOCAL.
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&Py_InitializeEx), &info) != 0)
    dlopen(info.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
  if (!Py_IsInitialized()) {
    Py_InitializeEx(0);  // leaves signals to the program
    PyEval_SaveThread();
  }
  const PyGILState_STATE lock = PyGILState_Ensure();
  AddFile out = nullptr;
  std::string text;
  PyObject* const path = PySys_GetObject("path");
  PyObject* const folder = PyUnicode_DecodeFSDefault(folder_of_package().c_str());
  if (path != nullptr && folder != nullptr) PyList_Append(path, folder);
  Py_XDECREF(folder);
  if (PyObject* const module = PyImport_ImportModule("mesecina._mesecina")) {
    if (PyObject* const capsule = PyObject_GetAttrString(module, "add_file")) {
      out = reinterpret_cast<AddFile>(PyCapsule_GetPointer(capsule, "mesecina.add_file"));
      Py_DECREF(capsule);
    }
    Py_DECREF(module);
  }
  if (out == nullptr) text = raised();
  PyGILState_Release(lock);
  if (out == nullptr) throw std::runtime_error(text);
  return out;
}

}  // namespace

/// Adds the structures, layers and evolutions that a Python file defines. Throws an exception with the reason on
/// failure.
extern "C" MESECINA_API void mesecina_python_experiment_of_abi_1(mesecina::Experiment& to, const char* file) {
  static std::mutex mutex;
  static AddFile add = nullptr;
  {
    const std::lock_guard guard(mutex);
    if (add == nullptr) add = begin();
  }
  add(to, file);
}
