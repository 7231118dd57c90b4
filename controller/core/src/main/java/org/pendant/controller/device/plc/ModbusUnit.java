package org.pendant.controller.device.plc;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.pendant.controller.external.DeviceTalk;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.wire.SignalLine;

/** Modbus unit: a device with its memory, which may be off the network. The frame loop owns it. */
public final class ModbusUnit {
  /** Whether it is on the network. */
  public static final SignalGroup ONLINE = new SignalGroup("online", 0, 1, true, SignalGroup.LEVEL);

  private final OptionalInt number;
  private final ModbusMemory memory;
  private final ModbusAnswers answers;
  private final List<UnitPoint> points = new ArrayList<>();
  private boolean online = true;
  private List<SignalGroupState> memoryState = List.of();
  private List<SignalGroupState> state = List.of();
  private boolean onlineTold;

  /**
   * A unit on the network.
   *
   * @param number by which it is called; empty for one that answers to all numbers
   */
  public ModbusUnit(OptionalInt number, ModbusMemory memory) {
    this.number = number;
    this.memory = memory;
    answers = new ModbusAnswers(memory);
  }

  /** Whether it is on the network. */
  public boolean online() {
    return online;
  }

  /** Whether requests to this number are for it. */
  boolean is(int unit) {
    return number.isEmpty() || number.getAsInt() == unit;
  }

  /** Its memory. */
  public ModbusMemory memory() {
    return memory;
  }

  /** One of its signals: a value of its memory, or whether it is on the network. */
  public SignalLine line(String group, int index) {
    if (!group.equals(ONLINE.name())) {
      return memory.line(group, index);
    }
    return new SignalLine() {
      @Override
      public int value() {
        return online ? 1 : 0;
      }

      @Override
      public void set(int value) {
        online = value != 0;
      }
    };
  }

  /** All its signals; the same list until one changes. */
  public List<SignalGroupState> state() {
    if (!memory.state().equals(memoryState) || online != onlineTold) {
      memoryState = memory.state();
      onlineTold = online;
      List<SignalGroupState> all = new ArrayList<>(memoryState);
      all.add(new SignalGroupState(ONLINE.name(), 0, true, true, List.of(online ? 1 : 0)));
      state = List.copyOf(all);
    }
    return state;
  }

  /** Begins to exchange something with a controller, in robot time. */
  public ModbusPoint add(ModbusExchange exchange) {
    UnitPoint point = new UnitPoint(this, exchange);
    points.add(point);
    return point;
  }

  /** A controller exchanges it no more. */
  void remove(UnitPoint point) {
    points.remove(point);
  }

  /** Closes the connection of a controller and makes it again. */
  void reconnect() {
    points.forEach(UnitPoint::begin);
  }

  /** Exchanges what is due, once a frame. */
  public void step() {
    for (int i = 0; i < points.size(); i++) {
      points.get(i).step();
    }
  }

  /** Carries out a request without unit and checksum; empty for no answer. */
  public String answer(int unit, String request) {
    if (!online) {
      return "";
    }
    return is(unit) ? answers.to(request) : ModbusAnswers.refusal(request, ModbusAnswers.NO_UNIT);
  }

  /** Its side of a connection. */
  public DeviceTalk connect() {
    return new ModbusTcpTalk(this::answer);
  }
}
