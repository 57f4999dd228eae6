#include "app/tasks/picture_thread.h"

#include <system_error>
#include <utility>

#include "app/ready/give_way.h"
#include "base/destroy_in_background.h"
#include "render/renderer.h"

namespace isolux::app {

// What both threads know. Orders and results are exchanged; `context` is written once, before contextKnown.
struct PictureThread::Work {
  struct Numbered {
    std::uint64_t number;
    PictureOrder order;
  };
  base::Mailbox<Numbered> orders;
  base::Mailbox<Result> results;
  struct StillOrder {
    PictureOrder order;
    std::shared_ptr<Still> still;
  };
  base::Mailbox<StillOrder> stillOrders;
  explicit Work(Options asked) : options(std::move(asked)) {}

  const Options options;
  Context context;
  std::atomic<bool> contextKnown{false}, ending{false}, forgets{false};
  std::counting_semaphore<> news{0};

  void run();
  void tell() const {
    if (options.news) options.news();
  }
  void serve();
  void makeContext();
  void draw(const Numbered& numbered);
  void drawStill(const PictureOrder& order, Still& still);
  void forget();
  void failed(const std::exception_ptr& failure);
  render::Renderer& rendererFor(const PictureOrder& order);

  // Of the thread, as the volume that it draws. No context: the driver was reset, and the next order makes
  // another.
  std::unique_ptr<render::OffscreenContext> made;
  std::unique_ptr<render::Renderer> renderer;
  std::optional<render::PictureRing> ring;
  std::shared_ptr<const volume::PreparedVolume> volume;
};

namespace {

enum class Refusal { stopped, refused, lost, unknown };

// After anything but an Error nobody knows what state the renderer is in.
Refusal refusalOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const render::ContextLost&) {
    return Refusal::lost;
  } catch (const base::Error& error) {
    return error.kind() == base::ErrorKind::interrupted ? Refusal::stopped : Refusal::refused;
  } catch (...) {
    return Refusal::unknown;
  }
}

}  // namespace

void PictureThread::Work::makeContext() {
  made = options.context ? options.context()
                         : render::OffscreenContext::create(render::ContextChoice::automatic);
  made->makeCurrent();
  if (options.handsTextures) ring.emplace(made->gl());
}

render::Renderer& PictureThread::Work::rendererFor(const PictureOrder& order) {
  if (!made) makeContext();
  if (!renderer) renderer = std::make_unique<render::Renderer>(made->gl());
  renderer->setHostSettings(order.host);
  renderer->setVolume(order.volume);
  renderer->setLight(order.light);
  if (volume != order.volume) base::destroyInBackground(std::exchange(volume, order.volume));
  return *renderer;
}

void PictureThread::Work::failed(const std::exception_ptr& failure) {
  const Refusal how = refusalOf(failure);
  if (how == Refusal::lost || how == Refusal::unknown) renderer.reset();
  // Textures are still on show: their owner has to show something else first, and then makes another thread.
  if (how == Refusal::lost && !ring) made.reset();
}

void PictureThread::Work::draw(const Numbered& numbered) {
  const PictureOrder& order = numbered.order;
  const auto begin = std::chrono::steady_clock::now();
  try {
    render::Renderer& draws = rendererFor(order);
    DrawnPicture drawn{
        numbered.number, order.request, draws.render(order.scene, order.request), {}, {}, {}, 0.0, {}};
    if (ring)
      drawn.texture = ring->hand(draws.color());
    else
      drawn.color = draws.readColor();
    if (order.request.hits != render::FrameRequest::Hits::none) drawn.hitVoxels = draws.hitVoxels();
    made->gl()->throwIfLost();
    drawn.finished = std::chrono::steady_clock::now();
    drawn.milliseconds = std::chrono::duration<double, std::milli>(drawn.finished - begin).count();
    results.put(std::make_unique<Result>(std::move(drawn)));
  } catch (...) {
    const std::exception_ptr failure = std::current_exception();
    if (refusalOf(failure) == Refusal::stopped) return;
    failed(failure);
    results.put(std::make_unique<Result>(FailedPicture{numbered.number, failure}));
  }
  tell();
}

