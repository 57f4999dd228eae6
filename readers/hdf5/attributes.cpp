#include "readers/hdf5/attributes.h"

#include <algorithm>

#include "readers/hdf5/hdf5_handles.h"

namespace isolux::readers {

using volume::Attributes;
using volume::AttributeValue;

namespace {

constexpr hssize_t kMostNumbers = 1024;

bool isNumber(hid_t type) {
  const H5T_class_t kind = ::H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT || kind == H5T_ENUM;
}

struct OpenAttribute {
  OpenAttribute(hid_t object, const char* name)
      : attribute(::H5Aexists(object, name) > 0 ? ::H5Aopen(object, name, H5P_DEFAULT) : H5I_INVALID_HID),
        space(attribute ? ::H5Aget_space(attribute.get()) : H5I_INVALID_HID),
        type(attribute ? ::H5Aget_type(attribute.get()) : H5I_INVALID_HID),
        count(space && type ? ::H5Sget_simple_extent_npoints(space.get()) : 0) {
    if (count > kMostNumbers) count = 0;
  }
  Hdf5Handle attribute, space, type;
  hssize_t count;
};

herr_t addName(hid_t, const char* name, const H5A_info_t*, void* names) {
  auto& list = *static_cast<std::vector<std::string>*>(names);
  constexpr std::size_t most = 1000;
  list.emplace_back(name);
  return list.size() < most ? 0 : 1;
}

}  // namespace

std::vector<double> numbersOfAttribute(hid_t object, const char* name) {
  const OpenAttribute open(object, name);
  if (open.count < 1 || !isNumber(open.type.get())) return {};
  std::vector<double> values(static_cast<std::size_t>(open.count));
  if (::H5Aread(open.attribute.get(), H5T_NATIVE_DOUBLE, values.data()) < 0) return {};
  return values;
}

std::vector<std::string> textsOfAttribute(hid_t object, const char* name) {
  const OpenAttribute open(object, name);
  if (open.count < 1 || ::H5Tget_class(open.type.get()) != H5T_STRING) return {};
  const auto count = static_cast<std::size_t>(open.count);
  std::vector<std::string> texts;
  if (::H5Tis_variable_str(open.type.get()) > 0) {
    std::vector<char*> values(count, nullptr);
    if (::H5Aread(open.attribute.get(), open.type.get(), values.data()) < 0) return {};
    for (char* const value : values) {
      texts.emplace_back(value != nullptr ? value : "");
      ::H5free_memory(value);
    }
    return texts;
  }
  const std::size_t length = ::H5Tget_size(open.type.get());
  if (length > std::size_t{1} << 20) return {};
  std::string all(length * count, '\0');
  if (::H5Aread(open.attribute.get(), open.type.get(), all.data()) < 0) return {};
  for (std::size_t i = 0; i < count; ++i) texts.emplace_back(all.substr(i * length, length).c_str());
  return texts;
}

Attributes attributesOf(hid_t object) {
  std::vector<std::string> names;
  ::H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, addName, &names);
  Attributes attributes;
  for (const std::string& name : names) {
    AttributeValue value;
    const OpenAttribute open(object, name.c_str());
    value.numbers = numbersOfAttribute(object, name.c_str());
    value.whole = !value.numbers.empty() && ::H5Tget_class(open.type.get()) == H5T_INTEGER;
    const std::vector<std::string> texts = textsOfAttribute(object, name.c_str());
    const bool letters = std::ranges::all_of(texts, [](const std::string& text) { return text.size() <= 1; });
    if (texts.size() == 1 || letters)
      for (const std::string& text : texts) value.text += text;
    if (!value.numbers.empty() || !value.text.empty()) attributes[name] = std::move(value);
  }
  return attributes;
}

std::vector<double> numbersOfDataset(hid_t location, const std::string& path, std::uint64_t most) {
  const Hdf5Handle dataset = openedObject(location, path);
  if (!dataset || ::H5Iget_type(dataset.get()) != H5I_DATASET) return {};
  const Hdf5Handle space(::H5Dget_space(dataset.get()));
  const Hdf5Handle type(::H5Dget_type(dataset.get()));
  const hssize_t count = space && type ? ::H5Sget_simple_extent_npoints(space.get()) : 0;
  if (count < 1 || static_cast<std::uint64_t>(count) > most || !isNumber(type.get())) return {};
  std::vector<double> numbers(static_cast<std::size_t>(count));
  if (::H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
    return {};
  return numbers;
}

}  // namespace isolux::readers
