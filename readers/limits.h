// What a reader may use, set before it looks at the file: no core dumps, no files written, a limit of address
// space, and processor time in proportion to what there is to read. A reader never outlives the program.
#pragma once

#include <cstddef>
#include <cstdint>

namespace isolux::readers {

// Ends this process with the thread that started it; false if that has ended already.
bool endWithParent(int parent);

// `budgetBytes`: of the largest volume. What is decoded and what is handed over are there at once.
void limitReader(std::size_t budgetBytes);

// The processor time from now on, in place of what was left: for a look at the headers of so many files, so
// large in all: 1.5 to 2.5 s, 20 ms more for each file and 2 s (up to 2.5 s) for each MB, because a header
// may be long ...
void allowHeaders(std::size_t files, std::uint64_t fileBytes);
// ... and for decoding so many bytes of files: 1.5 to 2.5 s, and 20 s more for each MB. The slowest decoder
// (JPEG 2000 at a high ratio of compression) takes about 2 s.
void allowDecoding(std::uint64_t fileBytes);

}  // namespace isolux::readers
