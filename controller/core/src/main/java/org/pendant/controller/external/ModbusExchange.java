package org.pendant.controller.external;

/**
 * Modbus exchange: what is read from a device and written to it, again and again.
 *
 * @param device where it is
 * @param unit which one behind that address, 0 to 255
 * @param readAddress the first coil, input or register that is read, from 0
 * @param readCount how many are read, 1 to 123
 * @param writeAddress the first one that is written; that of reading unless the kind says otherwise
 * @param writeCount how many are written, 1 to 123
 * @param sequential whether the device must have answered before it is asked again
 */
public record ModbusExchange(
    ModbusAddress device,
    int unit,
    ModbusKind kind,
    int readAddress,
    int readCount,
    int writeAddress,
    int writeCount,
    boolean sequential) {
  /** Most coils or registers of one signal. */
  public static final int MOST = 123;
}
