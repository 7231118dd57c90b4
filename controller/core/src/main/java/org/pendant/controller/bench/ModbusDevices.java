package org.pendant.controller.bench;

import static org.pendant.controller.bench.BenchTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusConnector;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.Pending;
import org.pendant.models.time.FrameTime;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Modbus devices of a test, by their addresses; at any other one connections are refused. */
public final class ModbusDevices implements ModbusConnector {
  /** How long an answer is waited for, frames; as with devices that are there. */
  static final long ANSWER_FRAMES = FrameTime.framesFor(1);

  private final Map<ModbusAddress, ModbusDevice> byAddress = new HashMap<>();
  private final List<DevicePoint> points = new ArrayList<>();
  private final List<Sent> sent = new ArrayList<>();
  private long frame;

  ModbusDevices() {}

  /** Plays a device; one that is played already stays as it is. */
  public ModbusDevice play(ModbusAddress address) {
    return byAddress.computeIfAbsent(address, _ -> new ModbusDevice());
  }

  /** The device at an address. */
  public Optional<ModbusDevice> at(ModbusAddress address) {
    return Optional.ofNullable(byAddress.get(address));
  }

  /** The device at an address that can be connected to. */
  Optional<ModbusDevice> reached(ModbusAddress address) {
    return at(address).filter(each -> !each.refuses());
  }

  @Override
  public ModbusPoint add(ModbusExchange exchange) {
    DevicePoint point = new DevicePoint(exchange, this);
    points.add(point);
    return point;
  }

  @Override
  public Pending send(ModbusAddress address, int unit, int function, byte[] data)
      throws ScriptError {
    Optional<ModbusDevice> device = reached(address);
    if (device.isEmpty()) {
      throw new ScriptError(
          "modbus-unreached",
          at(address).isPresent()
              ? text("deviceRefuses", address)
              : text("noDevice", address, address, address));
    }
    device.get().command(unit, function, data);
    Sent request = new Sent(device.get(), frame);
    sent.add(request);
    return request;
  }

  /** What to do where there is no device at an address, for people. */
  public static String hint(ModbusAddress address) {
    return text("deviceHint", address, address);
  }

  void remove(DevicePoint point) {
    points.remove(point);
  }

  /** All signals of a device are connected to it again. */
  void reconnect(ModbusAddress address) {
    points.stream().filter(each -> each.device().equals(address)).forEach(DevicePoint::disconnect);
  }

  /** Has what is due asked and answered, once a frame. */
  public void step(long now) {
    frame = now;
    for (int i = 0; i < points.size(); i++) {
      points.get(i).step(now);
    }
    sent.removeIf(each -> each.step(now));
  }

  /** A request that a program has made of bytes. */
  private static final class Sent implements Pending {
    private final ModbusDevice device;
    private final long since;
    private boolean over;

    Sent(ModbusDevice device, long since) {
      this.device = device;
      this.since = since;
    }

    private boolean step(long now) {
      long wait = device.silent() ? ANSWER_FRAMES : Math.min(device.delayFrames(), ANSWER_FRAMES);
      over |= now - since >= wait;
      return over;
    }

    @Override
    public boolean over() {
      return over;
    }

    @Override
    public Value result() {
      return NoneValue.NONE;
    }

    @Override
    public void cancel() {
      over = true;
    }
  }
}