void PictureThread::Work::drawStill(const PictureOrder& order, Still& still) {
  try {
    still.picture = render::drawStill(rendererFor(order), order.scene, order.request, still.progress);
    made->gl()->throwIfLost();
  } catch (...) {
    still.failure = std::current_exception();
    failed(still.failure);
  }
  still.finished.store(true, std::memory_order_release);
  tell();
}

void PictureThread::Work::forget() {
  if (renderer) {
    renderer->setLight(nullptr);
    renderer->setVolume(nullptr);
  }
  base::destroyInBackground(std::exchange(volume, nullptr));
}

void PictureThread::Work::serve() {
  while (!ending.load(std::memory_order_acquire)) {
    if (forgets.exchange(false, std::memory_order_acq_rel))
      forget();
    else if (const auto still = stillOrders.take())
      drawStill(still->order, *still->still);
    else if (const auto numbered = orders.take())
      draw(*numbered);
    else
      news.acquire();
  }
}

void PictureThread::Work::run() {
  try {
    makeContext();
    context.description = made->description();
  } catch (...) {
    made.reset();
    context.failure = std::current_exception();
  }
  contextKnown.store(true, std::memory_order_release);
  tell();
  if (made) serve();
  renderer.reset();  // while the context is current
  ring.reset();
  made.reset();
}

PictureThread::PictureThread(Options options) : work_(std::make_shared<Work>(std::move(options))) {
  try {
    thread_ = std::jthread([work = work_] {
      if (work->options.priority == Priority::background) giveWay();
      work->run();
    });
  } catch (const std::system_error&) {
    work_->context.failure = std::make_exception_ptr(
        base::Error(base::ErrorKind::memory, "", "", "the system gives no thread to draw with"));
    work_->contextKnown.store(true, std::memory_order_release);
  }
}

PictureThread::~PictureThread() {
  for (Given& given : given_) given.stop.request_stop();
  if (still_) still_->progress.requestStop();
  work_->ending.store(true, std::memory_order_release);
  work_->news.release();
  base::destroyInBackground(std::pair(std::move(work_), std::move(thread_)));
}

const PictureThread::Context* PictureThread::context() const {
  return work_->contextKnown.load(std::memory_order_acquire) ? &work_->context : nullptr;
}

std::uint64_t PictureThread::draw(PictureOrder order) {
  std::stop_source stop;
  order.request.stop = stop.get_token();
  const bool draft = order.draft;
  work_->orders.put(std::make_unique<Work::Numbered>(Work::Numbered{++number_, std::move(order)}));
  std::erase_if(given_, [](Given& given) { return !given.draft && given.stop.request_stop(); });
  given_.push_back({number_, draft, std::move(stop)});
  work_->news.release();
  return number_;
}

std::optional<PictureThread::Result> PictureThread::take() {
  const std::unique_ptr<Result> result = work_->results.take();
  if (!result) return std::nullopt;
  const std::uint64_t number = std::visit([](const auto& value) { return value.order; }, *result);
  if (number <= dropped_) return std::nullopt;
  std::erase_if(given_, [number](const Given& given) { return given.number <= number; });
  return std::move(*result);
}

void PictureThread::drop() {
  for (Given& given : given_) given.stop.request_stop();
  given_.clear();
  base::destroyInBackground(std::pair(work_->orders.take(), work_->results.take()));
  dropped_ = number_;
}

void PictureThread::forget() {
  drop();
  work_->forgets.store(true, std::memory_order_release);
  work_->news.release();
}

std::shared_ptr<PictureThread::Still> PictureThread::drawStill(PictureOrder order) {
  still_ = std::make_shared<Still>();
  order.request.stop = still_->progress.token();
  order.request.hits = render::FrameRequest::Hits::none;
  work_->stillOrders.put(std::make_unique<Work::StillOrder>(Work::StillOrder{std::move(order), still_}));
  for (Given& given : given_) given.stop.request_stop();
  given_.clear();
  work_->news.release();
  return still_;
}

}  // namespace isolux::app
