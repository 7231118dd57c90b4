package org.pendant.desktop.scene.gl;

/**
 * Missing OpenGL: there is none to draw with; the message says what is missing and how to get it.
 */
public final class SceneUnavailable extends Exception {
  private static final long serialVersionUID = 1L;

  SceneUnavailable(String message) {
    super(message);
  }

  SceneUnavailable(String message, Throwable cause) {
    super(message, cause);
  }
}
