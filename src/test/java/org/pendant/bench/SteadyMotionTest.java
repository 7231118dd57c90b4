package org.pendant.bench;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.motion.PlanningException;

@Tag("slow")
final class SteadyMotionTest {
  private static final int FRAMES = 2000;

  /** Bytes that measuring may take; an object in a frame of its own is 32000. */
  private static final long SPARE = 256;

  /** Rounds, of which one has to be free of what the JVM itself allocates, such as classes. */
  private static final int ROUNDS = 5;

  private final ThreadMXBean threads = ManagementFactory.getPlatformMXBean(ThreadMXBean.class);

  @ParameterizedTest
  @EnumSource
  void frameOfEveryMotionAllocatesNothing(SteadyMotion.Kind kind) throws PlanningException {
    SteadyMotion motion = new SteadyMotion(kind);
    long least = Long.MAX_VALUE;
    for (int round = 0; round < ROUNDS && least > SPARE; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      run(motion);
      long spent = threads.getCurrentThreadAllocatedBytes() - before;
      least = Math.min(least, spent);
    }
    assertTrue(motion.continues(), "it has come to an end");
    long bytes = least;
    assertTrue(
        bytes <= SPARE, () -> kind + " allocates " + bytes + " bytes in " + FRAMES + " frames");
  }

  private static void run(SteadyMotion motion) throws PlanningException {
    for (int i = 0; i < FRAMES; i++) {
      motion.frame();
    }
  }
}
