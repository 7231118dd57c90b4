package org.pendant.protocols.packet;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.quantity.Getter;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;

/**
 * Packet layout of a fixed size: bytes that never change, and state quantities at their places. The
 * numbers of a snapshot are read first, each quantity once, and then put into the packet. Only one
 * thread at a time uses an object.
 */
public final class PacketLayout {
  private final byte[] packet;
  private final boolean little;
  private final double[] numbers;
  private final NumberSources sources;
  private final Run[] runs;

  private PacketLayout(byte[] constants, ByteOrder order, List<Slot> slots) {
    packet = constants.clone();
    little = order == ByteOrder.LITTLE_ENDIAN;
    sources = new NumberSources(slots);
    numbers = new double[sources.count()];
    runs = sources.runs(slots);
  }

  /** The packet of a snapshot. */
  public byte[] encode(ControllerState state) {
    sources.read(state, numbers);
    for (Run run : runs) {
      run.put(numbers, packet, little);
    }
    return packet.clone();
  }

  /**
   * A number at its place.
   *
   * @param getter reads it and those that belong to it
   * @param size how many these are
   * @param index which of them it is
   */
  record Slot(WireType type, int at, Getter getter, int size, int index) {}

  /** Fills a packet from its first byte on; what is left out is 0. */
  public static final class Builder {
    private final byte[] packet;
    private final ByteBuffer constants;
    private final List<Slot> slots = new ArrayList<>();

    /** An empty packet of so many bytes. */
    public Builder(int bytes, ByteOrder order) {
      packet = new byte[bytes];
      constants = ByteBuffer.wrap(packet).order(order);
    }

    /** The layout of what has been put. */
    public PacketLayout build() {
      return new PacketLayout(packet, constants.order(), slots);
    }

    /** Continues at byte {@code place}. */
    public Builder at(int place) {
      constants.position(place);
      return this;
    }

    /** Leaves bytes out. */
    public Builder skip(int bytes) {
      return at(constants.position() + bytes);
    }

    /** Bytes that are always the same. */
    public Builder bytes(byte... bytes) {
      constants.put(bytes);
      return this;
    }

    /** Four bytes that are always the same. */
    public Builder int32(int value) {
      constants.putInt(value);
      return this;
    }

    /** Eight bytes that are always the same. */
    public Builder float64(double value) {
      constants.putDouble(value);
      return this;
    }

    /** State quantities one after the other, with all their components. */
    public Builder put(WireType type, String... quantities) {
      for (String name : quantities) {
        StateQuantity quantity = StateQuantities.of(name);
        put(type, quantity, 0, quantity.size());
      }
      return this;
    }

    /** Some components of a state quantity. */
    public Builder put(WireType type, StateQuantity quantity, int from, int count) {
      for (int i = from; i < from + count; i++) {
        add(type, quantity.getter(), quantity.size(), i);
      }
      return this;
    }

    /** What no other interface has. */
    public Builder put(WireType type, ToDoubleFunction<ControllerState> value) {
      return add(type, new Getter.OfScalars(List.of(value)), 1, 0);
    }

    private Builder add(WireType type, Getter getter, int size, int index) {
      slots.add(new Slot(type, constants.position(), getter, size, index));
      return skip(type.bytes());
    }
  }
}
