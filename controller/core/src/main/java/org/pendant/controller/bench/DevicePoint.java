package org.pendant.controller.bench;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.ModbusReading;
import org.pendant.models.time.FrameTime;

/**
 * Device point: a signal of a program at a {@link ModbusDevice} of its test; asked and answered in
 * robot time as one at a real device is.
 */
final class DevicePoint implements ModbusPoint {
  private static final int STANDARD_HZ = 10;

  /** How long after a refusal it is tried again. */
  private static final long RETRY_FRAMES = FrameTime.framesFor(0.1);

  private static final long NEVER = -1;

  private final ModbusExchange exchange;
  private final ModbusDevices devices;
  private ModbusReading reading;
  private long successes;
  private int updateHz = STANDARD_HZ;
  private Optional<List<Integer>> written = Optional.empty();
  private boolean unsent;
  private boolean wanted = true;
  private long nextFrame;
  private long askedFrame = NEVER;
  private boolean writing;

  DevicePoint(ModbusExchange exchange, ModbusDevices devices) {
    this.exchange = exchange;
    this.devices = devices;
    reading = ModbusReading.none(exchange.readCount());
  }

  ModbusAddress device() {
    return exchange.device();
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
    nextFrame = 0;
  }

  @Override
  public void write(List<Integer> values) {
    written = Optional.of(values);
    unsent = true;
  }

  @Override
  public void update() {
    wanted = true;
  }

  @Override
  public void reconnect() {
    devices.reconnect(device());
  }

  @Override
  public void end() {
    // what was set last still reaches the device
    if (unsent) {
      devices.reached(device()).ifPresent(this::tell);
    }
    devices.remove(this);
  }

  /** There is no connection any more; it is made again. */
  void disconnect() {
    publish(reading.unreached(ModbusErrors.DISCONNECTED));
    askedFrame = NEVER;
    nextFrame = 0;
    wanted = true;
  }

  void step(long frame) {
    Optional<ModbusDevice> device = devices.reached(device());
    if (device.isEmpty()) {
      if (askedFrame != NEVER || frame >= nextFrame) {
        publish(reading.unreached(ModbusErrors.REFUSED));
        askedFrame = NEVER;
        nextFrame = frame + RETRY_FRAMES;
        wanted = true;
      }
      return;
    }
    if (askedFrame == NEVER && due(frame)) {
      askedFrame = frame;
      nextFrame = frame + Math.max(1, FrameTime.framesFor(1.0 / Math.max(1, updateHz)));
      wanted = false;
      tell(device.get());
    }
    if (askedFrame != NEVER) {
      listen(device.get(), frame);
    }
  }

  private boolean due(long frame) {
    boolean refused = reading.connectionError() == ModbusErrors.REFUSED;
    if (wanted) {
      return !refused || frame >= nextFrame;
    }
    return updateHz == 0 ? unsent : frame >= nextFrame;
  }

  private void tell(ModbusDevice device) {
    writing = written.isPresent();
    unsent = false;
    device.ask(exchange, written.orElse(List.of()));
  }

  private void listen(ModbusDevice device, long frame) {
    long waited = frame - askedFrame;
    if (!device.silent() && waited >= device.delayFrames()) {
      answered(device);
    } else if (waited >= ModbusDevices.ANSWER_FRAMES) {
      publish(reading.unreached(ModbusErrors.NO_ANSWER));
      askedFrame = NEVER;
    }
  }

  private void answered(ModbusDevice device) {
    askedFrame = NEVER;
    OptionalInt exception = device.exception();
    if (exception.isPresent()) {
      publish(new ModbusReading(reading.values(), exception.getAsInt(), 0));
      return;
    }
    boolean reads = !writing || !exchange.kind().readWhereWritten();
    publish(new ModbusReading(reads ? device.read(exchange) : reading.values(), 0, 0));
    successes++;
  }

  private void publish(ModbusReading now) {
    if (!now.equals(reading)) {
      reading = now;
    }
  }
}
