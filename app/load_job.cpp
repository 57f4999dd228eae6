#include "app/load_job.h"

#include <new>
#include <utility>

namespace isolux::app {

LoadJob::LoadJob(scene::Source source) : source_(std::move(source)) {
  thread_ = std::thread([this] {
    try {
      volume_ = volume::loadVolume(source_, progress_);
    } catch (const scene::Error& error) {
      error_ = error;
    } catch (const std::bad_alloc&) {
      error_.emplace(scene::ErrorKind::memory, source_.path, "", "not enough memory");
    } catch (const std::exception& error) {
      error_.emplace(scene::ErrorKind::input, source_.path, "", error.what());
    }
    finished_.store(true, std::memory_order_release);
  });
}

LoadJob::~LoadJob() {
  progress_.requestStop();
  thread_.join();
}

}  // namespace isolux::app
