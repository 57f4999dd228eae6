// Draws pictures on a thread of its own, which owns the GL context and the renderer, so that its owner - the
// window - waits for none of them; the owner polls, or is told.
//
// Data: an order is all that a picture is made from, by value. Of orders that are not begun the newest
// counts; one that is being drawn is dropped for a newer one, unless it is a draft: drafts are quick, and a
// view that keeps turning would never show one. Flow: draw() -> thread -> take(). Nobody waits for a lock:
// orders and pictures pass through mailboxes.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <semaphore>
#include <stop_token>
#include <thread>
#include <variant>
#include <vector>

#include "base/mailbox.h"
#include "base/progress.h"
#include "gi/picture_light.h"
#include "gi/visible_point_set.h"
#include "render/gl/gl_context.h"
#include "render/gl/handed_picture.h"
#include "render/graph/frame.h"
#include "render/still_picture.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct PictureOrder {
  std::shared_ptr<const volume::PreparedVolume> volume;  // null: the background only
  scene::Scene scene;                                    // resolved; its fields are made
  scene::HostSettings host;
  std::shared_ptr<const gi::PictureLight> light;
  render::FrameRequest request;
  bool draft = false;
};

struct DrawnPicture {
  std::uint64_t order = 0;  // PictureThread::draw()
  render::FrameRequest request;
  render::FrameReport report;
  render::ColorImage color;
  std::shared_ptr<const render::HandedPicture> texture;  // instead of `color`, if the thread hands textures
  gi::VisiblePointSet hitVoxels;
  double milliseconds = 0.0;                       // until it was finished
  std::chrono::steady_clock::time_point finished;  // when it could be taken
};

struct FailedPicture {
  std::uint64_t order = 0;
  std::exception_ptr reason;
};

class PictureThread {
 public:
  using Result = std::variant<DrawnPicture, FailedPicture>;

  // Whose pictures somebody waits for. Others are drawn by a thread that gives way to every other.
  enum class Priority { user, background };
  struct Options {
    // Creates the context, on the thread; empty: OffscreenContext::create(automatic).
    std::function<std::unique_ptr<render::OffscreenContext>()> context{};
    bool handsTextures = false;  // its context shares objects with that of the owner
    Priority priority = Priority::user;
    // Called on the thread whenever context() or take() may return something new, or a still is finished; may
    // outlive the owner.
    std::function<void()> news{};
  };
  // Begins to make the context.
  PictureThread() : PictureThread(Options()) {}
  explicit PictureThread(Options options);
  ~PictureThread();  // stops; the end of the thread is not waited for (base/destroy_in_background.h)
  PictureThread(const PictureThread&) = delete;
  PictureThread& operator=(const PictureThread&) = delete;

  // After the context was made, or not: what it is, or why there is none. Null before. Orders are for a
  // thread that has one.
  struct Context {
    std::optional<render::ContextDescription> description;
    std::exception_ptr failure;
  };
  const Context* context() const;

  // The number of the order, from 1 on.
  std::uint64_t draw(PictureOrder order);
  // A picture, or a failure, if there is one that was not taken. Those of orders that were dropped never
  // come.
  std::optional<Result> take();
  // What is ordered and not taken yet never comes, drafts neither; what is being drawn is dropped.
  void drop();
  // The same, and it lets go of the volume and the light that it drew last.
  void forget();
  bool busy() const { return !given_.empty(); }  // an order has neither come back nor been dropped

  // The whole picture, of any size (render::drawStill). It drops what is being drawn, and is not dropped
  // itself. One at a time: those that were ordered before may never be finished.
  struct Still {
    base::Progress progress;  // in tiles; after a stop request it ends with Error{interrupted}
    std::atomic<bool> finished{false};
    render::StillPicture picture;  // once it is finished
    std::exception_ptr failure;    // why there is none
  };
  std::shared_ptr<Still> drawStill(PictureOrder order);

 private:
  struct Work;
  struct Given {
    std::uint64_t number;
    bool draft;
    std::stop_source stop;
  };
  std::shared_ptr<Work> work_;
  std::vector<Given> given_;
  std::shared_ptr<Still> still_;  // that was ordered last
  std::uint64_t number_ = 0, dropped_ = 0;
  std::jthread thread_;
};

}  // namespace isolux::app
