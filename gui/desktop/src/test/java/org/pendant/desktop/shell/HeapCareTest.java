package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.desktop.shell.HeapCare.Doing;

final class HeapCareTest {
  private static final long MB = 1L << 20;

  private long usedBytes = 40 * MB;
  private long aliveBytes = 40 * MB;
  private int collected;
  private final HeapCare care =
      new HeapCare(
          () -> usedBytes,
          () -> {
            collected++;
            usedBytes = aliveBytes;
          });

  @Test
  void whatHasDiedIsCollectedSoonerWhileNothingMoves() {
    usedBytes += 50 * MB;
    care.look(Doing.MOVING);
    assertEquals(0, collected);
    care.look(Doing.STILL);
    assertEquals(1, collected);
    care.look(Doing.STILL);
    usedBytes += 97 * MB;
    care.look(Doing.MOVING);
    assertEquals(2, collected);
  }

  @Test
  void aPauseInTypingIsAwaited() {
    usedBytes += 50 * MB;
    care.look(Doing.TYPED_AT);
    assertEquals(0, collected);
    care.look(Doing.STILL);
    assertEquals(1, collected);
    care.look(Doing.STILL);
    usedBytes += 97 * MB;
    care.look(Doing.TYPED_AT);
    assertEquals(2, collected);
  }

  @Test
  void itIsNotCollectedAgainForWhatIsAlive() {
    aliveBytes = 240 * MB;
    usedBytes = 240 * MB;
    care.look(Doing.STILL);
    assertEquals(1, collected);
    care.look(Doing.STILL);
    usedBytes += 119 * MB;
    care.look(Doing.MOVING);
    assertEquals(1, collected);
    usedBytes += 2 * MB;
    care.look(Doing.MOVING);
    assertEquals(2, collected);
  }

  @Test
  void whoFollowsFrameByFrameIsNotDisturbed() {
    usedBytes += 5000 * MB;
    care.look(Doing.FOLLOWED);
    assertEquals(0, collected);
  }

  @Test
  void whatTheJvmHasCollectedItselfCounts() {
    usedBytes = 20 * MB;
    care.look(Doing.STILL);
    usedBytes = 69 * MB;
    care.look(Doing.STILL);
    assertEquals(1, collected);
  }
}
