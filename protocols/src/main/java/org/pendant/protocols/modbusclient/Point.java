package org.pendant.protocols.modbusclient;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.ModbusReading;

/**
 * Point: one signal of a device. The frame loop leaves wishes in volatile fields, the thread of the
 * device leaves what it has read; neither waits for the other.
 */
final class Point implements ModbusPoint, Asker {
  private static final int STANDARD_HZ = 10;
  private static final long SECOND_NS = TimeUnit.SECONDS.toNanos(1);

  private final ModbusExchange exchange;
  private final Device device;

  /** What is to be written; each has another number. */
  private record Write(long number, List<Integer> values) {}

  // of the frame loop
  private volatile int updateHz = STANDARD_HZ;
  private volatile Optional<Write> wanted = Optional.empty();
  private volatile boolean updateWanted;
  private long writes;

  // of the device's thread
  private volatile ModbusReading reading;
  private volatile long successes;
  private volatile long writtenNumber;
  private long succeeded;
  private boolean fresh = true;
  private boolean asking;
  private long askedNumber;
  private long nextNs;

  Point(ModbusExchange exchange, Device device) {
    this.exchange = exchange;
    this.device = device;
    reading = ModbusReading.none(exchange.readCount());
  }

  ModbusExchange exchange() {
    return exchange;
  }

  // --- for the frame loop

  @Override
  public ModbusReading reading() {
    // asked first: what is read after a reset has begun is no longer that of the old connection
    boolean again = device.reconnecting();
    ModbusReading newest = reading;
    return again ? newest.unreached(ModbusErrors.DISCONNECTED) : newest;
  }

  @Override
  public long successes() {
    return successes;
  }

  @Override
  public void setFrequency(int frequencyHz) {
    updateHz = frequencyHz;
    device.wake();
  }

  @Override
  public void write(List<Integer> values) {
    writes++;
    wanted = Optional.of(new Write(writes, values));
    device.wake();
  }

  @Override
  public void update() {
    updateWanted = true;
    device.wake();
  }

  @Override
  public void reconnect() {
    device.reconnect();
  }

  @Override
  public void end() {
    device.remove(this);
  }

  // --- for the device's thread

  /** Whether something was set that the device has not been told. */
  boolean unsent() {
    return wanted.isPresent() && wanted.get().number() != writtenNumber;
  }

  @Override
  public long dueInNs(long nowNs) {
    if (asking) {
      return NEVER;
    }
    if (device.closing()) {
      return unsent() ? 0 : NEVER;
    }
    if (fresh || updateWanted) {
      return 0;
    }
    int frequencyHz = updateHz;
    if (frequencyHz == 0) {
      return unsent() ? 0 : NEVER;
    }
    // at most a period: the frequency may have been lower when the time was set
    return Math.min(nextNs - nowNs, SECOND_NS / frequencyHz);
  }

  @Override
  public DeviceRequest ask(long nowNs) {
    schedule(nowNs);
    asking = true;
    fresh = false;
    updateWanted = false;
    Optional<Write> write = wanted;
    askedNumber = write.map(Write::number).orElse(0L);
    return write
        .map(each -> DeviceRequest.writing(exchange, each.values()))
        .orElseGet(() -> DeviceRequest.reading(exchange));
  }

  /** The next time follows the last one, not the delay: that keeps the frequency. */
  private void schedule(long nowNs) {
    int frequencyHz = updateHz;
    if (frequencyHz == 0) {
      nextNs = nowNs;
      return;
    }
    long periodNs = SECOND_NS / frequencyHz;
    long untilNs = nextNs - nowNs;
    if (fresh || untilNs < -periodNs || untilNs > periodNs) {
      nextNs = nowNs + periodNs;
    } else if (untilNs <= 0) {
      nextNs += periodNs;
    }
  }

  @Override
  public void answered(DeviceResponse answer) {
    asking = false;
    writtenNumber = askedNumber;
    switch (answer) {
      case DeviceResponse.Values(List<Integer> values) -> succeed(values);
      case DeviceResponse.Done() -> succeed(reading.values());
      case DeviceResponse.Refused(int code) ->
          publish(new ModbusReading(reading.values(), code, 0));
      case DeviceResponse.Nonsense() -> publish(reading.unreached(ModbusErrors.PROTOCOL));
    }
  }

  private void succeed(List<Integer> values) {
    publish(new ModbusReading(values, 0, 0));
    succeeded++;
    successes = succeeded;
  }

  @Override
  public void unanswered() {
    asking = false;
    publish(reading.unreached(ModbusErrors.NO_ANSWER));
  }

  @Override
  public void dropped() {
    asking = false;
    fresh = true;
  }

  /** There is no connection any more. */
  void disconnected(int error) {
    asking = false;
    fresh = true;
    publish(reading.unreached(error));
  }

  private void publish(ModbusReading now) {
    if (!now.equals(reading)) {
      reading = now;
    }
  }
}
