package org.pendant.controller.external;

import java.util.List;

/** Modbus signal that is read and written for a controller. No method waits. */
public interface ModbusPoint {
  /** What is known now; another object only when something has changed. */
  ModbusReading reading();

  /**
   * How often the device has done what it was asked for this signal; read {@link #reading} after.
   */
  long successes();

  /**
   * Changes how often the device is asked.
   *
   * @param updateHz 0 for only when there is something to write or {@link #update} was called
   */
  void setFrequency(int updateHz);

  /**
   * Has these values written from now on, in place of reading where the kind reads where it writes.
   *
   * @param values as many as the exchange writes, bits as 0 and 1
   */
  void write(List<Integer> values);

  /** Has the device asked once, as soon as possible. */
  void update();

  /** Has the connection to the device closed and made again, with all signals that share it. */
  void reconnect();

  /** Whether who answers lives in robot time, so that no clock has to wait for it. */
  default boolean inRobotTime() {
    return false;
  }

  /** Ends it. */
  void end();
}
