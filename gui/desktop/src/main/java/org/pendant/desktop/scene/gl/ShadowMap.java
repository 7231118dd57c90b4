package org.pendant.desktop.scene.gl;

import static org.lwjgl.opengl.GL33C.*;

import java.nio.ByteBuffer;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Ball;

/** Shadow map: how far the light sees: a picture of depths, taken from the sun. */
final class ShadowMap implements AutoCloseable {
  private static final int SIZE = 1024;

  private final int texture;
  private final int framebuffer;

  ShadowMap() {
    texture = glGenTextures();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(
        GL_TEXTURE_2D,
        0,
        GL_DEPTH_COMPONENT24,
        SIZE,
        SIZE,
        0,
        GL_DEPTH_COMPONENT,
        GL_UNSIGNED_INT,
        (ByteBuffer) null);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    framebuffer = glGenFramebuffers();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }

  /** From the base frame to the light's clip space, for all that is inside a ball. */
  static Matrix4f toClip(Ball ball, Vector3fc toSun) {
    float r = (float) ball.radiusM();
    Vector3 c = ball.centreM();
    Vector3f centre = new Vector3f((float) c.x(), (float) c.y(), (float) c.z());
    Vector3f eye = new Vector3f(toSun).mul(2 * r).add(centre);
    return new Matrix4f()
        .ortho(-r, r, -r, r, 0.5f * r, 3.5f * r)
        .lookAt(eye, centre, new Vector3f(0, 1, 0));
  }

  /** From the base frame to places and depths of the map, 0 to 1. */
  static Matrix4f toMap(Matrix4f toClip) {
    return new Matrix4f().translate(0.5f, 0.5f, 0.5f).scale(0.5f).mul(toClip);
  }

  /** What is drawn next casts the shadow. */
  void begin() {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, SIZE, SIZE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 4f);
  }

  void end() {
    glDisable(GL_POLYGON_OFFSET_FILL);
  }

  /** Makes the map readable in texture unit 0. */
  void bind() {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
  }

  @Override
  public void close() {
    glDeleteFramebuffers(framebuffer);
    glDeleteTextures(texture);
  }
}
