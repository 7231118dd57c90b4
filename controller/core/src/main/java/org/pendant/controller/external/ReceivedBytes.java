package org.pendant.controller.external;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.locks.LockSupport;

/**
 * Received bytes on their way from one thread that receives them to the frame loop, which takes
 * them. The receiving thread waits where the reader takes nothing; the frame loop never waits.
 */
public final class ReceivedBytes {
  /** Bytes that are kept until they are taken; the peer has to wait with more. */
  public static final int CAPACITY = 1 << 16;

  private static final int MASK = CAPACITY - 1;

  // made with the first bytes: most connections that fail never have any
  private byte[] ring = {};
  private volatile long written;
  private volatile long taken;
  private volatile boolean ended;
  private volatile boolean abandoned;
  private volatile Thread receiver;

  // --- for the frame loop

  /** Whether nothing will follow; ask this before {@link #length}. */
  public boolean ended() {
    return ended || abandoned;
  }

  /** How many bytes wait to be taken. */
  public int length() {
    return (int) (written - taken);
  }

  /** Byte {@code index} of those that wait, 0 to 255. */
  public int byteAt(int index) {
    return ring[(int) (taken + index) & MASK] & 0xFF;
  }

  /** The big-endian 32-bit integer at byte {@code index} of those that wait. */
  public int integerAt(int index) {
    return byteAt(index) << 24
        | byteAt(index + 1) << 16
        | byteAt(index + 2) << 8
        | byteAt(index + 3);
  }

  /** Bytes {@code begin} up to but without {@code end}, one {@code char} a byte. */
  public String text(int begin, int end) {
    byte[] bytes = new byte[end - begin];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) byteAt(begin + i);
    }
    return new String(bytes, StandardCharsets.ISO_8859_1);
  }

  /**
   * Where {@code text} begins.
   *
   * @param from where it may begin at the earliest
   * @param end after the last byte that it may have
   * @return its place, or -1
   */
  public int indexOf(String text, int from, int end) {
    for (int start = from; start + text.length() <= end; start++) {
      if (standsAt(start, text)) {
        return start;
      }
    }
    return -1;
  }

  private boolean standsAt(int start, String text) {
    for (int i = 0; i < text.length(); i++) {
      if (byteAt(start + i) != text.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /** Takes the first {@code count} bytes away. */
  public void skip(int count) {
    long before = taken;
    taken = before + count;
    LockSupport.unpark(receiver);
  }

  // --- for the receiving thread

  /**
   * Adds bytes; waits until there is room for all.
   *
   * @return false when the reader will not take any more
   * @throws InterruptedException when interrupted while waiting
   */
  public boolean append(byte[] bytes, int count) throws InterruptedException {
    receiver = Thread.currentThread();
    int done = 0;
    while (done < count && !abandoned) {
      int room = CAPACITY - length();
      if (room == 0) {
        LockSupport.park(this);
        if (Thread.interrupted()) {
          throw new InterruptedException();
        }
        continue;
      }
      int part = Math.min(room, count - done);
      put(bytes, done, part);
      done += part;
    }
    return !abandoned;
  }

  private void put(byte[] bytes, int offset, int count) {
    if (ring.length == 0) {
      ring = new byte[CAPACITY];
    }
    long end = written;
    for (int i = 0; i < count; i++) {
      ring[(int) (end + i) & MASK] = bytes[offset + i];
    }
    // last, so that a reader that sees the length sees the bytes
    written = end + count;
  }

  /** Nothing more will come. */
  public void end() {
    ended = true;
  }

  /** Nothing will be taken any more: a receiving thread that waits comes back. Any thread. */
  public void abandon() {
    abandoned = true;
    LockSupport.unpark(receiver);
  }
}
