package org.pendant.script.value;

import java.util.Optional;

/**
 * A string of bytes, one {@code char} (0 to 255) each (manual 3).
 *
 * <p>Programs build long strings piece by piece. So that this costs what is added and not what is
 * there already, a string and the one it was made from share a growing text, of which each sees its
 * own first part. Only the frame loop joins strings; a {@link #copy} may be read by any thread.
 */
public final class StringValue implements Value {
  /** Shorter results are copied: sharing would cost more than it saves. */
  private static final int MIN_SHARED = 64;

  private static final int HEADER_BYTES = 64;

  private final Optional<StringBuilder> shared;
  private final int length;
  private String bytes;

  public StringValue(String bytes) {
    shared = Optional.empty();
    length = bytes.length();
    this.bytes = bytes;
  }

  /** The first {@code length} bytes of {@code shared}. */
  private StringValue(Optional<StringBuilder> shared, int length) {
    this.shared = shared;
    this.length = length;
    bytes = "";
  }

  /** The text, one {@code char} a byte. */
  public String bytes() {
    if (bytes.length() != length) {
      bytes = shared.orElseThrow().substring(0, length);
    }
    return bytes;
  }

  /** How many bytes have to be copied before they can be looked at. */
  public int readCost() {
    return bytes.length() == length ? 0 : length;
  }

  /** How many bytes it has. */
  public int length() {
    return length;
  }

  /** The first {@code most} bytes, or all if there are fewer; costs no more than these. */
  public String start(int most) {
    int count = Math.min(most, length);
    return bytes.length() == length
        ? bytes.substring(0, count)
        : shared.orElseThrow().substring(0, count);
  }

  /** This string followed by {@code tail}. */
  StringValue followedBy(StringValue tail) {
    int joined = length + tail.length;
    // what stands after this part of the text belongs to another string
    if (shared.isPresent() && shared.get().length() == length) {
      append(shared.get(), tail.bytes());
      return new StringValue(shared, joined);
    }
    if (joined < MIN_SHARED) {
      return new StringValue(bytes().concat(tail.bytes()));
    }
    StringBuilder text = new StringBuilder(2 * joined).append(bytes()).append(tail.bytes());
    return new StringValue(Optional.of(text), joined);
  }

  private static void append(StringBuilder text, String tail) {
    if (tail.length() == 1) {
      text.append(tail.charAt(0));
    } else {
      text.append(tail);
    }
  }

  @Override
  public ValueKind kind() {
    return ValueKind.STRING;
  }

  @Override
  public long sizeBytes() {
    return HEADER_BYTES + (long) length;
  }

  /** How many bytes were copied to make this of {@code head} and another string after it. */
  @SuppressWarnings("ReferenceEquality") // whether it is the same text is the question
  public int copiedFor(StringValue head) {
    boolean continued =
        shared.isPresent() && head.shared.isPresent() && shared.get() == head.shared.get();
    return continued ? length - head.length : length;
  }

  @Override
  public StringValue copy() {
    bytes();
    return this;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof StringValue string
        && length == string.length
        && bytes().equals(string.bytes());
  }

  @Override
  public int hashCode() {
    return bytes().hashCode();
  }

  @Override
  public String toString() {
    return bytes();
  }
}
