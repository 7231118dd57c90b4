package org.pendant.desktop.scene.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What can be said on a machine without OpenGL, too. */
final class SceneUnavailableTest {

  @Test
  void aMachineWithoutGraphicsIsToldSo() {
    SceneUnavailable none = new SceneUnavailable("no graphics");

    SceneUnavailable thrown =
        assertThrows(
            SceneUnavailable.class,
            () ->
                OffscreenScene.open(
                    () -> {
                      throw none;
                    }));

    assertSame(none, thrown);
  }

  @Test
  void otherSystemsThanLinuxAreNotSentToLookForPackages() {
    for (String system : List.of("Windows 11", "Mac OS X")) {
      SceneUnavailable thrown = assertThrows(SceneUnavailable.class, () -> EglContext.open(system));

      assertEquals(
          "the 3D view draws by EGL, which "
              + system
              + " does not have; so far there is a 3D view on Linux only",
          thrown.getMessage());
    }
  }

  @Test
  void anImageTooLargeIsRefused() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> OffscreenScene.image(5000, 20));

    assertEquals("image is 5000x20, each side must be 1 to 4096", refused.getMessage());
  }
}
