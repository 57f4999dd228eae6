#include "gi/file/bake_merge.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gi/arithmetic.h"
#include "gi/file/bake_file.h"
#include "gi/file/bake_header.h"
#include "gi/file/compressed_array.h"
#include "volume/read/input/bytes.h"

namespace isolux::gi {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr std::size_t kNumbersAtATime = std::size_t{1} << 18;

struct PartFile {
  explicit PartFile(const fs::path& path)
      : bytes(path), header(readBakeHeader(bytes)), facts(bakeFactsOf(header, bytes.name())) {
    if (!facts.part) throwInput(name(), "Array part", "is missing: this is not a part of a bake");
  }
  const std::string& name() const { return bytes.name(); }
  const BakedPart& part() const { return *facts.part; }
  // All that stands before the arrays.
  std::string head() const { return bytes.head(static_cast<std::size_t>(header.appendedAt)); }

  volume::FileBytes bytes;
  BakeHeader header;
  BakeFacts facts;
};
using Parts = std::vector<std::unique_ptr<PartFile>>;

void eraseField(std::string& head, const std::string& name) {
  const std::string begin = "      <Array type=\"String\" Name=\"" + name + "\"", end = "</Array>\n";
  const std::size_t at = head.find(begin);
  if (at == std::string::npos) return;
  head.erase(at, head.find(end, at) + end.size() - at);
}

void eraseOffsets(std::string& head) {
  for (const std::size_t place : offsetsIn(head)) head.replace(place, kOffsetDigits, kOffsetDigits, '0');
}

// What must be the same in all parts: the header without what tells of the part.
std::string commonHead(const PartFile& file) {
  std::string head = file.head();
  eraseField(head, "part");
  eraseField(head, "arithmetic");
  eraseOffsets(head);
  return head;
}

void checkSameBake(const PartFile& file, const PartFile& first) {
  for (const char* const field : {"volume_hash", "key", "key_lamps", "content"}) {
    const std::string *const there = first.header.field(field), *const here = file.header.field(field);
    if (!here != !there || (here && *here != *there)) {
      const std::string difference = here && there ? keyDifference(*here, *there) : "";
      throwInput(
          file.name(), std::string("Array ") + field,
          (difference.empty() ? "is another one" : difference) + ": not of the same bake as " + first.name());
    }
  }
  const BakedPart &part = file.part(), &other = first.part();
  if (part.part.count != other.part.count)
    throwInput(file.name(), "Array part",
               "is " + partWords(part.part) + ", and " + first.name() + " is " + partWords(other.part));
  if (part.samples != other.samples)
    throwInput(file.name(), "Array part",
               "has " + std::to_string(part.samples) + " paths a texel, and " + first.name() + " has " +
                   std::to_string(other.samples));
  if (part.texels != other.texels)
    throwInput(file.name(), "Array part",
               "has the texels of \"" + part.texels + "\", and " + first.name() + " those of \"" +
                   other.texels + "\"");
  if (file.header.dims != first.header.dims || commonHead(file) != commonHead(first))
    throwInput(file.name(), "ImageData", "is not the lattice of " + first.name());
}

void checkComplete(const Parts& parts, const fs::path& out) {
  const int count = parts.front()->part().part.count;
  std::map<int, const PartFile*> byIndex;
  for (const auto& file : parts) {
    const auto [there, fresh] = byIndex.emplace(file->part().part.index, file.get());
    if (!fresh)
      throwInput(file->name(), "Array part",
                 "is " + partWords(file->part().part) + ", and so is " + there->second->name());
    if (!file->part().complete)
      throwInput(
          file->name(), "Array part",
          partWords(file->part().part) + " is not finished; isolux bake with the same options resumes it");
  }
  std::string missing;
  constexpr int named = 10;
  int absent = 0;
  for (int i = 1; i <= count; ++i)
    if (!byIndex.contains(i) && ++absent <= named)
      missing += (missing.empty() ? "" : ", ") + std::to_string(i);
  if (absent > named) missing += " and " + std::to_string(absent - named) + " more";
  if (absent > 0)
    throwInput(out.string(), "",
               std::string(absent > 1 ? "parts " : "part ") + missing + " of " + std::to_string(count) +
                   (absent > 1 ? " are" : " is") + " missing; no file was written");
}

// The one arithmetic of all.
std::string arithmeticOfAll(const Parts& parts, bool mix) {
  std::string all = parts.front()->facts.arithmetic;
  for (const auto& file : parts) {
    if (!mix && file->facts.arithmetic != all)
      throwInput(file->name(), "Array arithmetic",
                 "is \"" + file->facts.arithmetic + "\", that of " + parts.front()->name() + " \"" + all +
                     "\": the last bits of the light differ; --mix-arithmetic merges them");
    all = joinedArithmetic(all, file->facts.arithmetic);
  }
  return all;
}

// A file's own header with the arithmetic of all, and without the part.
std::string headOfAll(const PartFile& first, const std::string& arithmetic) {
  std::string head = first.head();
  eraseField(head, "part");
  if (arithmetic != first.facts.arithmetic) {
    eraseField(head, "arithmetic");
    head.insert(head.find("    </FieldData>"), bakeTextField("arithmetic", arithmetic));
  }
  eraseOffsets(head);
  return head;
}

struct NamedArray {
  std::string name;
  ArrayTag tag;
};

// In the order in which they stand in the file.
std::vector<NamedArray> arraysOf(const BakeHeader& header) {
  std::vector<NamedArray> arrays;
  for (const auto& [name, tag] : header.arrays) arrays.push_back({name, tag});
  std::sort(arrays.begin(), arrays.end(),
            [](const NamedArray& a, const NamedArray& b) { return a.tag.offset < b.tag.offset; });
  return arrays;
}

// Texels that a part lacks are zeros in every array, so that all of them together are their bits together.
void mergeArray(const NamedArray& array, const Parts& parts, std::uint64_t numbers, base::OutputFile& file,
                base::Progress& progress) {
  std::vector<std::unique_ptr<ArrayReader>> readers;
  for (const auto& part : parts)
    readers.push_back(std::make_unique<ArrayReader>(part->bytes, part->header, array.name,
                                                    array.tag.type.c_str(), array.tag.components));
  const bool counts = array.name.starts_with("samples");
  ArrayWriter writer(file, numbers * 4);
  std::vector<std::uint32_t> all, one;
  for (std::uint64_t done = 0; done < numbers; done += all.size()) {
    progress.throwIfStopped();
    all.assign(static_cast<std::size_t>(std::min<std::uint64_t>(kNumbersAtATime, numbers - done)), 0);
    one.resize(all.size());
    for (const auto& reader : readers) {
      reader->next(one);
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (counts && all[i] != 0 && one[i] != 0) reader->fail("has texels of another part");
        all[i] |= one[i];
      }
    }
    writer.add(all.data(), all.size() * 4);
  }
  writer.end();
}

