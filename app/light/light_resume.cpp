#include "app/light/light_resume.h"

#include "base/error.h"

namespace isolux::app {

void checkMayGoOn(const std::filesystem::path& file, const gi::BakeFacts& facts,
                  const std::optional<gi::LatticePart>& wanted, const std::string& arithmetic,
                  bool mixArithmetic) {
  if (wanted && (!facts.part || facts.part->part != *wanted))
    base::throwInput(
        file.string(), "Array part",
        (facts.part ? "is " + gi::partWords(facts.part->part) : "is missing: this is a whole bake") +
            ", not " + gi::partWords(*wanted));
  if (!mixArithmetic && !facts.arithmetic.empty() && facts.arithmetic != arithmetic)
    base::throwInput(
        file.string(), "Array arithmetic",
        "is \"" + facts.arithmetic + "\", and this machine's \"" + arithmetic +
            "\": the last bits of the light differ; --mix-arithmetic continues, and the file records it");
}

}  // namespace isolux::app
