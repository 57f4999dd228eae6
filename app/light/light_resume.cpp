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

std::string replacedNote(const std::filesystem::path& file, const std::string& why) {
  return file.string() + " held other light and was replaced: " + why;
}

std::string resumeBake(LightController& controller, const std::filesystem::path& file,
                       const std::optional<gi::LatticePart>& wanted, bool mixArithmetic,
                       base::Progress& progress) {
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) return {};
  gi::BakeFacts facts;
  try {
    facts = controller.load(file, progress);
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) throw;
    return replacedNote(file, error.reason());
  }
  checkMayGoOn(file, facts, wanted, controller.arithmetic(), mixArithmetic);
  return {};
}

void bakeToFile(LightController& controller, const std::filesystem::path& file,
                std::optional<gi::BakedPart> part, double checkpointSeconds, base::Progress& progress) {
  base::Progress writing;  // what there is, also when it ends here: writing is not stopped
  while (!controller.finish(progress, checkpointSeconds)) {
    controller.save(file, writing, part);
    progress.throwIfStopped();
  }
  if (part) part->complete = true;
  controller.save(file, writing, part);
}

}  // namespace isolux::app
