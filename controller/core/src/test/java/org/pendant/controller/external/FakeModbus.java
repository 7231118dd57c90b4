package org.pendant.controller.external;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Modbus devices without a network: a test says what they answer. */
public final class FakeModbus implements ModbusConnector {
  private final List<FakePoint> points = new ArrayList<>();
  private final List<FakeCommand> commands = new ArrayList<>();
  private final List<String> refused = new ArrayList<>();

  /** No signal can be added at {@code host} from now on. */
  public void refuse(String host) {
    refused.add(host);
  }

  /** A signal and all that was asked of it. */
  public static final class FakePoint implements ModbusPoint {
    private final ModbusExchange exchange;
    private final List<String> wishes = new ArrayList<>();
    private ModbusReading reading;
    private long successes;

    private FakePoint(ModbusExchange exchange) {
      this.exchange = exchange;
      reading = ModbusReading.none(exchange.readCount());
    }

    public ModbusExchange exchange() {
      return exchange;
    }

    /** What was asked of it, in words. */
    public List<String> wishes() {
      return wishes;
    }

    /** The device answers with these values. */
    public void answer(Integer... values) {
      reading = new ModbusReading(List.of(values), 0, 0);
      successes++;
    }

    /** The device refuses. */
    public void refuse(int error) {
      reading = new ModbusReading(reading.values(), error, 0);
    }

    /** The device cannot be reached. */
    public void lose(int error) {
      reading = reading.unreached(error);
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
    public void setFrequency(int updateHz) {
      wishes.add(updateHz + " Hz");
    }

    @Override
    public void write(List<Integer> values) {
      wishes.add("write " + values);
    }

    @Override
    public void update() {
      wishes.add("update");
    }

    @Override
    public void reconnect() {
      wishes.add("reconnect");
      lose(ModbusErrors.DISCONNECTED);
    }

    @Override
    public void end() {
      wishes.add("end");
    }
  }

  /** A request of a program's own. */
  public static final class FakeCommand implements Pending {
    private final String text;
    private Optional<String> failure = Optional.empty();
    private boolean over;

    private FakeCommand(String text) {
      this.text = text;
    }

    /** The device has had its time. */
    public void end() {
      over = true;
    }

    /** The device cannot be reached. */
    public void fail(String why) {
      failure = Optional.of(why);
      over = true;
    }

    @Override
    public boolean over() {
      return over;
    }

    @Override
    public Value result() throws ScriptError {
      if (failure.isPresent()) {
        throw new ScriptError("modbus-unreached", failure.get());
      }
      return NoneValue.NONE;
    }

    @Override
    public void cancel() {
      over = true;
    }

    @Override
    public String toString() {
      return text;
    }
  }

  /** The signals that were added, in order. */
  public List<FakePoint> points() {
    return points;
  }

  /** The requests that were made, in order. */
  public List<FakeCommand> commands() {
    return commands;
  }

  @Override
  public ModbusPoint add(ModbusExchange exchange) throws ScriptError {
    String host = exchange.device().host();
    if (refused.contains(host)) {
      throw new ScriptError("refused", host + " is refused");
    }
    FakePoint point = new FakePoint(exchange);
    points.add(point);
    return point;
  }

  @Override
  public Pending send(ModbusAddress device, int unit, int function, byte[] data) {
    StringBuilder text = new StringBuilder(device + " " + unit + " " + function);
    for (byte each : data) {
      text.append(' ').append(each & 0xFF);
    }
    FakeCommand command = new FakeCommand(text.toString());
    commands.add(command);
    return command;
  }
}
