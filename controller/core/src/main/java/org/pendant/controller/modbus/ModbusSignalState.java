package org.pendant.controller.modbus;

import java.util.List;
import org.pendant.controller.external.ModbusExchange;

/**
 * Modbus signal state as screens and clients see it. Immutable.
 *
 * @param name what programs call it, one {@code char} a byte
 * @param exchange what it reads and writes
 * @param updateHz how often; 0 for on demand
 * @param values bits as 0 and 1, registers 0 to 65535: what an output is set to, or what was read
 * @param valid whether the last exchange succeeded
 * @param deviceError as {@code modbus_get_error} tells it (manual 18.27)
 * @param connectionError as {@code modbus_get_error} tells it
 */
public record ModbusSignalState(
    String name,
    ModbusExchange exchange,
    int updateHz,
    List<Integer> values,
    boolean valid,
    int deviceError,
    int connectionError) {
  /** Copies the list. */
  public ModbusSignalState {
    values = List.copyOf(values);
  }
}
