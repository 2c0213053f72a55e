// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kept_frame.h"

namespace mes::render {

void KeptFrame::make() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  texture_ = GlTexture(texture);
  GLuint reader = 0;
  glGenFramebuffers(1, &reader);
  reader_ = GlFramebuffer(reader);
}

void KeptFrame::keep(int width, int height) {
  if (texture_.get() == 0) make();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glBindTexture(GL_TEXTURE_2D, texture_.get());
  if (width != width_ || height != height_) {
    width_ = width;
    height_ = height;
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, width, height, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reader_.get());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.get(), 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  } else {
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
}

void KeptFrame::show(int width, int height) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, reader_.get());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace mes::render
