// SPDX-License-Identifier: GPL-3.0-or-later
// The page makes the link and copies it (web/page/page.js).
#include "app/system/session_link.h"

#include <emscripten/em_asm.h>
#include <emscripten/em_js.h>
#include <emscripten/proxying.h>
#include <emscripten/threading.h>

extern "C" {

EMSCRIPTEN_KEEPALIVE void mes_set_shared(em_proxying_ctx* call, mes::SharedLink* link, int kind, double length,
                                         double limit) {
  *link = {.kind = static_cast<mes::SharedLink::Kind>(kind),
           .length = static_cast<std::size_t>(length),
           .limit = static_cast<std::size_t>(limit)};
  emscripten_proxy_finish(call);
}
}

namespace mes {
namespace {

EM_JS(void, mes_share, (const char* session, void* call, void* answer),
      { share(UTF8ToString(session), call, answer); });

}  // namespace

bool may_share() {
  return EM_ASM_INT({ return "CompressionStream" in window; }) != 0;
}

SharedLink share_by_link(const std::string& session) {
  SharedLink out;
  emscripten::ProxyingQueue queue;
  queue.proxySyncWithCtx(
      emscripten_main_runtime_thread_id(),
      [&](const emscripten::ProxyingQueue::ProxyingCtx& call) { mes_share(session.c_str(), call.ctx, &out); });
  return out;
}

}  // namespace mes
