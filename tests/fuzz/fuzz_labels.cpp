// Files that name labels, and extensions of NIfTI headers: the first byte chooses which.
#include <array>

#include "tests/fuzz/fuzz_support.h"
#include "volume/read/label_names.h"
#include "volume/read/plain/nifti_labels.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  if (size == 0) return 0;
  const std::string_view text = fuzz::textOf(data + 1, size - 1);
  constexpr std::array files = {"a.tsv", "dataset.json", "a.label"};
  const std::size_t choice = data[0] % (files.size() + 1);
  if (choice == files.size()) {
    volume::labelsInExtensions(text, (data[0] & 0x80) != 0);
    return 0;
  }
  try {
    for (const volume::Label& label : volume::labelNamesIn(text, files[choice]))
      if (label.color && !(label.color->x >= 0.0f && label.color->x <= 1.0f)) std::abort();
  } catch (const base::Error&) {
  }
  return 0;
}
