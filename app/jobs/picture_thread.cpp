#include "app/jobs/picture_thread.h"

#include <chrono>
#include <system_error>
#include <utility>

#include "app/jobs/give_way.h"
#include "base/retire.h"
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
    std::shared_ptr<base::Progress> progress;
  };
  base::Mailbox<StillOrder> stillOrders;
  struct DrawnStill {
    Still still;
    std::shared_ptr<const base::Progress> of;  // which order
  };
  base::Mailbox<DrawnStill> stills;
  Context context;
  std::atomic<bool> contextKnown{false}, ending{false}, forgets{false};
  std::counting_semaphore<> news{0};

  void run(render::ContextChoice choice);
  void serve(const std::shared_ptr<const render::Gl>& gl);
  void draw(const Numbered& numbered, const std::shared_ptr<const render::Gl>& gl);
  void drawStill(const StillOrder& still, const std::shared_ptr<const render::Gl>& gl);
  void forget();
  render::Renderer& rendererFor(const PictureOrder& order, const std::shared_ptr<const render::Gl>& gl);

  std::unique_ptr<render::Renderer> renderer;  // of the thread, as the volume that it draws
  std::shared_ptr<const volume::PreparedVolume> volume;
};

namespace {

enum class Refusal { stopped, refused, unknown };

// After anything but an Error nobody knows what state the renderer is in.
Refusal refusalOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const base::Error& error) {
    return error.kind() == base::ErrorKind::interrupted ? Refusal::stopped : Refusal::refused;
  } catch (...) {
    return Refusal::unknown;
  }
}

}  // namespace

render::Renderer& PictureThread::Work::rendererFor(const PictureOrder& order,
                                                   const std::shared_ptr<const render::Gl>& gl) {
  if (!renderer) renderer = std::make_unique<render::Renderer>(gl);
  renderer->setMachine(order.machine);
  renderer->setVolume(order.volume);
  renderer->setLight(order.light);
  if (volume != order.volume) base::retire(std::exchange(volume, order.volume));
  return *renderer;
}

void PictureThread::Work::draw(const Numbered& numbered, const std::shared_ptr<const render::Gl>& gl) {
  const PictureOrder& order = numbered.order;
  const auto begin = std::chrono::steady_clock::now();
  try {
    render::Renderer& draws = rendererFor(order, gl);
    DrawnPicture drawn{numbered.number, order.request, draws.render(order.scene, order.request), {}, {}, 0.0};
    drawn.color = draws.readColor();
    if (order.hits != PictureOrder::Hits::none)
      drawn.hitVoxels = draws.hitVoxels(order.hits == PictureOrder::Hits::all);
    drawn.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    results.put(std::make_unique<Result>(std::move(drawn)));
  } catch (...) {
    const std::exception_ptr failure = std::current_exception();
    const Refusal how = refusalOf(failure);
    if (how == Refusal::stopped) return;
    if (how == Refusal::unknown) renderer.reset();
    results.put(std::make_unique<Result>(FailedPicture{numbered.number, failure}));
  }
}

void PictureThread::Work::drawStill(const StillOrder& still, const std::shared_ptr<const render::Gl>& gl) {
  const PictureOrder& order = still.order;
  try {
    stills.put(std::make_unique<DrawnStill>(
        DrawnStill{render::drawStill(rendererFor(order, gl), order.scene, order.request, *still.progress),
                   still.progress}));
  } catch (...) {
    const std::exception_ptr failure = std::current_exception();
    if (refusalOf(failure) == Refusal::unknown) renderer.reset();
    stills.put(std::make_unique<DrawnStill>(DrawnStill{failure, still.progress}));
  }
}

void PictureThread::Work::forget() {
  if (renderer) {
    renderer->setLight(nullptr);
    renderer->setVolume(nullptr);
  }
  base::retire(std::exchange(volume, nullptr));
}

void PictureThread::Work::serve(const std::shared_ptr<const render::Gl>& gl) {
  while (!ending.load(std::memory_order_acquire)) {
    if (forgets.exchange(false, std::memory_order_acq_rel))
      forget();
    else if (const auto still = stillOrders.take())
      drawStill(*still, gl);
    else if (const auto numbered = orders.take())
      draw(*numbered, gl);
    else
      news.acquire();
  }
  renderer.reset();
}

void PictureThread::Work::run(render::ContextChoice choice) {
  std::unique_ptr<render::OffscreenContext> made;
  try {
    made = render::OffscreenContext::create(choice);
    made->makeCurrent();
    context.description = made->description();
  } catch (...) {
    made.reset();
    context.failure = std::current_exception();
  }
  contextKnown.store(true, std::memory_order_release);
  if (made) serve(made->gl());
}

PictureThread::PictureThread(render::ContextChoice choice, Priority priority)
    : work_(std::make_shared<Work>()) {
  try {
    thread_ = std::jthread([work = work_, choice, priority] {
      if (priority == Priority::background) giveWay();
      work->run(choice);
    });
  } catch (const std::system_error&) {
    work_->context.failure = std::make_exception_ptr(
        base::Error(base::ErrorKind::memory, "", "", "the system gives no thread to draw with"));
    work_->contextKnown.store(true, std::memory_order_release);
  }
}

PictureThread::~PictureThread() {
  for (Given& given : given_) given.stop.request_stop();
  stopStill();
  work_->ending.store(true, std::memory_order_release);
  work_->news.release();
  base::retire(std::pair(std::move(work_), std::move(thread_)));
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
  base::retire(std::pair(work_->orders.take(), work_->results.take()));
  dropped_ = number_;
}

void PictureThread::forget() {
  drop();
  work_->forgets.store(true, std::memory_order_release);
  work_->news.release();
}

void PictureThread::drawStill(PictureOrder order) {
  stillProgress_ = std::make_shared<base::Progress>();
  order.request.stop = stillProgress_->token();
  work_->stillOrders.put(
      std::make_unique<Work::StillOrder>(Work::StillOrder{std::move(order), stillProgress_}));
  for (Given& given : given_) given.stop.request_stop();
  given_.clear();
  work_->news.release();
}

double PictureThread::stillFraction() const {
  return stillProgress_ ? stillProgress_->fraction() : 0.0;
}

void PictureThread::stopStill() {
  if (stillProgress_) stillProgress_->requestStop();
}

std::unique_ptr<PictureThread::Still> PictureThread::takeStill() {
  std::unique_ptr<Work::DrawnStill> drawn = work_->stills.take();
  if (!drawn) return nullptr;
  if (drawn->of == stillProgress_) return std::make_unique<Still>(std::move(drawn->still));
  base::retire(std::move(drawn));
  return nullptr;
}

}  // namespace isolux::app
