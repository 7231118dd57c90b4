package org.pendant.controller.external;

import java.util.Collections;
import java.util.List;

/**
 * Modbus reading: what is known of a signal. Immutable.
 *
 * @param values what was read last, bits as 0 and 1; zeros before the first time
 * @param deviceError what the device refused last with, 0 when it did what it was asked
 * @param connectionError number of an error of the connection as {@code errno.h} has them, {@link
 *     ModbusErrors#DISCONNECTED}, or 0 when the device has answered
 */
public record ModbusReading(List<Integer> values, int deviceError, int connectionError) {
  /** Copies the list. */
  public ModbusReading {
    values = List.copyOf(values);
  }

  /** Nothing is known yet of {@code count} values. */
  public static ModbusReading none(int count) {
    return new ModbusReading(Collections.nCopies(count, 0), 0, ModbusErrors.DISCONNECTED);
  }

  /** Whether the last exchange succeeded. */
  public boolean valid() {
    return deviceError == 0 && connectionError == 0;
  }

  /** The same after the device could not be reached. */
  public ModbusReading unreached(int error) {
    return error == connectionError ? this : new ModbusReading(values, deviceError, error);
  }
}
