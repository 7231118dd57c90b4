package org.pendant.protocols.toolserial;

import java.util.Arrays;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.pendant.controller.external.ToolCommunication;

/**
 * Device reader: reads what comes from a device, in a thread of its own, cut into messages by
 * silence.
 */
final class Hearing {
  /** A message that is longer continues in pieces. */
  private static final int LONGEST = 4096;

  private static final double NS_PER_S = 1e9;

  private final SerialDevice device;
  private final Consumer<byte[]> messages;
  private final Runnable gone;
  private volatile long silenceNs;
  private volatile long lastNs = System.nanoTime();
  private volatile boolean over;

  private Hearing(SerialDevice device, Consumer<byte[]> messages, Runnable gone) {
    this.device = device;
    this.messages = messages;
    this.gone = gone;
  }

  /**
   * Begins to read.
   *
   * @param messages gets each message; must not wait
   * @param gone is told when the device is, unless {@link #end} was called before
   */
  static Hearing of(SerialDevice device, Consumer<byte[]> messages, Runnable gone) {
    Hearing hearing = new Hearing(device, messages, gone);
    Thread.ofPlatform().daemon().name("tool serial receiving").start(hearing::run);
    return hearing;
  }

  /** Cuts messages as the line is set up. */
  void setUp(ToolCommunication line) {
    silenceNs = (long) (line.lengthS(line.rxIdleChars()) * NS_PER_S);
  }

  /** When something came last, by {@link System#nanoTime}. */
  long lastNs() {
    return lastNs;
  }

  /** Nothing more is handed on. */
  void end() {
    over = true;
  }

  /** Whether nothing more is handed on. */
  boolean over() {
    return over;
  }

  private void run() {
    byte[] bytes = new byte[LONGEST];
    while (!over) {
      int count = device.read(bytes, 0);
      if (count > 0) {
        int length = untilSilence(bytes, count);
        messages.accept(Arrays.copyOf(bytes, length));
      } else if (count < 0 && !over) {
        over = true;
        gone.run();
      }
    }
  }

  /** Reads on until nothing has come for a while, or there is no room; answers the length. */
  private int untilSilence(byte[] bytes, int first) {
    int length = first;
    lastNs = System.nanoTime();
    while (length < LONGEST && !over) {
      LockSupport.parkNanos(this, silenceNs);
      if (device.available() > 0) {
        // a device that goes just now has sent what there is
        length += Math.max(device.read(bytes, length), 0);
        lastNs = System.nanoTime();
      } else if (System.nanoTime() - lastNs >= silenceNs) {
        return length;
      }
    }
    return length;
  }
}
