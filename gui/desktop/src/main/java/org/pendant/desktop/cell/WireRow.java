package org.pendant.desktop.cell;

/** Wire row: a row of one of the two lists between which wires go. */
sealed interface WireRow {
  /** What stands in it. */
  String text();

  /** What stands behind it, of less weight. */
  String note();

  /**
   * What the rows below have in common.
   *
   * @param lit whether the device sees, holds or shows something
   */
  record Heading(String text, String note, boolean lit) implements WireRow {}

  /**
   * A signal of the controller.
   *
   * @param note what people call it; empty for nothing
   */
  record OfSignal(WireSignal signal, String note) implements WireRow {
    @Override
    public String text() {
      return signal.name();
    }
  }

  /** A port of a device. */
  record OfPort(WirePort port) implements WireRow {
    @Override
    public String text() {
      return port.title();
    }

    @Override
    public String note() {
      return port.signal();
    }
  }

  /** Why no wire can go between two rows; empty if one can. */
  static String refusal(WireRow from, WireRow to) {
    if (from instanceof OfPort(WirePort port) && to instanceof OfSignal signal) {
      return port.refusal(signal.signal());
    }
    if (from instanceof OfSignal && to instanceof OfPort) {
      return refusal(to, from);
    }
    return from instanceof OfPort
        ? CellTexts.text("aWireGoesFromADevice")
        : CellTexts.text("aWireGoesFromASignal");
  }
}
