package org.pendant.bench;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.Controller;

@Tag("slow")
final class WholeFrameTest {
  private static final int FRAMES = 2000;

  /**
   * What a frame may allocate that nobody looks at, with the C1 compiler, its share of plans too.
   */
  private static final long BYTES = 100;

  private static final int ROUNDS = 5;

  private final ThreadMXBean threads = ManagementFactory.getPlatformMXBean(ThreadMXBean.class);

  @ParameterizedTest
  @ValueSource(strings = {"movej", "movel", "sleep"})
  void frameThatNobodyLooksAtAllocatesLittle(String waitsFor) {
    BenchmarkScript script = BenchmarkScript.load("frame_" + waitsFor);
    script.start();
    Controller controller = script.controller();
    long least = Long.MAX_VALUE;
    for (int round = 0; round < ROUNDS && least > BYTES * FRAMES; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < FRAMES; i++) {
        controller.advance();
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    long bytes = least / FRAMES;
    assertTrue(bytes <= BYTES, () -> "a frame allocates " + bytes + " bytes");
  }
}
