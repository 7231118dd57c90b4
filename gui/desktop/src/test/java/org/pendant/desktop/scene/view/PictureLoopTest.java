package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Models;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.gl.Quality;

final class PictureLoopTest {
  private static final SceneModel MODEL = Models.of("ur5e");
  private static final long FAST_NS = 10_000_000;
  private static final long SLOW_NS = 100_000_000;

  private final List<PictureRequest> asked = new ArrayList<>();
  private final List<CompletableFuture<BufferedImage>> pending = new ArrayList<>();
  private final List<BufferedImage> images = new ArrayList<>();
  private final List<BufferedImage> shown = new ArrayList<>();
  private long nowNs;
  private final PictureLoop loop =
      new PictureLoop(this::draw, Runnable::run, () -> nowNs, shown::add);

  private CompletableFuture<BufferedImage> draw(PictureRequest request, BufferedImage into) {
    asked.add(request);
    images.add(into);
    CompletableFuture<BufferedImage> picture = new CompletableFuture<>();
    pending.add(picture);
    return picture;
  }

  private void finish(long tookNs) {
    nowNs += tookNs;
    pending.removeFirst().complete(images.getLast());
  }

  private static PictureRequest from(double azimuthRad) {
    return new PictureRequest(
        MODEL, new Camera(new Vector3(0, 0, 0), azimuthRad, 0.3, 2), 400, 300);
  }

  @Test
  void drawsOnePictureAtATimeAndDropsWhatIsOutdated() {
    loop.want(from(1));
    loop.want(from(2));
    loop.want(from(3));
    assertEquals(List.of(from(1)), asked);

    finish(FAST_NS);

    assertEquals(List.of(from(1), from(3)), asked);
  }

  @Test
  void drawsNothingTwice() {
    loop.want(from(1));
    finish(FAST_NS);

    assertFalse(loop.want(from(1)));
    loop.settle();

    assertEquals(1, asked.size());
    assertTrue(pending.isEmpty());
  }

  @Test
  void neverDrawsIntoTheImageThatIsShown() {
    for (int i = 0; i < 5; i++) {
      loop.want(from(i));
      if (!shown.isEmpty()) {
        assertNotSame(shown.getLast(), images.getLast());
      }
      finish(FAST_NS);
    }
    assertSame(images.get(2), images.get(4));
  }

  @Test
  void drawsWorseWhileThingsMoveIfThatIsSlow() {
    loop.want(from(1));
    finish(SLOW_NS);
    loop.want(from(2));

    assertEquals(Quality.SWIFT, asked.getLast().quality());
  }

  @Test
  void theSlowestMachinesDrawHalfOfThePixels() {
    loop.want(from(1));
    finish(20 * SLOW_NS);
    loop.want(from(2));

    assertEquals(Quality.HALF, asked.getLast().quality());
    assertEquals(400, asked.getLast().widthPx());
  }

  @Test
  void morePicturesThanRefreshesAreForFastMachines() {
    assertFalse(loop.hasTime());
    loop.want(from(1));
    finish(FAST_NS);
    assertFalse(loop.hasTime());
    loop.want(from(2));
    finish(2_000_000);
    assertTrue(loop.hasTime());

    loop.want(from(3));
    assertFalse(loop.hasTime());
  }

  @Test
  void drawsInFullWhenThingsHaveSettled() {
    loop.want(from(1));
    finish(SLOW_NS);
    loop.want(from(2));
    finish(FAST_NS);
    assertEquals(2, asked.size());

    loop.settle();

    assertEquals(from(2), asked.getLast());
    finish(SLOW_NS);
    assertTrue(pending.isEmpty());
  }

  @Test
  void settlingWhileAPictureIsDrawnWaitsForIt() {
    loop.want(from(1));
    finish(SLOW_NS);
    loop.want(from(2));
    loop.settle();
    assertEquals(2, asked.size());

    finish(FAST_NS);

    assertEquals(from(2), asked.getLast());
    assertEquals(3, asked.size());
  }

  @Test
  void aFastMachineAlwaysDrawsInFull() {
    for (int i = 0; i < 5; i++) {
      loop.want(from(i));
      finish(FAST_NS);
    }

    assertTrue(asked.stream().allMatch(request -> request.quality() == Quality.FULL));
  }

  @Test
  void anotherSizeIsDrawnInFullAtOnce() {
    loop.want(from(1));
    finish(SLOW_NS);
    PictureRequest larger = new PictureRequest(MODEL, from(1).camera(), 800, 600);
    loop.want(larger);

    assertEquals(larger, asked.getLast());
  }

  @Test
  void aFailureIsNotSwallowed() {
    List<IllegalStateException> thrown = new ArrayList<>();
    PictureLoop failing =
        new PictureLoop(
            (request, into) -> CompletableFuture.failedFuture(new IllegalStateException("broken")),
            command -> thrown.add(assertThrows(IllegalStateException.class, command::run)),
            () -> 0,
            shown::add);

    failing.want(from(1));

    assertEquals("the scene could not be drawn", thrown.getFirst().getMessage());
    assertEquals("broken", thrown.getFirst().getCause().getMessage());
    assertTrue(shown.isEmpty());
  }
}
