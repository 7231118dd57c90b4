package org.pendant.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;

class RigidBodyRepeatTest {
  private static final int STEPS = 300;

  private final List<Long> alone = swept();

  @Test
  void tenRunsAreEqualToTheBit() {
    for (int run = 0; run < 10; run++) {
      assertEquals(alone, swept(), "run " + run);
    }
  }

  @Test
  void worldsSteppedInTurnsDoNotDisturbOneAnother() {
    RigidBodyWorld one = Bodies.heap();
    RigidBodyWorld tower = Bodies.tower(12);
    RigidBodyWorld other = Bodies.heap();
    for (int i = 0; i < STEPS; i++) {
      Bodies.sweep(one, i);
      tower.advance(Bodies.STEP_S);
      Bodies.sweep(other, i);
    }
    assertEquals(alone, Bodies.bits(one));
    assertEquals(alone, Bodies.bits(other));
  }

  @Test
  void worldsInThreadsDoNotDisturbOneAnother() throws Exception {
    try (ExecutorService threads = Executors.newFixedThreadPool(2)) {
      Callable<List<Long>> swept = RigidBodyRepeatTest::swept;
      for (Future<List<Long>> each : threads.invokeAll(List.of(swept, swept, swept, swept))) {
        assertEquals(alone, each.get());
      }
    }
  }

  private static List<Long> swept() {
    RigidBodyWorld heap = Bodies.heap();
    for (int i = 0; i < STEPS; i++) {
      Bodies.sweep(heap, i);
    }
    return Bodies.bits(heap);
  }
}
