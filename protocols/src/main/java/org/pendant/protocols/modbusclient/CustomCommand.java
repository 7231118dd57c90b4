package org.pendant.protocols.modbusclient;

import java.util.Optional;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.Pending;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Custom command: a request that a script has made itself (manual 18.22); what is answered does not
 * matter.
 */
final class CustomCommand implements Pending, Asker {
  private final DeviceRequest question;
  private final Device device;
  private boolean asked;
  private volatile boolean over;
  private volatile Optional<String> failure = Optional.empty();

  CustomCommand(DeviceRequest question, Device device) {
    this.question = question;
    this.device = device;
  }

  @Override
  public long dueInNs(long nowNs) {
    return asked ? NEVER : 0;
  }

  @Override
  public DeviceRequest ask(long nowNs) {
    asked = true;
    return question;
  }

  @Override
  public void answered(DeviceResponse answer) {
    over = true;
  }

  @Override
  public void unanswered() {
    over = true;
  }

  @Override
  public void dropped() {
    over = true;
  }

  /** It cannot be sent. */
  void failed(int error) {
    failure = Optional.of(ModbusErrors.connection(error));
    over = true;
  }

  @Override
  public boolean over() {
    return over;
  }

  @Override
  public Value result() throws ScriptError {
    if (failure.isPresent()) {
      throw new ScriptError("modbus-unreached", device.address() + ": " + failure.get());
    }
    return NoneValue.NONE;
  }

  @Override
  public void cancel() {
    over = true;
    device.wake();
  }
}
