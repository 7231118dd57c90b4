package org.pendant.desktop.scene.gl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.scene.mesh.Mesh;

final class ShadowReachTest {
  private static final float CLOSE = 1e-5f;
  private static final Vector3f ASLANT = new Vector3f(1, 0, 1).normalize();

  @Test
  void aBoxThrowsItsShadowAwayFromTheSun() {
    ShadowReach reach = new ShadowReach(ASLANT, 0, 10);

    reach.add(new Mesh.Box(0, -0.5f, 1, 1, 0.5f, 2), new Matrix4f());

    assertArrayEquals(new float[] {-2, -0.5f, 0, 0.5f}, reach.rectangle(0), CLOSE);
    assertArrayEquals(new float[] {-2.5f, -1, 0.5f, 1}, reach.rectangle(0.5f), CLOSE);
  }

  @Test
  void theFrameOfTheBodyAndTheHeightOfTheFloorCount() {
    ShadowReach reach = new ShadowReach(ASLANT, -1, 10);

    reach.add(new Mesh.Box(0, 0, 0, 0, 0, 0), new Matrix4f().translation(3, 1, 0));

    assertArrayEquals(new float[] {2, 1, 2, 1}, reach.rectangle(0), CLOSE);
  }

  @Test
  void nothingGoesBeyondTheLimit() {
    ShadowReach reach = new ShadowReach(ASLANT, 0, 2);

    reach.add(new Mesh.Box(-9, -9, 0, 9, 9, 9), new Matrix4f());

    assertArrayEquals(new float[] {-2, -2, 2, 2}, reach.rectangle(1), CLOSE);
  }

  @Test
  void withoutBodiesThereIsNoShadow() {
    ShadowReach reach = new ShadowReach(ASLANT, 0, 2);

    reach.add(new Mesh.Box(1, 1, 1, -1, -1, -1), new Matrix4f());

    assertArrayEquals(new float[4], reach.rectangle(0.1f));
  }
}
