package org.pendant.controller.builtin;

import java.util.Optional;
import org.pendant.controller.modbus.ModbusSignals;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.Value;

/**
 * Wait of a script thread until a Modbus device has answered again (manual 18.30).
 *
 * @param port empty for every port of the host
 */
record ModbusResetWait(ModbusSignals signals, String host, Optional<Integer> port) implements Wait {
  @Override
  public Optional<Value> poll(long frame) {
    return signals.connected(host, port) ? Optional.of(NoneValue.NONE) : Optional.empty();
  }

  @Override
  public boolean outside() {
    return signals.reachOutside(host, port);
  }
}
