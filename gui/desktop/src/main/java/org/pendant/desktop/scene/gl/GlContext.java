package org.pendant.desktop.scene.gl;

/**
 * OpenGL context, 3.3 core, that is current on the thread that opened it. That thread alone draws
 * with it and closes it.
 */
interface GlContext extends AutoCloseable {

  /** Makes a context for the calling thread. */
  @FunctionalInterface
  interface Opener {
    /**
     * Opens a context and makes it current.
     *
     * @throws SceneUnavailable if this machine has none
     */
    GlContext open() throws SceneUnavailable;
  }

  /** The graphics that draw, in the words of their driver. */
  String renderer();

  @Override
  void close();
}
