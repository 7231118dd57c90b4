package org.pendant.desktop.shell;

import java.util.function.LongSupplier;
import org.pendant.controller.Robot;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/**
 * Heap care: has the heap collected as a whole when enough may have died in it. The serial
 * collector enlarges the heap up to its limit, gigabytes, rather than look at what has grown old;
 * and stretches of a recording have grown old when they are dropped. To collect takes a tenth of a
 * second, in which robot time stands and is caught up.
 */
final class HeapCare {
  private static final long WHILE_STILL_BYTES = 48L << 20;
  private static final long WHILE_MOVING_BYTES = 96L << 20;

  /** What is alive is collected again when there is at least half as much besides. */
  private static final int SHARE = 2;

  private final LongSupplier usedBytes;
  private final Runnable collect;
  private long keptBytes;

  /** What goes on while the heap might be collected. */
  enum Doing {
    /** Nothing. */
    STILL,
    /** Nothing, while the user is typing, and would notice: a pause in it will come. */
    TYPED_AT,
    MOVING,
    /** Others follow frame by frame, for whom a tenth of a second is too long. */
    FOLLOWED;

    /**
     * What a robot does now.
     *
     * @param typing whether the user has just typed
     */
    static Doing of(Robot robot, boolean typing) {
      ControllerState state = robot.state();
      if (robot.feed().followed()) {
        return FOLLOWED;
      }
      boolean still = state.program().state() != ProgramState.RUNNING && state.arm().rests();
      if (!still) {
        return MOVING;
      }
      return typing ? TYPED_AT : STILL;
    }
  }

  /**
   * The heap of this process, which is collected in a thread of its own.
   *
   * @param besides bytes elsewhere that become free when the heap is collected
   */
  static HeapCare with(LongSupplier besides) {
    return new HeapCare(
        () -> used() + besides.getAsLong(),
        () -> Thread.ofPlatform().daemon().name("heap care").start(System::gc));
  }

  HeapCare(LongSupplier usedBytes, Runnable collect) {
    this.usedBytes = usedBytes;
    this.collect = collect;
    keptBytes = usedBytes.getAsLong();
  }

  private static long used() {
    Runtime runtime = Runtime.getRuntime();
    return runtime.totalMemory() - runtime.freeMemory();
  }

  /** Looks whether it is time; now and then, by one thread. */
  void look(Doing doing) {
    long used = usedBytes.getAsLong();
    // what was collected since the last look
    keptBytes = Math.min(keptBytes, used);
    long more =
        switch (doing) {
          case STILL -> WHILE_STILL_BYTES;
          case TYPED_AT, MOVING -> WHILE_MOVING_BYTES;
          case FOLLOWED -> Long.MAX_VALUE;
        };
    if (used - keptBytes > Math.max(more, keptBytes / SHARE)) {
      collect.run();
      // what is left is seen at the next look
      keptBytes = used;
    }
  }
}
