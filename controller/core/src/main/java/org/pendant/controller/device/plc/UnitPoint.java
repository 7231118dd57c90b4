package org.pendant.controller.device.plc;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.ModbusReading;
import org.pendant.models.time.FrameTime;

/** Unit point: a signal of a controller at a device of the cell, exchanged in robot time. */
final class UnitPoint implements ModbusPoint {
  private static final int STANDARD_HZ = 10;

  private final ModbusUnit unit;
  private final ModbusExchange exchange;
  private final ModbusTable table;
  private int updateHz = STANDARD_HZ;
  private Optional<List<Integer>> written = Optional.empty();
  private boolean unsent;
  private boolean due = true;
  private int framesToGo;
  private ModbusReading reading;
  private long successes;

  UnitPoint(ModbusUnit unit, ModbusExchange exchange) {
    this.unit = unit;
    this.exchange = exchange;
    table = ModbusTable.of(exchange.kind());
    reading = ModbusReading.none(exchange.readCount());
  }

  @Override
  public ModbusReading reading() {
    return reading;
  }

  @Override
  public long successes() {
    return successes;
  }

  @Override
  public void setFrequency(int frequencyHz) {
    updateHz = frequencyHz;
    framesToGo = Math.min(framesToGo, period());
  }

  @Override
  public void write(List<Integer> values) {
    written = Optional.of(List.copyOf(values));
    unsent = true;
  }

  @Override
  public void update() {
    due = true;
  }

  @Override
  public void reconnect() {
    unit.reconnect();
  }

  /** The connection is a new one. */
  void begin() {
    reading = reading.unreached(ModbusErrors.DISCONNECTED);
    due = true;
  }

  @Override
  public void end() {
    unit.remove(this);
  }

  @Override
  public boolean inRobotTime() {
    return true;
  }

  private int period() {
    return updateHz == 0 ? 0 : Math.max(1, FrameTime.FRAMES_PER_SECOND / updateHz);
  }

  void step() {
    framesToGo--;
    boolean cyclic = updateHz > 0 && framesToGo <= 0;
    boolean asked = updateHz == 0 && unsent;
    if (due || cyclic || asked) {
      due = false;
      unsent = false;
      framesToGo = period();
      exchange();
    }
  }

  private void exchange() {
    int exception = exception();
    if (!unit.online()) {
      publish(reading.unreached(ModbusErrors.NO_ANSWER));
    } else if (exception != 0) {
      publish(new ModbusReading(reading.values(), exception, 0));
    } else {
      written.ifPresent(values -> unit.memory().set(table, exchange.writeAddress(), values));
      publish(
          new ModbusReading(
              reads()
                  ? unit.memory().get(table, exchange.readAddress(), exchange.readCount())
                  : reading.values(),
              0,
              0));
      successes++;
    }
  }

  /** What the device refuses with; 0 for nothing. */
  private int exception() {
    if (!unit.is(exchange.unit())) {
      return ModbusAnswers.NO_UNIT;
    }
    boolean there =
        (!reads() || unit.memory().holds(table, exchange.readAddress(), exchange.readCount()))
            && (written.isEmpty()
                || unit.memory().holds(table, exchange.writeAddress(), exchange.writeCount()));
    return there ? 0 : ModbusAnswers.NO_ADDRESS;
  }

  private boolean reads() {
    return written.isEmpty() || exchange.kind() == ModbusKind.READ_WRITE_REGISTERS;
  }

  private void publish(ModbusReading now) {
    if (!now.equals(reading)) {
      reading = now;
    }
  }
}
