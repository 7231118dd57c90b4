package org.pendant.language.parse;

/** Splice: arrays with other elements in the place of some. */
final class Splice {
  private Splice() {}

  static byte[] of(byte[] old, int from, int to, byte[] others) {
    byte[] spliced = new byte[from + others.length + old.length - to];
    System.arraycopy(old, 0, spliced, 0, from);
    System.arraycopy(others, 0, spliced, from, others.length);
    System.arraycopy(old, to, spliced, from + others.length, old.length - to);
    return spliced;
  }

  static short[] of(short[] old, int from, int to, short[] others) {
    short[] spliced = new short[from + others.length + old.length - to];
    System.arraycopy(old, 0, spliced, 0, from);
    System.arraycopy(others, 0, spliced, from, others.length);
    System.arraycopy(old, to, spliced, from + others.length, old.length - to);
    return spliced;
  }

  /** Of offsets: those behind are {@code shift} further on. */
  static int[] moved(int[] old, int from, int to, int[] others, int shift) {
    int behind = from + others.length;
    int[] spliced = new int[behind + old.length - to];
    System.arraycopy(old, 0, spliced, 0, from);
    System.arraycopy(others, 0, spliced, from, others.length);
    for (int i = to; i < old.length; i++) {
      spliced[behind + i - to] = old[i] + shift;
    }
    return spliced;
  }
}
