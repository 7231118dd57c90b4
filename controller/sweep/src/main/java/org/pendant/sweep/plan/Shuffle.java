package org.pendant.sweep.plan;

/**
 * Shuffle: the numbers from 0 to a size in another order, which is worked out for one number at a
 * time and takes no memory: a Feistel network over the smallest square of a power of two that holds
 * them, which is repeated as long as it leads beyond the size (Black and Rogaway, Ciphers with
 * arbitrary finite domains, 2002, method 3).
 */
final class Shuffle {
  private static final int ROUNDS = 6;

  private final long size;
  private final long seed;
  private final int halfBits;
  private final long mask;

  Shuffle(long size, long seed) {
    this.size = size;
    this.seed = seed;
    int bits = Long.SIZE - Long.numberOfLeadingZeros(Math.max(1, size - 1));
    halfBits = Math.max(1, (bits + 1) / 2);
    mask = (1L << halfBits) - 1;
  }

  /** Where a number goes; another place for each. */
  long place(long number) {
    long at = number;
    do {
      at = round(at);
    } while (at >= size);
    return at;
  }

  private long round(long number) {
    long left = number >>> halfBits;
    long right = number & mask;
    for (int i = 0; i < ROUNDS; i++) {
      long next = left ^ (UnitNumbers.mixed(seed, i, right) & mask);
      left = right;
      right = next;
    }
    return (left << halfBits) | right;
  }
}
