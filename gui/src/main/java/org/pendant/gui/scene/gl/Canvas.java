package org.pendant.gui.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

/** What is drawn on: a picture of one size with several samples a pixel, and one to read from. */
final class Canvas implements AutoCloseable {
  private static final int SAMPLES = 4;

  private final int width;
  private final int height;
  private final int sampled;
  private final int sampledColour;
  private final int sampledDepth;
  private final int resolved;
  private final int resolvedColour;

  /**
   * @param width in pixels
   * @param height in pixels
   */
  Canvas(int width, int height) {
    this.width = width;
    this.height = height;
    int samples = Math.min(SAMPLES, glGetInteger(GL_MAX_SAMPLES));
    sampledColour = storage(samples, GL_RGBA8);
    sampledDepth = storage(samples, GL_DEPTH_COMPONENT24);
    sampled = glGenFramebuffers();
    glBindFramebuffer(GL_FRAMEBUFFER, sampled);
    attach(GL_COLOR_ATTACHMENT0, sampledColour);
    attach(GL_DEPTH_ATTACHMENT, sampledDepth);
    requireComplete();
    resolvedColour = storage(0, GL_RGBA8);
    resolved = glGenFramebuffers();
    glBindFramebuffer(GL_FRAMEBUFFER, resolved);
    attach(GL_COLOR_ATTACHMENT0, resolvedColour);
    requireComplete();
  }

  private int storage(int samples, int format) {
    int buffer = glGenRenderbuffers();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return buffer;
  }

  private static void attach(int attachment, int buffer) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  }

  private void requireComplete() {
    int status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
      throw new IllegalStateException(
          "a canvas of "
              + width
              + " by "
              + height
              + " pixels is refused, status 0x"
              + Integer.toHexString(status));
    }
  }

  boolean sized(int otherWidth, int otherHeight) {
    return width == otherWidth && height == otherHeight;
  }

  /** What is drawn next goes here. */
  void begin() {
    glBindFramebuffer(GL_FRAMEBUFFER, sampled);
    glViewport(0, 0, width, height);
  }

  /**
   * Takes the picture out, the row drawn lowest first.
   *
   * @param pixels width times height numbers 0xAARRGGBB, overwritten
   */
  void read(int[] pixels) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
    glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
  }

  @Override
  public void close() {
    glDeleteFramebuffers(sampled);
    glDeleteFramebuffers(resolved);
    glDeleteRenderbuffers(sampledColour);
    glDeleteRenderbuffers(sampledDepth);
    glDeleteRenderbuffers(resolvedColour);
  }
}
