package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

/**
 * Canvas: what is drawn on: a picture of one size, with one or several samples a pixel, or smaller
 * than what is read from it. In the last two cases there is another picture to read from.
 */
final class Canvas implements AutoCloseable {
  private final int width;
  private final int height;
  private final Quality quality;
  private final Surface drawn;
  private final Surface read;

  /** Whether what is drawn can be read as it is. */
  private final boolean readable;

  /** A picture in the memory of the graphics. */
  private record Surface(int framebuffer, int colour, int depth, int width, int height) {

    static Surface of(int width, int height, int samples, boolean deep) {
      int colour = storage(samples, GL_RGBA8, width, height);
      int depth = deep ? storage(samples, GL_DEPTH_COMPONENT24, width, height) : 0;
      int framebuffer = glGenFramebuffers();
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      attach(GL_COLOR_ATTACHMENT0, colour);
      if (deep) {
        attach(GL_DEPTH_ATTACHMENT, depth);
      }
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
      return new Surface(framebuffer, colour, depth, width, height);
    }

    private static int storage(int samples, int format, int width, int height) {
      int buffer = glGenRenderbuffers();
      glBindRenderbuffer(GL_RENDERBUFFER, buffer);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
      return buffer;
    }

    private static void attach(int attachment, int buffer) {
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    }

    void delete() {
      glDeleteFramebuffers(framebuffer);
      glDeleteRenderbuffers(colour);
      glDeleteRenderbuffers(depth);
    }
  }

  /**
   * @param width in pixels
   * @param height in pixels
   * @param quality says how many samples of each pixel are drawn
   */
  Canvas(int width, int height, Quality quality) {
    this.width = width;
    this.height = height;
    this.quality = quality;
    int samples =
        quality.samples() == 1 ? 0 : Math.min(quality.samples(), glGetInteger(GL_MAX_SAMPLES));
    drawn =
        Surface.of(
            Math.ceilDiv(width, quality.divisor()),
            Math.ceilDiv(height, quality.divisor()),
            samples,
            true);
    readable = samples == 0 && quality.divisor() == 1;
    read = readable ? drawn : Surface.of(width, height, 0, false);
  }

  boolean is(int otherWidth, int otherHeight, Quality otherQuality) {
    return width == otherWidth && height == otherHeight && quality == otherQuality;
  }

  /** Pixels of a row that are drawn. */
  int drawnWidth() {
    return drawn.width;
  }

  /** Rows that are drawn. */
  int drawnHeight() {
    return drawn.height;
  }

  /** What is drawn next goes here. */
  void begin() {
    glBindFramebuffer(GL_FRAMEBUFFER, drawn.framebuffer);
    glViewport(0, 0, drawn.width, drawn.height);
  }

  /**
   * Takes the picture out, the row drawn lowest first.
   *
   * @param pixels width times height numbers 0xAARRGGBB, overwritten
   */
  void read(int[] pixels) {
    if (!readable) {
      glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn.framebuffer);
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, read.framebuffer);
      int filter = quality.divisor() == 1 ? GL_NEAREST : GL_LINEAR;
      glBlitFramebuffer(
          0, 0, drawn.width, drawn.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, filter);
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, read.framebuffer);
    glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
  }

  @Override
  public void close() {
    drawn.delete();
    if (!readable) {
      read.delete();
    }
  }
}