void merge(std::span<const fs::path> files, const fs::path& out, bool mixArithmetic,
           base::Progress& progress) {
  Parts parts;
  for (const fs::path& path : files) {
    parts.push_back(std::make_unique<PartFile>(path));
    checkSameBake(*parts.back(), *parts.front());
  }
  checkComplete(parts, out);
  const std::string head = headOfAll(*parts.front(), arithmeticOfAll(parts, mixArithmetic));
  const std::vector<NamedArray> arrays = arraysOf(parts.front()->header);
  const std::vector<std::size_t> places = offsetsIn(head);
  if (places.size() != arrays.size())
    throwInput(parts.front()->name(), "PointData", "is not as this program writes it");

  base::OutputFile file(out);
  file.write(head);
  const std::uint64_t texels = volume::Extent3{parts.front()->header.dims}.count();
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    progress.report(static_cast<double>(a) / static_cast<double>(arrays.size()), "merging light");
    writeOffset(file, places[a], head.size());
    mergeArray(arrays[a], parts, texels * static_cast<std::uint64_t>(arrays[a].tag.components), file,
               progress);
  }
  file.write(kBakeFileEnd);
  file.commit();
  progress.report(1.0, "merging light");
}

}  // namespace

void mergeBakeFiles(std::span<const fs::path> files, const fs::path& out, bool mixArithmetic,
                    base::Progress& progress) {
  if (files.empty()) base::throwUsage(out.string(), "", "there are no parts to merge");
  namingFile(out, "merged", [&] { merge(files, out, mixArithmetic, progress); });
}

}  // namespace isolux::gi
