package org.pendant.controller.external;

import static org.pendant.controller.external.ExternalTexts.text;

import java.util.List;

/**
 * Tool communication: how the serial line of the tool connector is set up (manual 18.50). It shares
 * its wires with the tool's analog inputs.
 *
 * @param enabled whether the wires are a serial line; analog inputs otherwise
 * @param baudRate one of {@link #BAUD_RATES}
 * @param parity of each character
 * @param stopBits 1 or 2
 * @param rxIdleChars characters of silence after which a message from the tool is complete, 1 to 40
 * @param txIdleChars characters of silence before something is sent to the tool, 0 to 40
 */
public record ToolCommunication(
    boolean enabled,
    int baudRate,
    Parity parity,
    int stopBits,
    float rxIdleChars,
    float txIdleChars) {
  /** The speeds that there are, bit/s. */
  public static final List<Integer> BAUD_RATES =
      List.of(9600, 19200, 38400, 57600, 115200, 1000000, 2000000, 5000000);

  /** Fewest and most characters of silence after a message from the tool. */
  public static final float MIN_RX_IDLE_CHARS = 1;

  /** Most characters of silence, either way. */
  public static final float MAX_IDLE_CHARS = 40;

  /** How a new box sets it up: off. */
  public static final ToolCommunication STANDARD =
      new ToolCommunication(false, 115200, Parity.NONE, 1, 1.5f, 3.5f);

  private static final int DATA_BITS = 8;

  /** Whether characters have a parity bit, and what it makes of the number of ones. */
  public enum Parity {
    NONE(0),
    ODD(1),
    EVEN(2);

    private final int number;

    Parity(int number) {
      this.number = number;
    }

    /** The parity that scripts and protocols call by {@code number}, 0 to 2. */
    public static Parity of(int number) {
      return values()[number];
    }

    /** What scripts and protocols call it. */
    public int number() {
      return number;
    }
  }

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is not allowed
   */
  public ToolCommunication {
    check(BAUD_RATES.contains(baudRate), "baudRate", baudRate, rates());
    check(stopBits == 1 || stopBits == 2, "stopBits", stopBits);
    check(
        rxIdleChars >= MIN_RX_IDLE_CHARS && rxIdleChars <= MAX_IDLE_CHARS,
        "rxIdleChars",
        rxIdleChars);
    check(txIdleChars >= 0 && txIdleChars <= MAX_IDLE_CHARS, "txIdleChars", txIdleChars);
  }

  private static void check(boolean right, String refusal, Object... values) {
    if (!right) {
      throw new IllegalArgumentException(text(refusal, values));
    }
  }

  /** {@link #BAUD_RATES} for messages. */
  public static String rates() {
    return String.join(", ", BAUD_RATES.stream().map(String::valueOf).toList());
  }

  /** How long {@code characters} take on the line, with start, parity and stop bits, s. */
  public double lengthS(double characters) {
    int bits = 1 + DATA_BITS + (parity == Parity.NONE ? 0 : 1) + stopBits;
    return characters * bits / baudRate;
  }
}
